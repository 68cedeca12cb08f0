#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/atomic_file.hpp"
#include "formats/packing_file.hpp"
#include "formats/part_orientations.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/names.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;  // keys in the order of docs/format.md

/// The folders' links are resolved, so that '..' means the same to the kernel as here; the file's
/// own name stays.
std::string relative_mesh_path(const std::string& mesh, const fs::path& folder) {
    const fs::path path(mesh), base = folder.empty() ? fs::path(".") : folder;
    std::error_code failure;
    const fs::path from = fs::weakly_canonical(fs::absolute(base), failure);
    const fs::path to = fs::weakly_canonical(fs::absolute(path).parent_path(), failure);
    const fs::path relative = (to / path.filename()).lexically_relative(from);
    return failure || relative.empty() ? mesh : relative.generic_string();
}

std::string text_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// A name may lose bytes that are not UTF-8; a path that is read again and did would name another file.
void check_utf8(const std::string& path) {
    try {
        static_cast<void>(Json(path).dump());
    } catch (const Json::type_error&) {
        throw UsageError("a packing file cannot hold the path of a mesh that is not valid UTF-8: " + text_of(path));
    }
}

Json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Json transform_json(const Transform& t) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) {
        const Vec3& linear = t.linear.rows[row];
        rows.push_back({linear.x, linear.y, linear.z, t.translation[row]});
    }
    rows.push_back({0.0, 0.0, 0.0, 1.0});
    return rows;
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json plain_json(std::monostate) { return nullptr; }
Json plain_json(const Vec3& size) { return vector_json(size); }
template <class Plain>
Json plain_json(const Plain& value) {
    return value;
}

Json value_json(const Option& option, const OptionValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
        return option.none_word.empty() ? Json(nullptr) : Json(option.none_word);
    }
    if (!option.zero_word.empty() && value == OptionValue(std::int64_t{0})) return option.zero_word;
    return std::visit([](const auto& plain) { return plain_json(plain); }, value);
}

Json options_json(const PackOptions& options) {
    Json json;
    for (const Option& option : option_table()) {
        if (option.in_pack.get) json[std::string(option.name)] = value_json(option, option.in_pack.get(options));
    }
    return json;
}

Json plan_json(const Disassembly& plan) {
    Json steps = Json::array();
    for (const RemovalStep& step : plan.steps) {
        Json path = Json::array();
        for (const Vec3& move : step.path) {
            path.push_back(vector_json(move));
        }
        steps.push_back({{"placements", step.placements}, {"path", std::move(path)}});
    }
    return {{"complete", plan.complete},
            {"unpack", to_string(plan.unpack)},
            {"steps", std::move(steps)},
            {"through_walls", plan.through_walls},
            {"interlocked", plan.interlocked}};
}

bool is_list_of_objects(const Json& value) { return value.is_array() && !value.empty() && value.front().is_object(); }

bool holds_list_of_objects(const Json& value) {
    return is_list_of_objects(value) ||
           (value.is_object() && std::any_of(value.begin(), value.end(), holds_list_of_objects));
}

/// Spread so that people and diff can read it: each part and each placement is one line.
void append_text(std::string& text, const Json& value, std::size_t indent) {
    if (!holds_list_of_objects(value)) {
        text += text_of(value);
        return;
    }
    const char* separator = value.is_object() ? "{\n" : "[\n";
    for (const auto& [key, element] : value.items()) {
        text += separator;
        text.append(indent + 1, ' ');
        if (value.is_object()) text += text_of(key) + ": ";
        append_text(text, element, indent + 1);
        separator = ",\n";
    }
    text += '\n';
    text.append(indent, ' ');
    text += value.is_object() ? '}' : ']';
}

/// Such a list, whose elements append(i) appends: made one after the other, they are never held all at once.
template <class Append>
void append_list(std::string& text, std::size_t count, std::size_t indent, const Append& append) {
    const char* separator = "[\n";
    for (std::size_t i = 0; i < count; ++i) {
        text += separator;
        text.append(indent + 1, ' ');
        append(i);
        separator = ",\n";
    }
    text += '\n';
    text.append(indent, ' ');
    text += ']';
}

/// Such an object. append_long(key, indent) appends the value of a key whose list is long, and tells that it has.
template <class AppendLong>
void append_object(std::string& text, const Json& object, std::size_t indent, const AppendLong& append_long) {
    const char* separator = "{\n";
    for (const auto& [key, element] : object.items()) {
        text += separator;
        text.append(indent + 1, ' ');
        text += text_of(key) + ": ";
        if (!append_long(key, indent + 1)) append_text(text, element, indent + 1);
        separator = ",\n";
    }
    text += '\n';
    text.append(indent, ' ');
    text += '}';
}

