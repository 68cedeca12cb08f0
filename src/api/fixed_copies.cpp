#include "api/fixed_copies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "api/check_options.hpp"
#include "api/plan.hpp"
#include "formats/mesh_reader.hpp"
#include "verify/check.hpp"

namespace spectralpack {
namespace {

/// A scale this near to the file's own size is taken for it.
constexpr double kSameScale = 1e-9;

constexpr double kNotRigid = 1e-6;

void add_part(LoadedJob& loaded, PackedPart part, std::shared_ptr<const Mesh> mesh) {
    part.id = static_cast<int>(loaded.parts.size());
    loaded.box_volume.push_back(bounding_box(*mesh).volume() * std::pow(part.to_mm(), 3));
    loaded.parts.push_back(std::move(part));
    loaded.meshes.push_back(std::move(mesh));
    loaded.problem.emplace_back();
}

/// A build to top up: its copies keep part, number, tray, orientation and transform, and are counted from 0.
void add_onto(const Scene& onto, LoadedJob& loaded) {
    const Packing& packing = onto.packing;
    const CopyNumbers numbers(packing.parts);
    std::vector<bool> placed(packing.parts.size(), false);
    for (const TrayPacking& tray : packing.trays) {
        for (const Placement& placement : tray.placements) {
            placed[static_cast<std::size_t>(placement.part)] = true;
        }
    }
    std::vector<std::size_t> index(packing.parts.size());
    for (std::size_t i = 0; i < packing.parts.size(); ++i) {
        if (!placed[i]) continue;
        index[i] = loaded.parts.size();
        PackedPart part = packing.parts[i];
        part.count = 0;
        part.numbers.clear();
        add_part(loaded, std::move(part), onto.meshes[i]);
    }
    for (std::size_t tray = 0; tray < packing.trays.size(); ++tray) {
        for (const Placement& placement : packing.trays[tray].placements) {
            const std::size_t i = index[static_cast<std::size_t>(placement.part)];
            PackedPart& part = loaded.parts[i];
            part.numbers.push_back(numbers.of(placement));
            Placement fixed = placement;
            fixed.part = static_cast<int>(i);
            fixed.copy = part.count++;
            fixed.before = !placement.fixed || placement.before;  // what a job has fixed stays for good
            fixed.fixed = true;
            loaded.fixed.push_back({static_cast<int>(tray), fixed});
        }
    }
}

/// Millimetres per unit of the mesh, which must be all that the matrix does besides turning.
double scale_of(const MeshSource& source, const Mat3& linear) {
    const double volume = determinant(linear);
    const double scale = std::cbrt(volume);
    const Mat3 product = transposed(linear) * linear;
    double deviation = 0;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double unit = row == column ? 1 : 0;
            deviation = std::max(deviation, std::abs(product.rows[row][column] / (scale * scale) - unit));
        }
    }
    if (!(volume > 0) || !(deviation <= kNotRigid)) {
        throw InputError(
            source.file, source.place,
            volume < 0 ? "its transform is a mirror image" : "its transform is not a rotation times a scale");
    }
    return scale;
}

void add_fixed(const Job& job, LoadedJob& loaded, const StopToken& stop) {
    std::map<std::string, std::vector<LoadedMesh>> files;
    std::map<std::tuple<std::string, double, double, std::string>, std::size_t> index;
    for (const FixedSource& source : job.fixed) {
        const double unit = source.mesh.unit.value_or(job.unit);
        const auto [file, fresh] = files.try_emplace(source.mesh.file);
        if (fresh) file->second = read_meshes(source.mesh.file, unit, stop);
        if (file->second.size() != 1) {
            throw InputError(source.mesh.file, source.mesh.place,
                             "holds " + std::to_string(file->second.size()) + " objects; a fixed copy is one");
        }
        const LoadedMesh& mesh = file->second.front();
        PackedPart part;
        part.name = source.name.value_or(mesh.name);
        part.mesh = source.mesh.file;
        part.object = mesh.object;
        part.item_transform = mesh.item_transform;
        part.count = 0;
        part.unit = mesh.unit.value_or(unit);
        part.gap = source.gap.value_or(job.options.gap);
        part.repairs = mesh.repairs;
        const Transform transform = source.mesh.transform.value_or(Transform{part.unit * Mat3{}, {}});
        part.scale = scale_of(source.mesh, transform.linear) / part.unit;
        if (std::abs(part.scale - 1) <= kSameScale) part.scale = 1;
        part.volume = signed_volume(mesh.mesh) * std::pow(part.to_mm(), 3);
        const auto [at, is_new] = index.try_emplace({part.mesh, part.scale, part.gap, part.name}, loaded.parts.size());
        if (is_new) add_part(loaded, std::move(part), std::make_shared<const Mesh>(mesh.mesh));
        Placement placement;
        placement.part = static_cast<int>(at->second);
        placement.copy = loaded.parts[at->second].count++;
        placement.fixed = true;
        placement.transform = transform;
        loaded.fixed.push_back({0, placement});
    }
}

