#include "api/load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "api/fixed_copies.hpp"
#include "core/remarks.hpp"
#include "formats/mesh_reader.hpp"
#include "model/part_names.hpp"

namespace spectralpack {
namespace {

struct InputContent {
    std::vector<LoadedMesh> meshes;
    std::vector<std::shared_ptr<const Mesh>> shared;  // the meshes, moved out
    std::vector<double> volume, box_volume;           // of each, in the file's own unit
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

InputContent content_of(const Part& part, double unit, const StopToken& stop) {
    if (part.problem) throw InputError(*part.problem);
    InputContent content;
    const std::shared_ptr<const Mesh> mesh = part.mesh.mesh();
    if (mesh) {
        content.meshes.push_back(adopt_mesh(*mesh, label_of(part), unit, stop));
        // What needed no mending stays the caller's: no second copy of it is held.
        if (content.meshes.front().repairs.empty()) {
            content.meshes.front().mesh = {};
            content.shared.push_back(mesh);
            return content;
        }
    } else {
        content.meshes = read_meshes(part.mesh.file(), unit, stop);
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
                contents[input] = content_of(*inputs[input], unit_of(*inputs[input]), workers.stop());
                for (const std::shared_ptr<const Mesh>& mesh : contents[input].shared) {
                    workers.check();
                    contents[input].volume.push_back(signed_volume(*mesh));
                    contents[input].box_volume.push_back(bounding_box(*mesh).volume());
                }
            } catch (const InputError& error) {
                contents[input].error = error;
            }
        });
        listener.on_progress({Phase::load, static_cast<std::int64_t>(begin + size),
                              static_cast<std::int64_t>(inputs.size()), 0,
                              static_cast<double>(begin + size) / static_cast<double>(inputs.size())});
    }

    LoadedJob result;
    load_fixed(job, result, workers.stop());
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
        bool found = !source.object;
        for (std::size_t i = 0; i < content.meshes.size(); ++i) {
            const LoadedMesh& loaded = content.meshes[i];
            // The same object in several orientations is there more than once: the first is packed.
            if (source.object && (found || loaded.object != source.object)) continue;
            found = true;
            const int instances = source.object ? 1 : loaded.instances;
            if (instances > std::numeric_limits<int>::max() / source.count) {
                throw InputError(label_of(source), loaded.object ? "object " + *loaded.object : "",
                                 "comes to more copies than can be counted");
            }
            part.name = source.name.empty()                           ? loaded.name
                        : source.object || content.meshes.size() == 1 ? source.name
                                                                      : source.name + " " + loaded.name;
            part.object = loaded.object;
            part.item_transform = loaded.item_transform;
            part.count = source.count * instances;
            part.unit = loaded.unit.value_or(unit_of(source));
            part.repairs = loaded.repairs;
            const double mm = part.to_mm();
            part.volume = content.volume[i] * mm * mm * mm;
            add(source, part, content.shared[i], content.box_volume[i] * mm * mm * mm, "");
        }
        if (!found) {
            result.unusable.emplace_back(label_of(source), "object " + *source.object, "it has no such object");
            part.name = name_of(source);
            add(source, part, nullptr, 0, "object " + *source.object + ": it has no such object");
        }
    }
    const std::vector<std::string> apart = names_apart(names);
    for (std::size_t i = 0; i < apart.size(); ++i) {
        result.parts[result.fixed_parts + i].name = apart[i];
    }
    result.standing.resize(result.parts.size());
    if (job.keep) keep_copies(*job.keep, result, listener);
    const auto own = result.meshes.begin() + static_cast<std::ptrdiff_t>(result.fixed_parts);
    const bool none_usable = std::all_of(own, result.meshes.end(), [](const auto& mesh) { return mesh == nullptr; });
    if (none_usable && !result.unusable.empty()) {
        const InputError& first = result.unusable.front();
        if (inputs.size() == 1) throw InputError(first);
        throw InputError(first.file(), first.place(),
                         first.cause() + " (and " + count_of(inputs.size() - 1, "other file") +
                             ": nothing that was named can be used)");
    }
    return result;
}

}  // namespace spectralpack
