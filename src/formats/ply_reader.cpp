/// Stanford PLY: ASCII and binary of both byte orders. Of the elements, 'vertex' (x, y, z) and
/// 'face' (the list vertex_indices or vertex_index) are read; all else is stepped over.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "core/stopped.hpp"
#include "formats/mesh_parsers.hpp"
#include "formats/number_text.hpp"
#include "formats/polygon_faces.hpp"
#include "formats/text_lines.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::pair<std::string_view, Scalar> kScalars[] = {
    {"char", Scalar::int8},      {"int8", Scalar::int8},       {"uchar", Scalar::uint8},
    {"uint8", Scalar::uint8},    {"short", Scalar::int16},     {"int16", Scalar::int16},
    {"ushort", Scalar::uint16},  {"uint16", Scalar::uint16},   {"int", Scalar::int32},
    {"int32", Scalar::int32},    {"uint", Scalar::uint32},     {"uint32", Scalar::uint32},
    {"float", Scalar::float32},  {"float32", Scalar::float32}, {"double", Scalar::float64},
    {"float64", Scalar::float64}};

constexpr std::size_t size_of(Scalar type) {
    switch (type) {
        case Scalar::int8:
        case Scalar::uint8:
            return 1;
        case Scalar::int16:
        case Scalar::uint16:
            return 2;
        case Scalar::int32:
        case Scalar::uint32:
        case Scalar::float32:
            return 4;
        case Scalar::float64:
            return 8;
    }
    return 0;
}

struct Property {
    std::string_view name;
    Scalar type = Scalar::int8;
    std::optional<Scalar> count_type;  ///< of a list
};

struct PlyElement {
    std::string_view name;
    std::int64_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

/// The values of the body one by one, whatever the encoding. All types fit a double.
class Values {
  public:
    Values(const MeshBytes& source, Encoding encoding, std::string_view body, int first_line)
        : source_(source), encoding_(encoding), body_(body), line_(first_line), poll_(source.stop) {}

    double next(Scalar type) {
        poll_.step();
        return encoding_ == Encoding::ascii ? next_word() : next_bytes(type);
    }

    /// Bytes that are left; each value takes at least one.
    std::size_t left() const { return body_.size() - at_; }

    /// Least bytes that a value of this type takes.
    std::size_t least_size(Scalar type) const { return encoding_ == Encoding::ascii ? 1 : size_of(type); }

    [[noreturn]] void fail(const std::string& cause) const {
        throw InputError(source_.file,
                         encoding_ == Encoding::ascii ? "line " + std::to_string(line_)
                                                      : "byte " + std::to_string(source_.bytes.size() - left()),
                         cause);
    }

  private:
    double next_word() {
        while (at_ < body_.size() && static_cast<unsigned char>(body_[at_]) <= ' ') {
            if (body_[at_++] == '\n') ++line_;
        }
        const std::size_t begin = at_;
        while (at_ < body_.size() && static_cast<unsigned char>(body_[at_]) > ' ') {
            ++at_;
        }
        const std::string_view word = body_.substr(begin, at_ - begin);
        if (word.empty()) fail("the file ends before all its elements");
        const auto value = parse_number(word);
        if (!value) fail(quoted_excerpt(word) + " is not a number");
        return *value;
    }

    double next_bytes(Scalar type) {
        const std::size_t size = size_of(type);
        if (left() < size) fail("the file ends before all its elements");
        std::array<char, 8> bytes{};
        std::memcpy(bytes.data(), body_.data() + at_, size);
        at_ += size;
        if ((encoding_ == Encoding::big_endian) == (std::endian::native == std::endian::little)) {
            std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        }
        switch (type) {
            case Scalar::int8:
                return as<std::int8_t>(bytes);
            case Scalar::uint8:
                return as<std::uint8_t>(bytes);
            case Scalar::int16:
                return as<std::int16_t>(bytes);
            case Scalar::uint16:
                return as<std::uint16_t>(bytes);
            case Scalar::int32:
                return as<std::int32_t>(bytes);
            case Scalar::uint32:
                return as<std::uint32_t>(bytes);
            case Scalar::float32:
                return as<float>(bytes);
            case Scalar::float64:
                return as<double>(bytes);
        }
        return 0;
    }

    template <class T>
    static double as(const std::array<char, 8>& bytes) {
        T value;
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    }

    const MeshBytes& source_;
    Encoding encoding_;
    std::string_view body_;
    std::size_t at_ = 0;
    int line_;
    StopPoll poll_;
};

class PlyParser {
  public:
    explicit PlyParser(const MeshBytes& source) : source_(source), lines_(source.bytes, source.stop) {}

    LoadedMesh parse() {
        parse_header();
        Values values(source_, encoding_, lines_.rest(), lines_.number() + 1);
        for (const PlyElement& element : elements_) {
            check_count(values, element);
            if (element.name == "vertex") {
                read_vertices(values, element);
            } else if (element.name == "face") {
                read_faces(values, element);
            } else {
                for (std::int64_t i = 0; i < element.count; ++i) {
                    for (const Property& property : element.properties) {
                        read_property(values, property);
                    }
                }
            }
        }
        LoadedMesh loaded;
        loaded.mesh.triangles = faces_.triangles(
            vertices_,
            [&](std::uint32_t face, const std::string& cause) {
                throw InputError(source_.file, "face " + std::to_string(face), cause);
            },
            source_.stop);
        loaded.mesh.vertices = std::move(vertices_);
        return loaded;
    }

