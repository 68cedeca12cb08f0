#include "formats/json_node.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

/// The parser's message without its own prefix and numbering.
std::string parse_cause(const nlohmann::json::exception& error) {
    const std::string message = error.what();
    const std::size_t at = message.find("] ");
    return "is not valid JSON: " + (at == std::string::npos ? message : message.substr(at + 2));
}

}  // namespace

void Node::expect_keys(std::initializer_list<std::string_view> known) const {
    if (!value_.is_object()) fail("must be an object");
    for (const auto& [key, value] : value_.items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            Node(file_, value, path_.empty() ? key : path_ + "." + key).fail("is not a known key");
        }
    }
}

Vec3 vector_of(const Node& node) {
    node.expect_size(3);
    return {node.element(0).number(), node.element(1).number(), node.element(2).number()};
}

nlohmann::json parse_json(const std::string& file, std::string_view text) {
    try {
        return nlohmann::json::parse(text.begin(), text.end());
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file, "", parse_cause(error));
    }
}

}  // namespace spectralpack
