#include "api/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "api/engine_factory.hpp"
#include "api/machine.hpp"
#include "geometry/box.hpp"
#include "geometry/bvh.hpp"
#include "geometry/minimum_box.hpp"
#include "model/orientation.hpp"
#include "packing/physical_walls.hpp"
#include "packing/reachable_search.hpp"
#include "packing/shape_store.hpp"
#include "packing/unlinked_search.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/outlines.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

// Of the free memory, how much a run may plan with: the rest is for the allocator and everyone else.
constexpr double kShareOfFree = 0.85;

// What engines may keep for copies where nobody said how much, in bytes per voxel of the tray and orientation: the
// maps of a few parts. More is slower: fresh memory costs more than looking again (docs/benchmarks.md).
constexpr double kCacheUnasked = 0.5;

// What engines keep takes up to this much more than they count: freed pieces of it are not always used again.
constexpr int kCacheShare = 2;

// Nobody would wait for more.
constexpr int kMostRestarts = 1'000'000;
constexpr int kMostBeam = 100;

// Finer ones would be s times finer in each of three directions, for nothing: --voxel is the option to turn then.
constexpr int kMostDetail = 8;

// Rays to a voxel that collisions are decided on: more of them, squared, tell nothing that floods do not.
constexpr int kMostRays = 20;

// The program itself, its libraries and threads.
constexpr std::int64_t kProgramMemory = 32'000'000;

std::string megabytes(std::int64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f MB", std::ceil(static_cast<double>(bytes) / 1e6));
    return text;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// What is left of the tray inside the wall gap; under an open ceiling without end upwards.
Vec3 room(const PackOptions& options) {
    const double wall = 2 * options.wall_gap;
    Vec3 space = tray_size(options) - Vec3{wall, wall, wall};
    if (is_open(options)) space.z = std::numeric_limits<double>::infinity();
    return space;
}

int voxels_in(double length, double dx) {
    const double voxels = std::ceil(length / dx - 1e-9);
    if (voxels > 1e9) throw ResourceError("--voxel is too fine: over a billion voxels along one axis");
    return std::max(1, static_cast<int>(voxels));
}

Vec3 turned_size(const Mesh& mesh, const Mat3& turn, double to_mm) {
    Box box;
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            box.add(turn * (to_mm * mesh.vertices[vertex]));
        }
    }
    return box.size();
}

/// Why the part fits in no orientation; empty where it fits in one.
std::string why_too_large(const Mesh& mesh, double to_mm, const std::vector<Mat3>& orientations, const Vec3& space) {
    for (const Mat3& turn : orientations) {
        if (fits(turned_size(mesh, turn, to_mm), space)) return "";
    }
    const Vec3 size = turned_size(mesh, Mat3{}, to_mm);
    return "is " + number(size.x) + " x " + number(size.y) + " x " + number(size.z) + " mm and fits " +
           (std::isinf(space.z) ? "on " : "into ") + number(space.x) + " x " + number(space.y) +
           (std::isinf(space.z) ? "" : " x " + number(space.z)) + " mm in none of the " +
           std::to_string(orientations.size()) + " orientation" + (orientations.size() == 1 ? "" : "s") + " tried";
}

/// Bytes of a part's voxels in one orientation, about: bit rows are padded to words, so the mean over which axis runs
/// along x.
struct VoxelBytes {
    double solid = 0;    ///< of A, and of its fine voxels
    double widened = 0;  ///< of A+g, fine, for each distinct positive gap
};

VoxelBytes voxel_bytes(const Vec3& size, double voxel, int detail, const std::vector<double>& gap_classes) {
    const auto bits = [&](double margin, double dx) {
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = std::ceil((size[axis] + margin) / dx);
            const double across =
                std::ceil((size[(axis + 1) % 3] + margin) / dx) * std::ceil((size[(axis + 2) % 3] + margin) / dx);
            sum += std::ceil(along / 64) * 8 * across / 3;
        }
        return sum;
    };
    const double fine = voxel / detail;
    VoxelBytes bytes{bits(0, voxel) + (detail > 1 ? bits(0, fine) : 0), 0};
    for (const double gap : gap_classes) {
        if (gap > 0) bytes.widened += bits(2 * (gap + fine), fine);
    }
    return bytes;
}

