#include "formats/threemf_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "formats/mesh_parsers.hpp"
#include "formats/number_text.hpp"
#include "formats/text_lines.hpp"
#include "formats/xml_parser.hpp"

namespace spectralpack {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kProduction = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

/// Extensions that a file may require and that leave the shape of its objects alone or are
/// supported.
constexpr std::array<std::string_view, 4> kKnownExtensions{
    kCore, kProduction, "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"};

constexpr std::array<std::pair<std::string_view, double>, 6> kModelUnits{
    {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}}};

enum class Element {
    document,
    model,
    resources,
    object,
    mesh,
    vertices,
    vertex,
    triangles,
    triangle,
    components,
    component,
    build,
    item,
    ignored,
};

struct ElementRule {
    std::string_view name;
    Element element, parent;
};

constexpr std::array<ElementRule, 12> kElements{{
    {"vertex", Element::vertex, Element::vertices},  // the two that are many come first
    {"triangle", Element::triangle, Element::triangles},
    {"model", Element::model, Element::document},
    {"resources", Element::resources, Element::model},
    {"object", Element::object, Element::resources},
    {"mesh", Element::mesh, Element::object},
    {"vertices", Element::vertices, Element::mesh},
    {"triangles", Element::triangles, Element::mesh},
    {"components", Element::components, Element::object},
    {"component", Element::component, Element::components},
    {"build", Element::build, Element::model},
    {"item", Element::item, Element::build},
}};

class ModelParser : public XmlHandler {
  public:
    ModelParser(const std::string& file, const std::string& entry) : entry_(entry), parser_(file, entry, *this) {}

    ModelPart parse(const TextSource& text) {
        text([&](std::string_view piece) { parser_.feed(piece); });
        parser_.finish();
        if (!seen_model_) fail("there is no model in it");
        return std::move(part_);
    }

    void on_prefix(std::string_view prefix, std::string_view uri) override {
        prefixes_.insert_or_assign(std::string(prefix), std::string(uri));
    }

    void on_start(const XmlName& name, const XmlAttributes& attributes) override {
        const Element element = element_of(name);
        open_.push_back(element);
        switch (element) {
            case Element::vertex:
                return start_vertex(attributes);
            case Element::triangle:
                return start_triangle(attributes);
            case Element::model:
                return start_model(attributes);
            case Element::object:
                return start_object(attributes);
            case Element::component:
                return start_component(attributes);
            case Element::item:
                return start_item(attributes);
            default:
                return;
        }
    }

    void on_end() override {
        if (open_.back() == Element::object) end_object();
        open_.pop_back();
    }

  private:
    /// What is of another namespace, or not where the specification has it, is skipped with all
    /// that is in it.
    Element element_of(const XmlName& name) const {
        const Element parent = open_.empty() ? Element::document : open_.back();
        if (name.uri == kCore) {
            for (const ElementRule& rule : kElements) {
                if (rule.parent == parent && rule.name == name.local) return rule.element;
            }
        }
        if (parent == Element::document) fail("is not a 3MF model");
        return Element::ignored;
    }

    void start_model(const XmlAttributes& attributes) {
        seen_model_ = true;
        if (const char* unit = attributes.find("unit")) {
            const auto known = std::find_if(kModelUnits.begin(), kModelUnits.end(),
                                            [&](const auto& pair) { return pair.first == unit; });
            if (known == kModelUnits.end()) fail("unit " + quoted_excerpt(unit) + " is unknown");
            part_.unit = known->second;
        }
        const char* required = attributes.find("requiredextensions");
        split_words(required ? required : "", words_);
        for (const std::string_view prefix : words_) {
            const auto uri = prefixes_.find(prefix);
            if (uri == prefixes_.end()) fail("required extension " + quoted_excerpt(prefix) + " is not declared");
            if (std::find(kKnownExtensions.begin(), kKnownExtensions.end(), uri->second) == kKnownExtensions.end()) {
                fail("the file requires an extension that is not supported: " + uri->second);
            }
        }
    }

    void start_object(const XmlAttributes& attributes) {
        key_ = {entry_, required(attributes, "id")};
        if (part_.objects.contains(key_)) fail("object id " + quoted_excerpt(key_.id) + " is there twice");
        object_ = {};
        if (const char* type = attributes.find("type")) object_.type = type;
        if (const char* name = attributes.find("name")) object_.name = name;
        if (const char* number = attributes.find("partnumber")) object_.part_number = number;
    }

