#include "formats/json_node.hpp"

#include <algorithm>

#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

/// The parser's message without its own prefix and numbering.
std::string parse_cause(const nlohmann::json::exception& error) {
    const std::string message = error.what();
    const std::size_t at = message.find("] ");
    return "is not valid JSON: " + (at == std::string::npos ? message : message.substr(at + 2));
}

}  // namespace

void Node::expect_keys(const std::vector<std::string_view>& known) const {
    if (!value_.is_object()) fail("must be an object");
    for (const auto& [key, value] : value_.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        const auto near = nearest_word(key, std::vector<std::string>(known.begin(), known.end()));
        Node(file_, value, path_to(key)).fail("is not a known key" + (near ? "; did you mean " + *near + "?" : ""));
    }
}

std::vector<std::string> Node::keys() const {
    if (!value_.is_object()) fail("must be an object");
    std::vector<std::string> keys;
    for (const auto& [key, value] : value_.items()) {
        keys.push_back(key);
    }
    return keys;
}

Vec3 vector_of(const Node& node) {
    node.expect_size(3);
    return {node.element(0).number(), node.element(1).number(), node.element(2).number()};
}

Vec3 size_of(const Node& node) {
    if (node.size() != 2) node.expect_size(3);
    Vec3 size;
    for (std::size_t axis = 0; axis < node.size(); ++axis) {
        size[static_cast<int>(axis)] = node.element(axis).positive();
    }
    return size;
}

Box box_of(const Node& node) {
    node.expect_size(2);
    const Box box{vector_of(node.element(0)), vector_of(node.element(1))};
    const Vec3 size = box.max - box.min;
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
        node.fail("must be two corners, the second beyond the first on every axis");
    }
    return box;
}

Transform transform_of(const Node& node) {
    node.expect_size(4);
    Transform transform;
    for (std::size_t row = 0; row < 4; ++row) {
        const Node numbers = node.element(row);
        numbers.expect_size(4);
        for (std::size_t column = 0; column < 4; ++column) {
            const double value = numbers.element(column).number();
            const int r = static_cast<int>(row), c = static_cast<int>(column);
            if (row == 3) {
                if (value != (column == 3 ? 1 : 0)) numbers.fail("the last row must be 0, 0, 0, 1");
            } else if (column == 3) {
                transform.translation[r] = value;
            } else {
                transform.linear.rows[row][c] = value;
            }
        }
    }
    const double volume = determinant(transform.linear);
    if (volume == 0 || !std::isfinite(volume)) node.fail("must be invertible");
    return transform;
}

nlohmann::json parse_json(const std::string& file, std::string_view text) {
    try {
        return nlohmann::json::parse(text.begin(), text.end());
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file, "", parse_cause(error));
    }
}

}  // namespace spectralpack