/// Sizes of a part for an estimate: one if its orientations are turns by right angles, else some that are spread over
/// them, as a part turned otherwise has a larger box.
std::vector<Vec3> sample_sizes(const Mesh& mesh, double to_mm, const std::vector<Mat3>& orientations) {
    constexpr std::size_t kRightAngles = 24, kSamples = 7;
    const std::size_t samples = orientations.size() > kRightAngles ? kSamples : 1;
    std::vector<Vec3> sizes;
    for (std::size_t k = 0; k < samples; ++k) {
        sizes.push_back(turned_size(mesh, orientations[k * orientations.size() / samples], to_mm));
    }
    return sizes;
}

/// Bytes of a part, about.
struct PartBytes {
    double solid = 0;    ///< the voxels of one orientation without those of A+g
    double of_made = 0;  ///< all voxels of those orientations whose voxels are made before one is chosen
};

PartBytes part_bytes(double dx, int detail, const Plan& plan, std::size_t part) {
    const auto orientations = static_cast<double>(plan.orientations[part]->size());
    const std::vector<Vec3>& sizes = plan.turned_sizes[part];
    PartBytes mean;
    for (const Vec3& size : sizes) {
        // What follows by right angles is turned when it is placed, unless that reverses an axis on which fine voxels
        // do not come out even: then its voxels of dx are others. The reference engine reads all.
        double made = static_cast<double>(plan.roots[part]);
        for (int axis = 0; axis < 3; ++axis) {
            if (voxels_along(size[axis], dx / detail) % detail != 0) made *= 2;
        }
        if (plan.reads_all || made > orientations) made = orientations;
        const VoxelBytes one = voxel_bytes(size, dx, detail, plan.gap_classes);
        mean.solid += one.solid / static_cast<double>(sizes.size());
        mean.of_made += made * (one.solid + one.widened) / static_cast<double>(sizes.size());
    }
    return mean;
}

/// Bytes that do not depend on the grid: meshes, surfaces, the voxels of the parts that are held at once, or of `all`,
/// and those of what stands in the tray.
std::int64_t parts_memory(double dx, int detail, const Plan& plan, const LoadedJob& loaded, bool all = false) {
    std::int64_t bytes = kProgramMemory + plan.memory_of_surfaces;
    std::vector<std::int64_t> shapes;
    double standing = 0;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        if (!loaded.meshes[i]) continue;
        const Mesh& mesh = *loaded.meshes[i];
        bytes +=
            static_cast<std::int64_t>(mesh.vertices.size() * sizeof(Vec3) + mesh.triangles.size() * sizeof(Triangle));
        const int copies = copies_to_pack(loaded, i);
        if (!plan.too_large[i].empty() || copies == 0) continue;
        const PartBytes part = part_bytes(dx, detail, plan, i);
        shapes.push_back(static_cast<std::int64_t>(part.of_made));
        // Copies in the same orientation share voxels.
        standing +=
            static_cast<double>(std::min<std::size_t>(static_cast<std::size_t>(copies), plan.orientations[i]->size())) *
            part.solid;
    }
    bytes += static_cast<std::int64_t>(plan.placed * standing);
    const std::size_t held =
        std::min<std::size_t>(shapes.size(), all ? shapes.size() : static_cast<std::size_t>(plan.held()));
    std::partial_sort(shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(held), shapes.end(),
                      std::greater<>());
    for (std::size_t i = 0; i < held; ++i) {
        bytes += shapes[i];
    }
    return bytes;
}

/// Bytes of the surfaces of a tray's copies for sliding and leaving, about: copies of a part share those of an
/// orientation.
std::int64_t surfaces_memory(const Plan& plan, const LoadedJob& loaded, const PackOptions& options) {
    if (!options.refine && options.interlock == Interlock::off) return 0;
    double bytes = 0;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const int copies = copies_to_pack(loaded, i);
        if (!loaded.meshes[i] || !plan.too_large[i].empty() || copies == 0) continue;
        const std::size_t surfaces = std::min(static_cast<std::size_t>(copies), plan.orientations[i]->size());
        bytes += static_cast<double>(surfaces) * static_cast<double>(Bvh::most_bytes(*loaded.meshes[i]));
    }
    return static_cast<std::int64_t>(plan.placed * bytes);
}

/// The grid in which ways out of a tray with `grid` are looked for; empty where none are.
Extent grid_of_ways(double dx, const Extent& grid, const Plan& plan, const PackOptions& options) {
    if (options.interlock == Interlock::off) return {};
    const int s = options.detail;
    const int margin = plan.physical ? walls_margin(dx / s, options.wall_gap) : 0;
    return {s * grid.x + 2 * margin, s * grid.y + 2 * margin, s * grid.z + margin};
}

