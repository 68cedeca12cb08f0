#include "api/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "api/check_options.hpp"
#include "api/engine_factory.hpp"
#include "api/memory_plan.hpp"
#include "api/too_large.hpp"
#include "geometry/minimum_box.hpp"
#include "packing/tray/shape_store.hpp"
#include "spectralpack/geometry.hpp"
#include "spectralpack/orientations.hpp"
#include "voxel/axis_turn.hpp"

namespace spectralpack {
namespace {

/// Turns of a cube.
constexpr std::size_t kRightAngles = 24;

/// A tray overflows where the copies' boxes come to more than so many times its volume (appendix A.2).
constexpr double kOverflow = 1.2;

int voxels_in(double length, double dx) {
    const double voxels = std::ceil(length / dx - 1e-9);
    if (voxels > 1e9) throw ResourceError("--voxel is too fine: over a billion voxels along one axis");
    return std::max(1, static_cast<int>(voxels));
}

/// Sizes of a part for an estimate: one if its orientations are turns by right angles, else some that are spread over
/// them, as a part turned otherwise has a larger box.
std::vector<Vec3> sample_sizes(const Mesh& mesh, double to_mm, const std::vector<Mat3>& orientations) {
    constexpr std::size_t kSamples = 7;
    const std::size_t samples = orientations.size() > kRightAngles ? kSamples : 1;
    std::vector<Vec3> sizes;
    for (std::size_t k = 0; k < samples; ++k) {
        sizes.push_back(turned_size(mesh, orientations[k * orientations.size() / samples], to_mm));
    }
    return sizes;
}

/// Of orientations, those that none before them turns into by right angles.
std::size_t count_roots(const std::vector<Mat3>& orientations) {
    std::vector<const Mat3*> roots;
    for (const Mat3& orientation : orientations) {
        const auto leads_there = [&](const Mat3* root) { return axis_turn(*root, orientation).has_value(); };
        if (std::ranges::none_of(roots, leads_there)) roots.push_back(&orientation);
    }
    return roots.size();
}

/// The parts' orientation sets; parts that differ in nothing that decides them share one.
void plan_orientations(const LoadedJob& loaded, const PackOptions& options, const Workers& workers, Plan& plan) {
    const RotationSpec spec = parse_rotations(rotations_of(options));
    struct Wanted {
        PartOrientations part;
        const Mesh* boxed = nullptr;  // whose box frame is added
        std::shared_ptr<const std::vector<Mat3>> set;
        std::size_t roots = 0;
    };
    std::vector<Wanted> wanted;
    std::map<const Mesh*, std::size_t> boxed;
    std::vector<std::size_t> wanted_by(loaded.parts.size());
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        if (!loaded.meshes[i]) continue;
        Wanted want{loaded.parts[i].orientations, nullptr, nullptr, 0};
        if (spec.box && want.part.kind == PartOrientations::Kind::any) {
            want.boxed = loaded.meshes[i].get();
            const auto [entry, fresh] = boxed.try_emplace(want.boxed, wanted.size());
            wanted_by[i] = entry->second;
            if (fresh) wanted.push_back(want);
            continue;
        }
        const auto same = std::find_if(wanted.begin(), wanted.end(),
                                       [&](const Wanted& other) { return !other.boxed && other.part == want.part; });
        wanted_by[i] = static_cast<std::size_t>(same - wanted.begin());
        if (same == wanted.end()) wanted.push_back(want);
    }
    workers.for_each(static_cast<std::int64_t>(wanted.size()), [&](std::int64_t k) {
        Wanted& want = wanted[static_cast<std::size_t>(k)];
        const Mat3 frame = want.boxed ? minimum_box_frame(*want.boxed) : Mat3{};
        want.set = std::make_shared<const std::vector<Mat3>>(orientation_set(spec, want.part, frame));
        want.roots = count_roots(*want.set);
    });
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        plan.orientations.push_back(loaded.meshes[i] ? wanted[wanted_by[i]].set : nullptr);
        plan.roots.push_back(loaded.meshes[i] ? wanted[wanted_by[i]].roots : 0);
        if (loaded.meshes[i]) plan.most_orientations = std::max(plan.most_orientations, plan.orientations[i]->size());
    }
}

