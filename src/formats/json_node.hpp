#pragma once
/// A JSON document as readers of this room walk it: every complaint names the path of the value
/// that it is about.

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spectralpack/error.hpp"
#include "spectralpack/geometry.hpp"
#include "spectralpack/names.hpp"

namespace spectralpack {

/// A value of the document with its path in it ("trays[0].height"), which every complaint names.
class Node {
  public:
    Node(const std::string& file, const nlohmann::json& value, std::string path)
        : file_(file), value_(value), path_(std::move(path)) {}

    /// The value of `key`; none where it is missing or null.
    std::optional<Node> find(std::string_view key) const {
        if (!value_.is_object()) fail("must be an object");
        const auto found = value_.find(key);
        if (found == value_.end() || found->is_null()) return std::nullopt;
        return Node(file_, *found, path_to(key));
    }

    Node at(std::string_view key) const {
        if (auto found = find(key)) return *std::move(found);
        throw InputError(file_, path_to(key), "is missing");
    }

    /// Of an object, sorted.
    std::vector<std::string> keys() const;

    std::size_t size() const {
        if (!value_.is_array()) fail("must be an array");
        return value_.size();
    }

    Node element(std::size_t i) const { return Node(file_, value_[i], path_ + "[" + std::to_string(i) + "]"); }

    /// An array of exactly this many.
    void expect_size(std::size_t wanted) const {
        if (size() != wanted) fail("must have " + std::to_string(wanted) + " elements");
    }

    template <class Visit>
    void for_each(Visit visit) const {
        const std::size_t count = size();
        for (std::size_t i = 0; i < count; ++i) {
            visit(element(i));
        }
    }

    /// Refuses an object with any other key.
    void expect_keys(const std::vector<std::string_view>& known) const;

    double number() const {
        if (!value_.is_number()) fail("must be a number");
        const double number = value_.get<double>();
        if (!std::isfinite(number)) fail("must be finite");
        return number;
    }

    double number_from(double least) const {
        const double value = number();
        if (value < least) fail("must be at least " + nlohmann::json(least).dump());
        return value;
    }

    double positive() const {
        const double value = number();
        if (!(value > 0)) fail("must be above 0");
        return value;
    }

    template <class Integer>
    Integer integer(Integer least = std::numeric_limits<Integer>::min(),
                    Integer most = std::numeric_limits<Integer>::max()) const {
        if (!value_.is_number_integer()) fail("must be a whole number");
        const bool in_range = value_.is_number_unsigned()
                                  ? std::cmp_less_equal(value_.get<std::uint64_t>(), most) &&
                                        std::cmp_greater_equal(value_.get<std::uint64_t>(), least)
                                  : std::cmp_less_equal(value_.get<std::int64_t>(), most) &&
                                        std::cmp_greater_equal(value_.get<std::int64_t>(), least);
        if (!in_range) {
            fail("must be from " + std::to_string(least) + " to " + std::to_string(most));
        }
        return value_.get<Integer>();
    }

    bool boolean() const {
        if (!value_.is_boolean()) fail("must be true or false");
        return value_.get<bool>();
    }

    std::string text() const {
        if (!value_.is_string()) fail("must be a string");
        return value_.get<std::string>();
    }

    const std::string& file() const { return file_; }
    const std::string& path() const { return path_; }

    bool is_text() const { return value_.is_string(); }

    /// The value that the word stands for.
    template <Named Enum>
    Enum one_of() const {
        if (const auto value = from_string<Enum>(text())) return *value;
        std::string known;
        for (const std::string_view word : words_of<Enum>()) {
            known += (known.empty() ? "" : ", ") + std::string(word);
        }
        fail("must be one of " + known);
    }

    [[noreturn]] void fail(const std::string& cause) const { throw InputError(file_, path_, cause); }

  private:
    std::string path_to(std::string_view key) const { return (path_.empty() ? "" : path_ + ".") + std::string(key); }

    const std::string& file_;
    const nlohmann::json& value_;
    std::string path_;
};

/// Three numbers.
Vec3 vector_of(const Node& node);

/// Three lengths above 0; two are a base, for packings without a ceiling: z is 0 then.
Vec3 size_of(const Node& node);

/// Two corners, the lower one first and no side flat.
Box box_of(const Node& node);

/// 4 x 4, row-major, the last row 0 0 0 1, invertible.
Transform transform_of(const Node& node);

/// The document in `text`. Throws InputError naming `file` where it is not JSON or an object says a key twice.
nlohmann::json parse_json(const std::string& file, std::string_view text);

}  // namespace spectralpack