/// Bytes of the trays that are taken apart in such a grid: the copies that stand together, groups that left them, what
/// is put back; of walls; and of the outlines of all that stands.
std::int64_t companies_memory(const Extent& ways, const Plan& plan) {
    constexpr int kCompanies = 3;
    const auto sets = kCompanies * static_cast<std::int64_t>(plan.gap_classes.size()) + (plan.physical ? 1 : 0);
    return sets * (ways.count() / 8) + Outlines::bytes_for(ways);
}

bool keeps_links(const PackOptions& options) {
    return options.interlock == Interlock::post && options.links == Links::avoid;
}

/// The greatest of the parts that fit, in squares of dx: of each the least box that is known of it, as turning a part
/// adds to its box and not to its surface.
double largest_surface(double dx, const Plan& plan) {
    double largest = 0;
    for (std::size_t i = 0; i < plan.turned_sizes.size(); ++i) {
        if (!plan.too_large[i].empty()) continue;
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3& size : plan.turned_sizes[i]) {
            const Vec3 n{std::ceil(size.x / dx), std::ceil(size.y / dx), std::ceil(size.z / dx)};
            least = std::min(least, 2 * (n.x * n.y + n.y * n.z + n.z * n.x));
        }
        if (!plan.turned_sizes[i].empty()) largest = std::max(largest, least);
    }
    return largest;
}

EngineNeed engine_need(double dx, const Extent& grid, const Plan& plan, const PackOptions& options) {
    const double widest = plan.gap_classes.empty() ? 0 : plan.gap_classes.back();
    return {grid,
            widest > 0 ? static_cast<int>(std::ceil(widest / dx)) + 1 : 0,
            static_cast<int>(plan.gap_classes.size()),
            options.detail,
            grid_of_ways(dx, grid, plan, options),
            plan.most_orientations,
            largest_surface(dx, plan),
            plan.copies};
}

/// Bytes of the engines in such a grid, and of what they are asked about there, without caches.
std::int64_t engines_memory(double dx, const Extent& grid, const Plan& plan, const PackOptions& options,
                            const Workers& workers) {
    const EngineNeed need = engine_need(dx, grid, plan, options);
    // A beam has a tray and an engine for each of its states.
    const std::int64_t states = options.beam > 1 ? options.beam + 1 : 1;
    std::int64_t bytes = states * engine_memory(plan.engine, need, workers) + companies_memory(need.ways, plan);
    if (options.interlock != Interlock::off) bytes += ReachableSearch::kept_in(need.ways);
    if (keeps_links(options)) {
        bytes += UnlinkedSearch::kept_in(grid.count() * part_count(options.detail)).all();
    }
    if (options.verify_with) {
        bytes += engine_memory(resolve_engine(options.verify_with->engine), need, workers);
    }
    return bytes;
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
    const RotationSpec spec = parse_rotations(options.rotations);
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
    const Vec3 space = room(options);
    return fixed_layers(loaded, options.voxel) +
           voxels_in(kFilled * boxes / (space.x * space.y) + longest, options.voxel);
}

Extent with_layers(Extent grid, int layers) {
    grid.z = layers;
    return grid;
}

}  // namespace

bool is_open(const PackOptions& options) { return options.open_height || options.minimise == Minimise::box; }

HeightReference height_reference(const PackOptions& options) {
    return options.height_at.value_or(is_open(options) ? HeightReference::top : HeightReference::bottom);
}

Vec3 tray_size(const PackOptions& options) {
    Vec3 size = options.tray;
    if (is_open(options) && size.z == 0) size.z = std::max(size.x, size.y);
    return size;
}

void check_ray_spacing(double spacing, double voxel) {
    if (!(spacing > 0) || !std::isfinite(spacing)) throw UsageError("--ray-spacing must be a positive number");
    if (spacing * kMostRays < voxel) {
        throw UsageError("--ray-spacing " + number(spacing) + " is too fine: " + number(voxel / kMostRays) +
                         " is the least for voxels of " + number(voxel) + " mm");
    }
}