/// By part, the first that is to be packed with the same mesh, as large and in the same orientations: what is so of
/// its size is so of this one. Itself where there is none, and for fixed copies.
std::vector<std::size_t> first_of_their_size(const LoadedJob& loaded, const Plan& plan) {
    using Key = std::tuple<const Mesh*, double, const std::vector<Mat3>*>;
    std::map<Key, std::size_t> known;
    std::vector<std::size_t> first(loaded.parts.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        const PackedPart& part = loaded.parts[i];
        first[i] = i;
        if (!loaded.meshes[i] || copies_to_pack(loaded, i) == 0) continue;
        const Key key{loaded.meshes[i].get(), part.to_mm(), plan.orientations[i].get()};
        first[i] = known.try_emplace(key, i).first->second;
    }
    return first;
}

/// Layers that hold the fixed copies whole.
int fixed_layers(const LoadedJob& loaded, double voxel) {
    double top = 0;
    for (const FixedPlacement& fixed : loaded.fixed) {
        const Mesh& mesh = *loaded.meshes[static_cast<std::size_t>(fixed.placement.part)];
        top = std::max(top, bounding_box(transformed(mesh, fixed.placement.transform)).max.z);
    }
    return top > 0 ? voxels_in(top, voxel) : 0;
}

/// Layers to begin with under an open ceiling: what the parts' boxes would fill, and one part's longest side.
int first_layers(const LoadedJob& loaded, const Plan& plan, const PackOptions& options) {
    constexpr double kFilled = 0.5;  // of the parts' boxes, about what they come to when they are packed
    double boxes = 0, longest = 0;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        if (!loaded.meshes[i] || !plan.too_large[i].empty()) continue;
        boxes += loaded.parts[i].count * loaded.box_volume[i];
        const Vec3 size = bounding_box(*loaded.meshes[i]).size();
        longest = std::max(longest, loaded.parts[i].to_mm() * std::max({size.x, size.y, size.z}));
    }
    const Vec3 space = space_inside(options);
    return fixed_layers(loaded, voxel_size(options)) +
           voxels_in(kFilled * boxes / (space.x * space.y) + longest, voxel_size(options));
}

/// Copies are ordered as numbers 0, 1, 2 ...; of parts that have some standing they become those that are left.
void number_apart_from_standing(const LoadedJob& loaded, std::vector<Copy>& items) {
    std::vector<std::vector<int>> numbers(loaded.parts.size());
    for (std::size_t i = loaded.fixed_parts; i < numbers.size(); ++i) {
        if (loaded.standing[i].empty()) continue;
        for (int number = 0; number < loaded.parts[i].count; ++number) {
            if (!loaded.standing[i].contains(number)) numbers[i].push_back(number);
        }
    }
    for (Copy& copy : items) {
        const std::vector<int>& left = numbers[static_cast<std::size_t>(copy.part)];
        if (!left.empty()) copy.number = left[static_cast<std::size_t>(copy.number)];
    }
}

}  // namespace

