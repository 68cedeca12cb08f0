#include "api/load.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "api/fixed_copies.hpp"
#include "core/remarks.hpp"
#include "formats/mesh_reader.hpp"
#include "model/part_names.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack {
namespace {

struct InputContent {
    std::vector<LoadedMesh> meshes;
    std::vector<std::shared_ptr<const Mesh>> shared;  // the meshes, moved out
    std::optional<InputError> error;
};

/// What messages call the input.
std::string label_of(const Part& part) {
    if (!part.mesh.file().empty()) return part.mesh.file();
    return part.name.empty() ? "a mesh in memory" : part.name;
}

/// Where the mesh does not say.
std::string name_of(const Part& part) {
    if (!part.name.empty()) return part.name;
    const std::string stem = std::filesystem::path(part.mesh.file()).stem().string();
    return stem.empty() ? label_of(part) : stem;
}

InputContent content_of(const Part& part, double unit) {
    if (part.problem) throw InputError(*part.problem);
    InputContent content;
    const std::shared_ptr<const Mesh> mesh = part.mesh.mesh();
    if (mesh) {
        content.meshes.push_back(adopt_mesh(*mesh, label_of(part), unit));
        // What needed no mending stays the caller's: no second copy of it is held.
        if (content.meshes.front().repairs.empty()) {
            content.meshes.front().mesh = {};
            content.shared.push_back(mesh);
            return content;
        }
    } else {
        content.meshes = read_meshes(part.mesh.file(), unit);
    }
    for (LoadedMesh& loaded : content.meshes) {
        content.shared.push_back(std::make_shared<const Mesh>(std::move(loaded.mesh)));
    }
    return content;
}

std::string count_of(std::size_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

/// Several remarks on one file in one line.
std::string joined(const std::vector<std::string>& remarks) {
    std::string line;
    for (const std::string& remark : remarks) {
        line += (line.empty() ? "" : "; ") + remark;
    }
    return line;
}

/// Tells what was mended and what is odd, once for each cause.
void tell_remarks(const std::vector<const Part*>& inputs, const std::vector<InputContent>& contents,
                  Listener& listener) {
    std::vector<NameSource> sources;
    for (const Part* input : inputs) {
        const std::string file = input->mesh.file();
        sources.push_back({file.empty() ? label_of(*input) : std::filesystem::path(file).stem().string(), file});
    }
    const std::vector<std::string> names = names_apart(sources);
    Remarks remarks;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        for (const LoadedMesh& loaded : contents[i].meshes) {
            const std::string name = loaded.object ? names[i] + " (" + loaded.name + ")" : names[i];
            if (!loaded.repairs.empty()) {
                remarks.add(name, {"was mended: " + joined(loaded.repairs),
                                   "were mended ('spectralpack inspect' and the report say how)"});
            }
            for (const Remark& warning : loaded.warnings) {
                remarks.add(name, warning);
            }
        }
    }
    for (const std::string& text : remarks.texts()) {
        listener.on_warning(text);
    }
}

class Hash {
  public:
    Hash() : state_(XXH3_createState()) { XXH3_128bits_reset(state_); }
    ~Hash() { XXH3_freeState(state_); }
    Hash(const Hash&) = delete;
    Hash& operator=(const Hash&) = delete;

