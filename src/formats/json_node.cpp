#include "formats/json_node.hpp"

#include <algorithm>
#include <set>

#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

/// The parser's message without its own prefix and numbering.
std::string parse_cause(const nlohmann::json::exception& error) {
    const std::string message = error.what();
    const std::size_t at = message.find("] ");
    return "is not valid JSON: " + (at == std::string::npos ? message : message.substr(at + 2));
}

/// Follows the parser through a document and refuses a key that an object says twice: the parser would keep the last.
class KeysOnce {
  public:
    explicit KeysOnce(const std::string& file) : file_(file) {}

    void see(nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
        using Event = nlohmann::json::parse_event_t;
        switch (event) {
            case Event::object_start:
            case Event::array_start:
                begin_value();
                levels_.push_back({event == Event::array_start});
                break;
            case Event::object_end:
            case Event::array_end:
                levels_.pop_back();
                break;
            case Event::key:
                take(parsed.get_ref<const std::string&>());
                break;
            case Event::value:
                begin_value();
                break;
        }
    }

  private:
    struct Level {
        bool array = false;
        std::size_t elements = 0;  ///< of an array, so far
        std::string key = {};      ///< of an object: the one being read
        std::set<std::string> keys = {};
    };

    void begin_value() {
        if (!levels_.empty() && levels_.back().array) ++levels_.back().elements;
    }

    void take(const std::string& key) {
        Level& object = levels_.back();
        object.key = key;
        if (!object.keys.insert(key).second) throw InputError(file_, path(), "is said twice");
    }

    std::string path() const {
        std::string path;
        for (const Level& level : levels_) {
            if (level.array) {
                path += "[" + std::to_string(level.elements - 1) + "]";
            } else {
                path += (path.empty() ? "" : ".") + level.key;
            }
        }
        return path;
    }

    const std::string& file_;
    std::vector<Level> levels_;  ///< the outermost first
};

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
    KeysOnce keys(file);
    const auto follow = [&keys](int, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
        keys.see(event, parsed);
        return true;
    };
    try {
        return nlohmann::json::parse(text.begin(), text.end(), follow);
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file, "", parse_cause(error));
    }
}

}  // namespace spectralpack