    void end_object() {
        for (const Triangle& triangle : object_.mesh.triangles) {
            for (const std::uint32_t vertex : triangle) {
                if (vertex >= object_.mesh.vertices.size()) {
                    fail("a triangle of object " + quoted_excerpt(key_.id) + " refers to vertex " +
                         std::to_string(vertex) + " of " + std::to_string(object_.mesh.vertices.size()));
                }
            }
        }
        if (!object_.mesh.triangles.empty() && !object_.components.empty()) {
            fail("object " + quoted_excerpt(key_.id) + " has both a mesh and components");
        }
        part_.objects.emplace(key_, std::move(object_));
    }

    void start_vertex(const XmlAttributes& attributes) {
        Vec3 vertex;
        const char* names[] = {"x", "y", "z"};
        for (int axis = 0; axis < 3; ++axis) {
            const char* text = required(attributes, names[axis]);
            const auto value = parse_number(text);
            if (!value || !std::isfinite(*value)) {
                fail("coordinate " + quoted_excerpt(text) + " is not a finite number");
            }
            vertex[axis] = *value;
        }
        if (object_.mesh.vertices.size() >= kMostVertices) fail("there are too many vertices");
        object_.mesh.vertices.push_back(vertex);
    }

    void start_triangle(const XmlAttributes& attributes) {
        Triangle triangle{};
        const char* names[] = {"v1", "v2", "v3"};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const char* text = required(attributes, names[corner]);
            const auto index = parse_integer(text);
            if (!index || *index < 0 || *index > 0xfffffffe) {
                fail("vertex index " + quoted_excerpt(text) + " is not valid");
            }
            triangle[corner] = static_cast<std::uint32_t>(*index);
        }
        if (object_.mesh.triangles.size() >= kMostTriangles) fail("there are too many triangles");
        object_.mesh.triangles.push_back(triangle);
    }

    void start_component(const XmlAttributes& attributes) {
        object_.components.push_back({referred_object(attributes), transform(attributes)});
    }

    void start_item(const XmlAttributes& attributes) {
        ModelItem item{referred_object(attributes), transform(attributes), {}, true};
        if (const char* number = attributes.find("partnumber")) item.part_number = number;
        if (const char* printable = attributes.find("printable")) {
            item.printable = std::string_view(printable) != "0" && std::string_view(printable) != "false";
        }
        part_.items.push_back(std::move(item));
    }

    ObjectKey referred_object(const XmlAttributes& attributes) const {
        ObjectKey key{entry_, required(attributes, "objectid")};
        if (const char* path = attributes.find(kProduction, "path")) key.part = path + (*path == '/' ? 1 : 0);
        return key;
    }

    /// 3MF multiplies row vectors from the left: its 12 numbers are the columns of ours, the
    /// translation last.
    Transform transform(const XmlAttributes& attributes) {
        Transform transform;
        const char* text = attributes.find("transform");
        if (!text) return transform;
        split_words(text, words_);
        if (words_.size() != 12) fail("a transform has 12 numbers, not " + std::to_string(words_.size()));
        for (std::size_t i = 0; i < 12; ++i) {
            const auto value = parse_number(words_[i]);
            if (!value || !std::isfinite(*value)) {
                fail("transform entry " + quoted_excerpt(words_[i]) + " is not a finite number");
            }
            const int row = static_cast<int>(i % 3), column = static_cast<int>(i / 3);
            (column < 3 ? transform.linear.rows[row][column] : transform.translation[row]) = *value;
        }
        const double volume = determinant(transform.linear);
        if (volume == 0 || !std::isfinite(volume)) fail("a transform cannot be inverted");
        return transform;
    }

    const char* required(const XmlAttributes& attributes, const char* name) const {
        const char* value = attributes.find(name);
        if (!value) fail("the attribute '" + std::string(name) + "' is missing");
        return value;
    }

    [[noreturn]] void fail(const std::string& cause) const { parser_.fail(cause); }

    const std::string& entry_;
    XmlParser parser_;
    std::map<std::string, std::string, std::less<>> prefixes_;
    std::vector<Element> open_;
    std::vector<std::string_view> words_;
    bool seen_model_ = false;
    ObjectKey key_;
    ModelObject object_;
    ModelPart part_;
};

}  // namespace

ModelPart parse_model_part(const std::string& file, const std::string& entry, const TextSource& text) {
    return ModelParser(file, entry).parse(text);
}

}  // namespace spectralpack