    template <class T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        XXH3_128bits_update(state_, &value, sizeof value);
    }
    void add(const std::string& text) {
        add(text.size());
        XXH3_128bits_update(state_, text.data(), text.size());
    }
    void add(const Mesh& mesh) {
        add(mesh.vertices.size());
        XXH3_128bits_update(state_, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3));
        add(mesh.triangles.size());
        XXH3_128bits_update(state_, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    }
    void add(const Vec3& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(const Transform& transform) {
        for (const Vec3& row : transform.linear.rows) {
            add(row);
        }
        add(transform.translation);
    }
    void add(const PartOrientations& orientations) {
        add(orientations.kind);
        add(orientations.yaw.value_or(-1));
        for (const SignedAxis& axis : orientations.up) {
            add(axis.axis);
            add(axis.positive);
        }
        for (const Mat3& matrix : orientations.matrices) {
            XXH3_128bits_update(state_, &matrix, sizeof matrix);
        }
    }
    /// In the bytes of the fields of PackOptions, an enum's being its position; -1 for none.
    void add(const Option& option, const OptionValue& value) {
        const bool none = std::holds_alternative<std::monostate>(value);
        switch (option.type) {
            case OptionType::flag:
                return add(std::get<bool>(value));
            case OptionType::integer:
                return add(static_cast<int>(std::get<std::int64_t>(value)));
            case OptionType::natural:
                return add(std::get<std::uint64_t>(value));
            case OptionType::number:
                return add(none ? -1 : std::get<double>(value));
            case OptionType::size:
                return add(std::get<Vec3>(value));
            case OptionType::word: {
                const auto word =
                    none ? option.words.end() : std::ranges::find(option.words, std::get<std::string>(value));
                return add(none ? -1 : static_cast<int>(word - option.words.begin()));
            }
            case OptionType::rotations:
                return add(std::get<std::string>(value));
            default:
                throw InternalError("the input hash holds no option like --" + std::string(option.name));
        }
    }
    std::string hex() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_);
        char text[33];
        std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                      static_cast<unsigned long long>(hash.low64));
        return text;
    }

  private:
    XXH3_state_t* state_;
};

/// Those that placements depend on.
std::vector<const Option*> hashed_options() {
    std::vector<const Option*> options;
    for (const Option& option : option_table()) {
        if (option.hash_place > 0) options.push_back(&option);
    }
    std::ranges::sort(options, {}, &Option::hash_place);
    return options;
}

}  // namespace