/// The job's parts that are the same as one of a packing: by mesh and size, those of its name first.
std::vector<std::size_t> parts_like(const PackedPart& part, const Mesh* mesh, const LoadedJob& loaded) {
    std::vector<std::size_t> like;
    for (std::size_t i = loaded.fixed_parts; mesh && i < loaded.parts.size(); ++i) {
        const Mesh* own = loaded.meshes[i].get();
        if (!own || loaded.parts[i].to_mm() != part.to_mm() || own->vertices != mesh->vertices ||
            own->triangles != mesh->triangles) {
            continue;
        }
        like.insert(loaded.parts[i].name == part.name ? like.begin() : like.end(), i);
    }
    return like;
}

/// A copy of one of `parts` that does not stand yet: of its own number where that is free.
std::optional<Copy> free_copy(const Placement& placement, const std::vector<std::size_t>& parts,
                              const LoadedJob& loaded) {
    for (const std::size_t i : parts) {
        const int count = loaded.parts[i].count;
        const std::set<int>& standing = loaded.standing[i];
        if (placement.copy < count && !standing.contains(placement.copy))
            return Copy{static_cast<int>(i), placement.copy};
        for (int number = 0; number < count; ++number) {
            if (!standing.contains(number)) return Copy{static_cast<int>(i), number};
        }
    }
    return std::nullopt;
}

}  // namespace

void load_fixed(const Job& job, LoadedJob& loaded, const StopToken& stop) {
    if (job.onto) add_onto(*job.onto, loaded);
    add_fixed(job, loaded, stop);
    loaded.fixed_parts = loaded.parts.size();
}

void keep_copies(const Scene& keep, LoadedJob& loaded, Listener& listener) {
    std::vector<std::vector<std::size_t>> same(keep.packing.parts.size());
    for (std::size_t i = 0; i < same.size(); ++i) {
        same[i] = parts_like(keep.packing.parts[i], keep.meshes[i].get(), loaded);
    }
    std::int64_t left_out = 0;
    for (std::size_t tray = 0; tray < keep.packing.trays.size(); ++tray) {
        for (const Placement& placement : keep.packing.trays[tray].placements) {
            if (placement.fixed && !placement.before) continue;  // the job says itself what it fixes
            const std::optional<Copy> copy =
                free_copy(placement, same[static_cast<std::size_t>(placement.part)], loaded);
            if (!copy) {
                ++left_out;
                continue;
            }
            Placement fixed = placement;
            fixed.part = copy->part;
            fixed.copy = copy->number;
            fixed.fixed = fixed.before = true;
            loaded.standing[static_cast<std::size_t>(copy->part)].insert(copy->number);
            loaded.fixed.push_back({static_cast<int>(tray), fixed});
        }
    }
    if (left_out > 0) {
        listener.on_warning(std::to_string(left_out) + (left_out == 1 ? " copy" : " copies") +
                            " of the build that is kept are no longer asked for, and left out");
    }
}

std::vector<TrayPacking> fixed_trays(const LoadedJob& loaded) {
    std::vector<TrayPacking> trays;
    for (const FixedPlacement& fixed : loaded.fixed) {
        const auto tray = static_cast<std::size_t>(fixed.tray);
        if (trays.size() <= tray) trays.resize(tray + 1);
        trays[tray].placements.push_back(fixed.placement);
    }
    return trays;
}

void require_sound(const LoadedJob& loaded, const Container& container, const PackOptions& options,
                   const Workers& workers, Listener& listener, const StopToken& stop) {
    if (loaded.fixed.empty()) return;
    Packing packing;
    packing.container = container;
    packing.container.open_height = is_open(options);
    packing.options = options;
    packing.parts = loaded.parts;
    // Where none of the others stands, none of them is to be missed.
    const bool kept = std::ranges::any_of(loaded.standing, [](const std::set<int>& copies) { return !copies.empty(); });
    if (!kept) packing.parts.resize(loaded.fixed_parts);
    packing.trays = fixed_trays(loaded);
    Listener quiet;  // of a part's mesh that is not closed it has been told when the build was packed
    const CheckReport report = check_packing(packing, loaded.meshes, workers, quiet, stop);
    std::size_t faults = 0, near = 0;
    const Finding* first = nullptr;
    for (const Finding& finding : report.findings) {
        switch (finding.kind) {
            case FindingKind::outside:
            case FindingKind::overlap:
            case FindingKind::nested:
            case FindingKind::transform:
                if (!first) first = &finding;
                ++faults;
                break;
            case FindingKind::gap:
                ++near;
                break;
            default:
                break;  // figures, which have not been measured
        }
    }
    if (first) {
        throw Error(ErrorKind::input, "the fixed copies cannot stand as they are: " + first->message +
                                          (faults > 1 ? " (and " + std::to_string(faults - 1) + " more)" : ""));
    }
    if (near > 0) {
        listener.on_warning(std::to_string(near) + (near == 1 ? " pair" : " pairs") +
                            " of fixed copies stand nearer to each other than their gap; they are left so");
    }
}

}  // namespace spectralpack