void check_options(const PackOptions& options) {
    const auto positive = [](double value, const char* what) {
        if (!(value > 0) || !std::isfinite(value)) {
            throw UsageError(std::string(what) + " must be a positive number");
        }
    };
    const auto not_negative = [](double value, const char* what) {
        if (!(value >= 0) || !std::isfinite(value)) {
            throw UsageError(std::string(what) + " must be zero or a positive number");
        }
    };
    const Vec3 tray = tray_size(options);
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == 2 && tray.z == 0) throw UsageError("--tray needs a height, except with --open-height");
        positive(tray[axis], "every side of --tray");
        if (tray[axis] <= 2 * options.wall_gap) {
            throw UsageError("--wall-gap " + number(options.wall_gap) + " leaves no room in a tray of " +
                             number(tray[axis]) + " mm");
        }
    }
    positive(options.voxel, "--voxel");
    if (options.trays < 0) throw UsageError("--trays takes a number or all");
    if (options.try_per_tray < 0) throw UsageError("--try-per-tray takes a number of copies, 0 for all");
    if (options.detail < 1 || options.detail > kMostDetail) {
        throw UsageError("--detail must be 1 to " + std::to_string(kMostDetail));
    }
    if (options.restarts < 1 || options.restarts > kMostRestarts) {
        throw UsageError("--restarts must be 1 to " + std::to_string(kMostRestarts));
    }
    if (options.beam < 1 || options.beam > kMostBeam) {
        throw UsageError("--beam must be 1 to " + std::to_string(kMostBeam));
    }
    not_negative(options.gap, "--gap");
    not_negative(options.wall_gap, "--wall-gap");
    if (options.ray_spacing) check_ray_spacing(*options.ray_spacing, options.voxel / options.detail);
    if (options.height_penalty) not_negative(*options.height_penalty, "--height-penalty");
    if (options.memory < 0) throw UsageError("--memory must be a number of bytes");
    if (options.time_limit) not_negative(*options.time_limit, "--time-limit");
    parse_rotations(options.rotations);
    const auto share = [](const std::optional<double>& value, const char* what) {
        if (value && !(*value > 0 && *value <= 1)) {
            throw UsageError(std::string(what) + " must be a share above 0 and up to 1");
        }
    };
    share(options.max_density, "--max-density");
    share(options.max_layer_fill, "--max-layer-fill");
    if (is_open(options)) {
        const std::string open = options.open_height ? "--open-height" : "--minimise box";
        if (options.fill) throw UsageError("--fill needs a height to fill: it does not go with " + open);
        if (options.max_density) {
            throw UsageError("--max-density needs a container's volume: it does not go with " + open);
        }
        if (height_reference(options) == HeightReference::bottom && options.height_penalty == 0) {
            throw UsageError(open + " with --height-at bottom needs a height penalty above 0");
        }
    }
    const Vec3 space = room(options);
    if (std::min({space.x, space.y, space.z}) < options.voxel) {
        throw UsageError("the container, less the wall gap, is smaller than one voxel of " + number(options.voxel) +
                         " mm");
    }
}