Plan make_plan(const LoadedJob& loaded, const Container& container, const PackOptions& options,
               std::span<const Printer> own_printers, const Workers& workers) {
    check_options(options);
    Plan plan;
    plan.engine = resolve_engine(options.engine);
    plan.reads_all = plan.engine == EngineKind::reference ||
                     (options.verify_with && resolve_engine(options.verify_with->engine) == EngineKind::reference);
    plan_orientations(loaded, options, workers, plan);
    plan.walls = container.physical || unpack_rule(options.unpack, container) == Unpack::top;
    plan.room = space_inside(options);
    plan.gap_classes = {};
    const double container_volume = volume_of(container);

    std::vector<PartSize> sizes;
    double material = 0;
    plan.too_large.resize(loaded.parts.size());
    plan.turned_sizes.resize(loaded.parts.size());
    const std::vector<std::size_t> first = first_of_their_size(loaded, plan);
    const auto is_first = [&](std::size_t i) { return first[i] == i && copies_to_pack(loaded, i) > 0; };
    workers.for_each(static_cast<std::int64_t>(loaded.parts.size()), [&](std::int64_t k) {
        const auto i = static_cast<std::size_t>(k);
        if (!loaded.meshes[i] || !is_first(i)) return;
        const PackedPart& part = loaded.parts[i];
        plan.too_large[i] = why_too_large({*loaded.meshes[i], part.to_mm(), part.orientations, *plan.orientations[i]},
                                          plan.room, options, !container.mesh, own_printers);
        workers.check();
        plan.turned_sizes[i] = sample_sizes(*loaded.meshes[i], loaded.parts[i].to_mm(), *plan.orientations[i]);
    });
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        plan.too_large[i] = plan.too_large[first[i]];
        plan.turned_sizes[i] = plan.turned_sizes[first[i]];
    }
    plan.ahead = ShapeStore::ahead(plan.most_orientations);
    if (options.interlock == Interlock::place) plan.ahead = std::min(plan.ahead, ShapeStore::kAheadOfWays);
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const PackedPart& part = loaded.parts[i];
        if (!loaded.meshes[i]) continue;
        const int copies = plan.too_large[i].empty() ? copies_to_pack(loaded, i) : 0;
        plan.box_ratio += copies * loaded.box_volume[i] / container_volume;
        plan.volume_ratio += copies * part.volume / container_volume;
        plan.gap_classes.push_back(part.gap);
        if (copies > 0) {
            sizes.push_back({part.id, copies, loaded.box_volume[i], part.priority, part.due, part.volume, part.value});
            plan.copies = plan.copies || copies > 1 || options.fill;
            material += copies * part.volume;
        }
    }
    if (!is_open(options) && material > container_volume) plan.placed = container_volume / material;
    std::sort(plan.gap_classes.begin(), plan.gap_classes.end());
    plan.gap_classes.erase(std::unique(plan.gap_classes.begin(), plan.gap_classes.end()), plan.gap_classes.end());
    plan.overflows = !is_open(options) && options.trays == 1 && plan.box_ratio > kOverflow;
    const bool by_goal = plan.overflows && options.goal != Goal::fair && options.order == Order::size;
    plan.items = by_goal ? order_copies(sizes, options.goal) : order_copies(sizes, options.order, options.seed);
    number_apart_from_standing(loaded, plan.items);
    plan.ranks = urgency_ranks(sizes);
    plan.height_penalty = options.height_penalty.value_or(
        automatic_height_penalty(sizes, is_open(options) ? std::numeric_limits<double>::infinity() : container_volume));
    for (int axis = 0; axis < 2; ++axis) {
        plan.grid[axis] = voxels_in(plan.room[axis], voxel_size(options));
    }
    plan.grid.z = is_open(options) ? first_layers(loaded, plan, options) : voxels_in(plan.room.z, voxel_size(options));
    plan_memory(loaded, options, is_open(options) ? fixed_layers(loaded, voxel_size(options)) : 0, workers, plan);
    return plan;
}

void warn_of_orientations(const Plan& plan, const PackOptions& options, Listener& listener) {
    constexpr std::size_t kUsual = 24, kMany = 10 * kUsual;
    if (plan.most_orientations < kMany) return;
    char memory[32];
    std::snprintf(memory, sizeof memory, "%.2g GB", static_cast<double>(plan.memory) / 1e9);
    listener.on_warning("--rotations " + rotations_of(options) + " tries " + std::to_string(plan.most_orientations) +
                        " ways to stand, --rotations 90 tries " + std::to_string(kUsual) + ": this takes up to " +
                        std::to_string(plan.most_orientations / kUsual) + " times as long, and about " + memory +
                        " of memory");
}

}  // namespace spectralpack