class PackingWriter {
  public:
    PackingWriter(const Packing& packing, const fs::path& folder) : packing_(packing) {
        std::vector<bool> placed(packing.parts.size(), false);
        for (const TrayPacking& tray : packing.trays) {
            for (const Placement& placement : tray.placements) {
                placed.at(static_cast<std::size_t>(placement.part)) = true;
            }
        }
        std::unordered_map<std::string, std::string> known;  // to ask the system once for each file
        for (std::size_t i = 0; i < packing.parts.size(); ++i) {
            const PackedPart& part = packing.parts[i];
            if (part.mesh.empty()) {
                throw UsageError("a packing file names mesh files, and " + part.name +
                                 " has none: its mesh came from memory");
            }
            const auto [path, fresh] = known.try_emplace(part.mesh);
            if (fresh) path->second = relative_mesh_path(part.mesh, folder);
            if (placed[i]) check_utf8(path->second);
            mesh_paths_.push_back(path->second);
        }
        if (packing.container.mesh) container_path_ = path_of(*packing.container.mesh, folder);
        for (const KeepOut& keep_out : packing.container.keep_out) {
            keep_out_paths_.push_back(keep_out.mesh ? path_of(*keep_out.mesh, folder) : "");
        }
    }

    std::string text() const {
        std::string text;
        const Json root = root_json();
        if (packing_.trays.empty() && packing_.unplaced.empty()) {
            append_text(text, root, 0);
            return text + "\n";
        }
        append_object(text, root, 0, [&](const std::string& key, std::size_t indent) {
            if (key == "trays" && !packing_.trays.empty()) {
                append_list(text, packing_.trays.size(), indent,
                            [&](std::size_t i) { append_tray(text, packing_.trays[i], indent + 1); });
                return true;
            }
            if (key == "unplaced" && !packing_.unplaced.empty()) {
                append_list(text, packing_.unplaced.size(), indent,
                            [&](std::size_t i) { text += text_of(unplaced_json(packing_.unplaced[i])); });
                return true;
            }
            return false;
        });
        return text + "\n";
    }

  private:
    /// Without trays and what is left over.
    Json root_json() const {
        Json root = {{"format", "spectralpack/packing"},
                     {"version", 1},
                     {"units", "mm"},
                     {"program", packing_.program},
                     {"input_hash", packing_.input_hash},
                     {"container", container_json()},
                     {"options", options_json(packing_.options)},
                     {"defaults", defaults_json()},
                     {"parts", Json::array()},
                     {"trays", Json::array()},
                     {"unplaced", Json::array()},
                     {"metrics", metrics_json()}};
        for (std::size_t i = 0; i < packing_.parts.size(); ++i) {
            root["parts"].push_back(part_json(i));
        }
        return root;
    }

    static Json unplaced_json(const Unplaced& unplaced) {
        return {{"part", unplaced.part},
                {"copy", unplaced.copy},
                {"reason", to_string(unplaced.reason)},
                {"detail", unplaced.detail}};
    }

    static std::string path_of(const StandingMesh& mesh, const fs::path& folder) {
        std::string path = relative_mesh_path(mesh.file, folder);
        check_utf8(path);
        return path;
    }

    Json container_json() const {
        const Container& container = packing_.container;
        Json json = {{"size", vector_json(container.size)},
                     {"open_height", container.open_height},
                     {"mesh", container.mesh ? Json(container_path_) : Json(nullptr)},
                     {"transform", container.mesh ? transform_json(container.mesh->transform) : Json(nullptr)},
                     {"is", container.mesh ? Json(to_string(container.is)) : Json(nullptr)},
                     {"keep_out", Json::array()},
                     {"physical", container.physical}};
        for (std::size_t i = 0; i < container.keep_out.size(); ++i) {
            const KeepOut& keep_out = container.keep_out[i];
            if (keep_out.mesh) {
                json["keep_out"].push_back(
                    {{"mesh", keep_out_paths_[i]}, {"transform", transform_json(keep_out.mesh->transform)}});
            } else {
                json["keep_out"].push_back({{"box", {vector_json(keep_out.box.min), vector_json(keep_out.box.max)}}});
            }
        }
        return json;
    }

    Json defaults_json() const {
        Json json = Json::array();
        for (const SettingsSource& source : packing_.defaults) {
            json.push_back({{"file", source.file},
                            {"profile", source.profile.empty() ? Json(nullptr) : Json(source.profile)},
                            {"options", source.options}});
        }
        return json;
    }