LoadedJob load_parts(const Job& job, const Workers& workers, Listener& listener) {
    // Of distinct meshes, in the order named. What is remarked on a mesh depends on its unit.
    std::map<std::tuple<std::string, const Mesh*, double>, std::size_t> index;
    std::vector<const Part*> inputs;
    const auto unit_of = [&](const Part& part) { return part.unit.value_or(job.unit); };
    const auto key = [&](const Part& part) {
        return std::tuple(part.mesh.file(), part.mesh.mesh().get(), unit_of(part));
    };
    for (const Part& part : job.parts) {
        if (index.emplace(key(part), inputs.size()).second) inputs.push_back(&part);
    }
    std::vector<InputContent> contents(inputs.size());
    constexpr std::size_t kBatch = 16;  // so that progress comes from this thread
    for (std::size_t begin = 0; begin < inputs.size(); begin += kBatch) {
        const std::size_t size = std::min(kBatch, inputs.size() - begin);
        workers.for_each(static_cast<std::int64_t>(size), [&](std::int64_t i) {
            const std::size_t input = begin + static_cast<std::size_t>(i);
            try {
                contents[input] = content_of(*inputs[input], unit_of(*inputs[input]));
            } catch (const InputError& error) {
                contents[input].error = error;
            }
        });
        listener.on_progress({Phase::load, static_cast<std::int64_t>(begin + size),
                              static_cast<std::int64_t>(inputs.size()), 0,
                              static_cast<double>(begin + size) / static_cast<double>(inputs.size())});
    }

    LoadedJob result;
    load_fixed(job, result);
    for (const InputContent& content : contents) {
        if (content.error) result.unusable.push_back(*content.error);
    }
    tell_remarks(inputs, contents, listener);
    std::vector<NameSource> names;
    const auto add = [&](const Part& source, PackedPart part, std::shared_ptr<const Mesh> mesh, double box_volume,
                         std::string problem) {
        const bool of_file = part.name == std::filesystem::path(part.mesh).stem().string();
        names.push_back({part.name, part.mesh, !of_file, !source.name.empty(), part.scale});
        part.order = source.order;
        part.id = static_cast<int>(result.parts.size());
        result.parts.push_back(std::move(part));
        result.meshes.push_back(std::move(mesh));
        result.box_volume.push_back(box_volume);
        result.problem.push_back(std::move(problem));
    };
    for (const Part& source : job.parts) {
        const InputContent& content = contents[index.at(key(source))];
        PackedPart part;
        part.mesh = source.mesh.file();
        part.count = source.count;
        part.scale = source.scale;
        part.unit = unit_of(source);
        part.gap = source.gap.value_or(job.options.gap);
        part.orientations = source.orientations;
        if (job.options.upright && part.orientations.kind == PartOrientations::Kind::any) {
            part.orientations.kind = PartOrientations::Kind::upright;
        }
        part.priority = source.priority;
        part.due = source.due;
        part.value = source.value;
        if (content.error) {
            part.name = name_of(source);
            const std::string& place = content.error->place();
            add(source, part, nullptr, 0,
                place.empty() ? content.error->cause() : place + ": " + content.error->cause());
            continue;
        }
        for (std::size_t i = 0; i < content.meshes.size(); ++i) {
            const LoadedMesh& loaded = content.meshes[i];
            if (loaded.instances > std::numeric_limits<int>::max() / source.count) {
                throw InputError(label_of(source), loaded.object ? "object " + *loaded.object : "",
                                 "comes to more copies than can be counted");
            }
            part.name = source.name.empty()          ? loaded.name
                        : content.meshes.size() == 1 ? source.name
                                                     : source.name + " " + loaded.name;
            part.object = loaded.object;
            part.item_transform = loaded.item_transform;
            part.count = source.count * loaded.instances;
            part.unit = loaded.unit.value_or(unit_of(source));
            part.repairs = loaded.repairs;
            const double mm = part.to_mm();
            part.volume = signed_volume(*content.shared[i]) * mm * mm * mm;
            add(source, part, content.shared[i], bounding_box(*content.shared[i]).volume() * mm * mm * mm, "");
        }
    }
    const std::vector<std::string> apart = names_apart(names);
    for (std::size_t i = 0; i < apart.size(); ++i) {
        result.parts[result.fixed_parts + i].name = apart[i];
    }
    if (result.unusable.size() == inputs.size() && !inputs.empty()) {
        const InputError& first = result.unusable.front();
        if (inputs.size() == 1) throw InputError(first);
        throw InputError(first.file(), first.place(),
                         first.cause() + " (and " + count_of(inputs.size() - 1, "other file") +
                             ": nothing that was named can be used)");
    }
    return result;
}

std::string input_hash(const LoadedJob& loaded, const Container& container, const PackOptions& options) {
    Hash hash;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const PackedPart& part = loaded.parts[i];
        if (!loaded.meshes[i]) continue;
        hash.add(*loaded.meshes[i]);
        hash.add(part.count);
        hash.add(part.to_mm());
        hash.add(part.gap);
        hash.add(part.priority);
        hash.add(part.due);
        hash.add(part.orientations);
    }
    for (const FixedPlacement& fixed : loaded.fixed) {
        hash.add(fixed.tray);
        hash.add(fixed.placement.part);
        hash.add(fixed.placement.transform);
    }
    hash.add(container.mesh.has_value());
    if (container.mesh) hash.add(*container.mesh->surface);
    for (const KeepOut& keep_out : container.keep_out) {
        hash.add(keep_out.box.min);
        hash.add(keep_out.box.max);
        if (keep_out.mesh) hash.add(*keep_out.mesh->surface);
    }
    hash.add(container.physical);
    PackOptions decisive = options;
    if (options.trays == 1) decisive.try_per_tray = 0;
    if (options.order != Order::random && options.restarts == 1) decisive.seed = 0;
    for (const Option* option : hashed_options()) {
        hash.add(*option, option->in_pack.get(decisive));
    }
    return hash.hex();
}

}  // namespace spectralpack