Plan make_plan(const LoadedJob& loaded, const Container& container, const PackOptions& options,
               const Workers& workers) {
    check_options(options);
    Plan plan;
    plan.engine = resolve_engine(options.engine);
    plan.reads_all = plan.engine == EngineKind::reference ||
                     (options.verify_with && resolve_engine(options.verify_with->engine) == EngineKind::reference);
    plan_orientations(loaded, options, workers, plan);
    plan.physical = container.physical;
    plan.room = room(options);
    plan.gap_classes = {};
    const double container_volume = volume_of(container);

    std::vector<PartSize> sizes;
    double material = 0;
    plan.too_large.resize(loaded.parts.size());
    plan.turned_sizes.resize(loaded.parts.size());
    workers.for_each(static_cast<std::int64_t>(loaded.parts.size()), [&](std::int64_t k) {
        const auto i = static_cast<std::size_t>(k);
        if (!loaded.meshes[i] || copies_to_pack(loaded, i) == 0) return;
        plan.too_large[i] = why_too_large(*loaded.meshes[i], loaded.parts[i].to_mm(), *plan.orientations[i], plan.room);
        plan.turned_sizes[i] = sample_sizes(*loaded.meshes[i], loaded.parts[i].to_mm(), *plan.orientations[i]);
    });
    plan.ahead = ShapeStore::ahead(plan.most_orientations);
    if (options.interlock == Interlock::place) plan.ahead = std::min(plan.ahead, ShapeStore::kAheadOfWays);
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const Part& part = loaded.parts[i];
        if (!loaded.meshes[i]) continue;
        const int copies = copies_to_pack(loaded, i);
        plan.box_ratio += copies * loaded.box_volume[i] / container_volume;
        plan.volume_ratio += copies * part.volume / container_volume;
        plan.gap_classes.push_back(part.gap);
        if (plan.too_large[i].empty() && copies > 0) {
            sizes.push_back({part.id, copies, loaded.box_volume[i], loaded.priority[i], loaded.due[i], part.volume});
            plan.copies = plan.copies || copies > 1 || options.fill;
            material += copies * part.volume;
        }
    }
    if (!is_open(options) && material > container_volume) plan.placed = container_volume / material;
    std::sort(plan.gap_classes.begin(), plan.gap_classes.end());
    plan.gap_classes.erase(std::unique(plan.gap_classes.begin(), plan.gap_classes.end()), plan.gap_classes.end());
    plan.items = order_items(sizes, options.order, options.seed);
    plan.ranks = urgency_ranks(sizes);
    plan.height_penalty = options.height_penalty.value_or(
        automatic_height_penalty(sizes, is_open(options) ? std::numeric_limits<double>::infinity() : container_volume));
    for (int axis = 0; axis < 2; ++axis) {
        plan.grid[axis] = voxels_in(plan.room[axis], options.voxel);
    }
    plan.grid.z = is_open(options) ? first_layers(loaded, plan, options) : voxels_in(plan.room.z, options.voxel);
    plan.memory_limit = options.memory > 0
                            ? options.memory
                            : static_cast<std::int64_t>(kShareOfFree * static_cast<double>(available_memory()));
    plan.memory_of_surfaces = surfaces_memory(plan, loaded, options);
    plan.memory = parts_memory(options.voxel, options.detail, plan, loaded);
    const auto engines = [&](int layers) {
        return engines_memory(options.voxel, with_layers(plan.grid, layers), plan, options, workers);
    };
    if (is_open(options)) {
        plan.most_layers = 1;
        for (int step = 1 << 20; step > 0; step /= 2) {
            if (plan.memory + engines(plan.most_layers + step) <= plan.memory_limit) plan.most_layers += step;
        }
        plan.grid.z = std::max(std::min(plan.grid.z, plan.most_layers), fixed_layers(loaded, options.voxel));
    }
    plan.memory += engines(plan.grid.z);
    plan.cache = std::max<std::int64_t>(0, plan.memory_limit - plan.memory) / kCacheShare;
    if (options.memory == 0) {
        // Where what walks or links take is kept as well, the maps of the part asked about last will do, which engines
        // keep in any case: its copies come one after the other, but in a fill.
        const double per_voxel = options.interlock == Interlock::off || options.fill ? kCacheUnasked : 0;
        const double wanted =
            per_voxel * static_cast<double>(plan.grid.count()) * static_cast<double>(plan.most_orientations);
        plan.cache = static_cast<std::int64_t>(std::min(static_cast<double>(plan.cache), wanted));
    }
    if (plan.engine == EngineKind::reference) plan.cache = 0;  // it keeps nothing
    const std::int64_t cached = std::max<std::int64_t>(
        0, plan.cache - part_memory(plan.engine, engine_need(options.voxel, plan.grid, plan, options)));
    const std::int64_t spare = plan.memory_limit - plan.memory - kCacheShare * cached;
    if (options.memory == 0) plan.memory += cached;
    plan.keeps_all = parts_memory(options.voxel, options.detail, plan, loaded, true) -
                         parts_memory(options.voxel, options.detail, plan, loaded) <=
                     spare / 2;
    if (options.trays != 1) {
        plan.keep = std::max<std::int64_t>(0, spare) / 2;
    }
    return plan;
}

void require_memory(const Plan& plan, const LoadedJob& loaded, const PackOptions& options, const Workers& workers) {
    if (plan.memory <= plan.memory_limit) return;
    double fitting = options.voxel;
    const Vec3 space = room(options);
    const double coarsest = std::min({space.x, space.y, space.z});
    const auto grid_at = [&](double dx) {
        const double by = options.voxel / dx;
        const auto coarser = [&](int voxels) { return std::max(1, static_cast<int>(std::ceil(voxels * by))); };
        return Extent{coarser(plan.grid.x), coarser(plan.grid.y), coarser(plan.grid.z)};
    };
    while (fitting < coarsest && parts_memory(fitting, options.detail, plan, loaded) +
                                         engines_memory(fitting, grid_at(fitting), plan, options, workers) >
                                     plan.memory_limit) {
        fitting *= 1.1;
    }
    std::string advice = "; no voxel size fits";
    if (fitting < coarsest) {
        // Rounded up to two digits, so that it is a size a person would type.
        const double digit = std::pow(10, std::floor(std::log10(fitting)) - 1);
        advice = "; --voxel " + number(std::ceil(fitting / digit) * digit) + " would fit";
    }
    throw ResourceError("packing at --voxel " + number(options.voxel) + " needs about " + megabytes(plan.memory) +
                        " of memory, and " + megabytes(plan.memory_limit) +
                        (options.memory > 0 ? " are allowed" : " are free") + advice);
}

}  // namespace spectralpack