    Json part_json(std::size_t index) const {
        const PackedPart& part = packing_.parts[index];
        return {{"id", index},
                {"name", part.name},
                {"mesh", mesh_paths_[index]},
                {"object", or_null(part.object)},
                {"item_transform", part.item_transform ? transform_json(*part.item_transform) : Json(nullptr)},
                {"count", part.count},
                {"numbers", part.numbers.empty() ? Json(nullptr) : Json(part.numbers)},
                {"share", part.share > 0 ? Json(part.share) : Json(nullptr)},
                {"scale", part.scale},
                {"unit", part.unit},
                {"gap", part.gap},
                {"orientations", part_orientations_json(part.orientations)},
                {"priority", part.priority},
                {"due", part.due.empty() ? Json(nullptr) : Json(part.due)},
                {"order", part.order.empty() ? Json(nullptr) : Json(part.order)},
                {"value", part.value},
                {"volume", part.volume},
                {"repairs", part.repairs}};
    }

    void append_tray(std::string& text, const TrayPacking& tray, std::size_t indent) const {
        const Json json = tray_json(tray);
        if (tray.placements.empty()) return append_text(text, json, indent);
        append_object(text, json, indent, [&](const std::string& key, std::size_t inner) {
            if (key != "placements") return false;
            append_list(text, tray.placements.size(), inner,
                        [&](std::size_t i) { text += text_of(placement_json(tray.placements[i])); });
            return true;
        });
    }

    Json placement_json(const Placement& placement) const {
        const auto part = static_cast<std::size_t>(placement.part);
        Json json{{"part", placement.part},
                  {"mesh", mesh_paths_.at(part)},
                  {"copy", placement.copy},
                  {"scale", packing_.parts.at(part).scale},
                  {"orientation", placement.orientation},
                  {"fixed", placement.fixed},
                  {"transform", transform_json(placement.transform)}};
        if (placement.before) json["before"] = true;
        return json;
    }

    /// Without its placements.
    Json tray_json(const TrayPacking& tray) const {
        Json box = nullptr;
        if (!tray.bounding_box.empty()) {
            box = {vector_json(tray.bounding_box.min), vector_json(tray.bounding_box.max)};
        }
        return {{"placements", Json::array()},
                {"density", tray.density},
                {"density_bounding_box", tray.density_bounding_box},
                {"bounding_box", std::move(box)},
                {"height", tray.height},
                {"height_at", tray.height_at ? Json(to_string(*tray.height_at)) : Json(nullptr)},
                {"layers", {{"thickness", tray.layers.thickness}, {"area", tray.layers.area}}},
                {"disassembly", tray.disassembly ? plan_json(*tray.disassembly) : Json(nullptr)}};
    }

    static Json interlock_json(const InterlockCounts& counts) {
        return {{"straight", counts.straight}, {"flooded", counts.flooded}, {"groups", counts.groups},
                {"fills", counts.fills},       {"removed", counts.removed}, {"reinserted", counts.reinserted},
                {"added", counts.added}};
    }

    static Json improvement_json(const Improved& improved) {
        return {{"what", to_string(improved.what)}, {"before", improved.before}, {"now", improved.now},
                {"steps", improved.steps},          {"starts", improved.starts}, {"seconds", improved.seconds}};
    }

    Json metrics_json() const {
        const Metrics& m = packing_.metrics;
        const PhaseSeconds& s = m.seconds;
        return {{"copies", m.copies},
                {"placed", m.placed},
                {"density", m.density},
                {"min_gap", or_null(m.min_gap)},
                {"seconds",
                 {{"total", s.total},
                  {"load", s.load},
                  {"voxelize", s.voxelize},
                  {"search", s.search},
                  {"refine", s.refine},
                  {"disassemble", s.disassemble},
                  {"reinsert", s.reinsert}}},
                {"interlock", m.interlock ? interlock_json(*m.interlock) : Json(nullptr)},
                {"searches", m.searches},
                {"orders", m.orders},
                {"improvement", m.improvement ? improvement_json(*m.improvement) : Json(nullptr)},
                {"verified", m.verified},
                {"peak_memory", m.peak_memory},
                {"engine", m.engine},
                {"threads", m.threads}};
    }

    const Packing& packing_;
    std::vector<std::string> mesh_paths_, keep_out_paths_;
    std::string container_path_;
};

}  // namespace

void require_mesh_paths(const std::set<std::string>& files, const fs::path& folder) {
    for (const std::string& file : files) {
        check_utf8(relative_mesh_path(file, folder));
    }
}

std::string packing_to_json(const Packing& packing, const fs::path& folder) {
    return PackingWriter(packing, folder).text();
}

void write_packing(const Packing& packing, const fs::path& path) {
    replace_file(path, packing_to_json(packing, path.parent_path()));
}

}  // namespace spectralpack