  private:
    void next_header_line() {
        do {
            if (!lines_.next()) lines_.fail(source_.file, "the file ends in its header");
            split_words(lines_.line(), words_);
        } while (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info");
    }

    void parse_header() {
        next_header_line();
        if (words_[0] != "ply") lines_.fail(source_.file, "is not a PLY file: it does not start with 'ply'");
        next_header_line();
        if (words_.size() < 2 || words_[0] != "format") lines_.fail(source_.file, "expected 'format'");
        if (words_[1] == "ascii") {
            encoding_ = Encoding::ascii;
        } else if (words_[1] == "binary_little_endian") {
            encoding_ = Encoding::little_endian;
        } else if (words_[1] == "binary_big_endian") {
            encoding_ = Encoding::big_endian;
        } else {
            lines_.fail(source_.file, "format " + quoted_excerpt(words_[1]) + " is unknown");
        }
        for (;;) {
            next_header_line();
            if (words_[0] == "end_header") return;
            if (words_[0] == "element") {
                parse_element();
            } else if (words_[0] == "property" && !elements_.empty()) {
                parse_property();
            } else {
                lines_.fail(source_.file,
                            "expected 'element', 'property' or 'end_header', found " + quoted_excerpt(words_[0]));
            }
        }
    }

    void parse_element() {
        const auto count = words_.size() == 3 ? parse_integer(words_[2]) : std::nullopt;
        if (!count || *count < 0) lines_.fail(source_.file, "an element has a name and a number");
        elements_.push_back({words_[1], *count, {}});
    }

    void parse_property() {
        Property property;
        const bool list = words_.size() == 5 && words_[1] == "list";
        if (!list && words_.size() != 3) lines_.fail(source_.file, "a property has a type and a name");
        if (list) property.count_type = scalar(words_[2]);
        property.type = scalar(words_[list ? 3 : 1]);
        property.name = words_.back();
        elements_.back().properties.push_back(property);
    }

    Scalar scalar(std::string_view name) const {
        for (const auto& [known, type] : kScalars) {
            if (known == name) return type;
        }
        lines_.fail(source_.file, "type " + quoted_excerpt(name) + " is unknown");
    }

    /// A promise the bytes cannot keep is refused before anything is reserved by it.
    void check_count(const Values& values, const PlyElement& element) const {
        std::size_t least = 0;
        for (const Property& property : element.properties) {
            least += values.least_size(property.count_type.value_or(property.type));
        }
        const std::size_t most = least == 0 ? 0 : values.left() / least;
        if (std::cmp_greater(element.count, most)) {
            values.fail("the header promises " + std::to_string(element.count) + " times '" +
                        std::string(element.name) + "', the file has room for " + std::to_string(most));
        }
        if (std::cmp_greater(element.count, kMostVertices)) values.fail("there are too many elements");
    }

    /// Reads a property; of a list, into list_.
    double read_property(Values& values, const Property& property) {
        if (!property.count_type) return values.next(property.type);
        const double count = values.next(*property.count_type);
        if (!(count >= 0 && count <= static_cast<double>(values.left())) || count != std::floor(count)) {
            values.fail("a list promises more values than the file has");
        }
        list_.clear();
        for (auto i = static_cast<std::size_t>(count); i > 0; --i) {
            list_.push_back(values.next(property.type));
        }
        return 0;
    }

    void read_vertices(Values& values, const PlyElement& element) {
        std::vector<int> axes;  // which coordinate a property is, or -1
        int found = 0;
        for (const Property& property : element.properties) {
            const std::size_t axis =
                property.name.size() == 1 ? std::string_view("xyz").find(property.name) : std::string_view::npos;
            const bool coordinate = axis != std::string_view::npos && !property.count_type;
            axes.push_back(coordinate ? static_cast<int>(axis) : -1);
            found |= coordinate ? 1 << axis : 0;
        }
        if (found != 7) values.fail("the vertices have no properties x, y and z");
        vertices_.reserve(vertices_.size() + static_cast<std::size_t>(element.count));
        for (std::int64_t i = 0; i < element.count; ++i) {
            Vec3 vertex;
            for (std::size_t k = 0; k < axes.size(); ++k) {
                const double value = read_property(values, element.properties[k]);
                if (axes[k] < 0) continue;
                if (!std::isfinite(value)) {
                    values.fail("vertex " + std::to_string(i + 1) + ": a coordinate is not a finite number");
                }
                vertex[axes[k]] = value;
            }
            vertices_.push_back(vertex);
        }
    }

    void read_faces(Values& values, const PlyElement& element) {
        std::vector<std::int64_t> corners;
        for (std::int64_t i = 0; i < element.count; ++i) {
            for (const Property& property : element.properties) {
                read_property(values, property);
                if (!property.count_type || (property.name != "vertex_indices" && property.name != "vertex_index")) {
                    continue;
                }
                corners.clear();
                for (const double index : list_) {
                    if (!(index >= 0 && index <= 0xffffffffu) || index != std::floor(index)) {
                        values.fail("a vertex index of a face is not valid");
                    }
                    corners.push_back(static_cast<std::int64_t>(index));
                }
                faces_.add(corners, static_cast<std::uint32_t>(i + 1));
            }
        }
    }

    const MeshBytes& source_;
    TextLines lines_;
    std::vector<std::string_view> words_;
    Encoding encoding_ = Encoding::ascii;
    std::vector<PlyElement> elements_;
    std::vector<double> list_;
    std::vector<Vec3> vertices_;
    PolygonFaces faces_;
};

}  // namespace

std::vector<ParsedMesh> parse_ply(const MeshBytes& source) { return {{PlyParser(source).parse()}}; }

}  // namespace spectralpack
