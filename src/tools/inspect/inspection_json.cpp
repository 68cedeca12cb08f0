#include "formats/json_text.hpp"
#include "spectralpack/tools/inspect.hpp"

namespace spectralpack::tools {
namespace {

std::string flag(bool value) { return value ? "true" : "false"; }

std::string number(std::size_t value) { return std::to_string(value); }

std::string vector_json(const Vec3& v) {
    return "[" + json_number(v.x) + ", " + json_number(v.y) + ", " + json_number(v.z) + "]";
}

std::string place_json(const std::optional<Vec3>& place) { return place ? vector_json(*place) : "null"; }

/// "[a, b]" of texts that are JSON already.
template <class List, class Text>
std::string list_json(const List& list, const Text& text) {
    std::string joined;
    for (const auto& item : list) {
        joined += (joined.empty() ? "" : ", ") + text(item);
    }
    return "[" + joined + "]";
}

std::string object_json(const InspectedObject& object) {
    const MeshFigures& f = object.figures;
    const auto hole = [](const BorderLoop& loop) {
        return "{\"place\": " + vector_json(loop.place) + ", \"length\": " + json_number(loop.length) +
               ", \"edges\": " + number(loop.edges) + "}";
    };
    return "{\"name\": " + json_string(object.name) +
           ", \"object\": " + (object.object ? json_string(*object.object) : "null") +
           ", \"instances\": " + std::to_string(object.instances) + ", \"unit\": " + json_number(object.unit) +
           ", \"unit_known\": " + flag(object.unit_known) + ", \"size\": " + vector_json(f.box.size()) +
           ", \"box\": [" + vector_json(f.box.min) + ", " + vector_json(f.box.max) + "]" +
           ", \"volume\": " + json_number(f.volume) + ", \"area\": " + json_number(f.area) +
           ", \"triangles\": " + number(f.triangles) + ", \"vertices\": " + number(f.vertices) +
           ", \"shells\": " + number(f.shells) + ", \"watertight\": " + flag(f.watertight()) +
           ", \"border\": {\"edges\": " + number(f.edges.border) + ", \"loops\": " + number(f.border_loops) +
           ", \"longest\": " + list_json(f.holes, hole) +
           "}, \"orientation\": " + json_string(std::string(to_string(object.facing))) +
           ", \"misdirected\": {\"edges\": " + number(f.edges.misdirected) +
           ", \"place\": " + place_json(f.misdirected_place) +
           "}, \"non_manifold\": {\"edges\": " + number(f.edges.crowded) +
           ", \"place\": " + place_json(f.crowded_place) +
           "}, \"self_intersections\": {\"pairs\": " + std::to_string(f.crossings.pairs) +
           ", \"complete\": " + flag(f.crossings.complete) + ", \"place\": " + place_json(f.crossings.place) +
           "}, \"duplicates\": " + number(f.duplicates) +
           ", \"unit_hint\": " + (object.unit_hint ? json_string(*object.unit_hint) : "null") +
           ", \"repairs\": " + list_json(object.repairs, json_string) +
           ", \"warnings\": " + list_json(object.warnings, json_string) + "}";
}

std::string file_json(const InspectedFile& file) {
    std::string text = "{\"file\": " + json_string(file.file) + ", \"usable\": " + flag(!file.unusable);
    if (file.unusable) {
        return text + ", \"place\": " + json_string(file.unusable->place()) +
               ", \"cause\": " + json_string(file.unusable->cause()) + "}";
    }
    return text + ", \"objects\": " + list_json(file.objects, object_json) + "}";
}

}  // namespace

std::string inspection_json(const std::vector<InspectedFile>& files) {
    std::size_t unusable = 0;
    std::string text;
    for (const InspectedFile& file : files) {
        unusable += file.unusable ? 1 : 0;
        text += (text.empty() ? "\n" : ",\n") + file_json(file);
    }
    return "{\"usable\": " + number(files.size() - unusable) + ", \"unusable\": " + number(unusable) +
           ", \"files\": [" + text + "\n]}";
}

}  // namespace spectralpack::tools
