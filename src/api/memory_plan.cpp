#include "api/memory_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "api/check_options.hpp"
#include "api/engine_factory.hpp"
#include "api/machine.hpp"
#include "api/short_number.hpp"
#include "geometry/bvh.hpp"
#include "packing/containers/physical_walls.hpp"
#include "packing/interlocking/reachable_search.hpp"
#include "packing/interlocking/unlinked_search.hpp"
#include "spectralpack/error.hpp"
#include "voxel/outlines.hpp"
#include "voxel/voxelize.hpp"
#include "voxel/widen.hpp"

namespace spectralpack {
namespace {

// Of the free memory, how much a run may plan with: the rest is for the allocator and everyone else.
constexpr double kShareOfFree = 0.85;

// What engines may keep for copies where nobody said how much, in bytes per voxel of the tray and orientation: the
// maps of a few parts. More is slower: fresh memory costs more than looking again.
constexpr double kCacheUnasked = 0.5;

// What engines keep takes up to this much more than they count: freed pieces of it are not always used again.
constexpr int kCacheShare = 2;

// The program itself, its libraries and threads.
constexpr std::int64_t kProgramMemory = 32'000'000;

// Where addresses are limited, the stack of a thread, and what is kept for the allocator's own sake.
constexpr std::int64_t kThreadStack = 8 << 20;

// Of a copy, in bytes: what lists of copies, the packing and the text of its file take; and what one takes besides that
// stands in a tray, with its step of the plan.
constexpr std::int64_t kListedCopy = 500, kStandingCopy = 4000;
// Of any record.
constexpr std::int64_t kRecord = 4'000'000;

/// Bytes to plan with.
std::int64_t memory_limit(const PackOptions& options, const Workers& workers) {
    if (options.memory > 0) return std::min(options.memory, memory_within_limits());
    std::int64_t available = available_memory();
    if (limits_addresses()) available -= kThreadStack * (workers.threads() - 1);
    return static_cast<std::int64_t>(kShareOfFree * static_cast<double>(std::max<std::int64_t>(0, available)));
}

/// What grows with the copies: with those asked for, and with those of them that may stand.
std::int64_t copies_memory(const Plan& plan, const LoadedJob& loaded, const PackOptions& options) {
    const double standing = options.fill ? 0 : plan.placed * static_cast<double>(plan.items.size());
    return record_memory(loaded) + static_cast<std::int64_t>(kStandingCopy * standing);
}

std::string megabytes(std::int64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f MB", std::ceil(static_cast<double>(bytes) / 1e6));
    return text;
}

/// Bytes of a part's voxels in one orientation, about: bit rows are padded to words, so the mean over which axis runs
/// along x.
struct VoxelBytes {
    double solid = 0;    ///< of A, and of its fine voxels
    double widened = 0;  ///< of A+g, fine, for each distinct positive gap
};

VoxelBytes voxel_bytes(const Vec3& size, double voxel, int detail, std::span<const double> gap_classes) {
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

/// The gaps that voxels are widened by.
std::span<const double> widening_gaps(const Plan& plan) {
    const auto beyond =
        std::ranges::find_if(plan.gap_classes, [&](double gap) { return holds_one_only(plan.room, gap); });
    return {plan.gap_classes.begin(), beyond};
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
        const VoxelBytes one = voxel_bytes(size, dx, detail, widening_gaps(plan));
        mean.solid += one.solid / static_cast<double>(sizes.size());
        mean.of_made += made * (one.solid + one.widened) / static_cast<double>(sizes.size());
    }
    return mean;
}

/// Bytes that do not depend on the grid: meshes, surfaces, the voxels of the parts that are held at once, or of `all`,
/// and those of what stands in the tray.
std::int64_t parts_memory(double dx, int detail, const Plan& plan, const LoadedJob& loaded, bool all = false) {
    std::int64_t bytes = kProgramMemory + plan.memory_of_surfaces + plan.memory_of_copies;
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
    const int margin = plan.walls ? walls_margin(dx / s, options.wall_gap) : 0;
    return {s * grid.x + 2 * margin, s * grid.y + 2 * margin, s * grid.z + margin};
}

/// Bytes of the trays that are taken apart in such a grid: the copies that stand together, groups that left them, what
/// is put back; of walls; and of the outlines of all that stands.
std::int64_t companies_memory(const Extent& ways, const Plan& plan) {
    constexpr int kCompanies = 3;
    const auto sets = kCompanies * static_cast<std::int64_t>(plan.gap_classes.size()) + (plan.walls ? 1 : 0);
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
    const std::span<const double> gaps = widening_gaps(plan);
    const double widest = gaps.empty() ? 0 : gaps.back();
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

double parts_to_pack(const LoadedJob& loaded) {
    double parts = 0;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        if (copies_to_pack(loaded, i) > 0) ++parts;
    }
    return parts;
}

constexpr std::int64_t kMostAnswers = std::int64_t{512} << 20;  // bytes of what links were found out (UnlinkedSearch)

Extent with_layers(Extent grid, int layers) {
    grid.z = layers;
    return grid;
}

}  // namespace

void plan_memory(const LoadedJob& loaded, const PackOptions& options, int fixed_layers, const Workers& workers,
                 Plan& plan) {
    plan.memory_limit = memory_limit(options, workers);
    plan.memory_of_surfaces = surfaces_memory(plan, loaded, options);
    plan.memory_of_copies = copies_memory(plan, loaded, options);
    plan.memory = parts_memory(voxel_size(options), options.detail, plan, loaded);
    const auto engines = [&](int layers) {
        return engines_memory(voxel_size(options), with_layers(plan.grid, layers), plan, options, workers);
    };
    if (is_open(options)) {
        plan.most_layers = 1;
        for (int step = 1 << 20; step > 0; step /= 2) {
            if (plan.memory + engines(plan.most_layers + step) <= plan.memory_limit) plan.most_layers += step;
        }
        plan.grid.z = std::max(std::min(plan.grid.z, plan.most_layers), fixed_layers);
    }
    plan.memory += engines(plan.grid.z);
    plan.cache = std::max<std::int64_t>(0, plan.memory_limit - plan.memory) / kCacheShare;
    if (options.memory == 0) {
        // Where what walks or links take is kept as well, the maps of the part asked about last will do, which engines
        // keep in any case: its copies come one after the other, but in a fill.
        const double per_voxel = options.interlock == Interlock::off || options.fill ? kCacheUnasked : 0;
        double wanted =
            per_voxel * static_cast<double>(plan.grid.count()) * static_cast<double>(plan.most_orientations);
        // Improving asks about all parts in turn, over and over.
        if (improves(options)) {
            const auto maps = part_memory(plan.engine, engine_need(voxel_size(options), plan.grid, plan, options));
            wanted = std::max(wanted, static_cast<double>(maps) * parts_to_pack(loaded));
        }
        plan.cache = static_cast<std::int64_t>(std::min(static_cast<double>(plan.cache), wanted));
    }
    if (plan.engine == EngineKind::reference) plan.cache = 0;  // it keeps nothing
    const std::int64_t cached = std::max<std::int64_t>(
        0, plan.cache - part_memory(plan.engine, engine_need(voxel_size(options), plan.grid, plan, options)));
    const std::int64_t spare = plan.memory_limit - plan.memory - kCacheShare * cached;
    if (options.memory == 0) plan.memory += cached;
    plan.keeps_all = parts_memory(voxel_size(options), options.detail, plan, loaded, true) -
                         parts_memory(voxel_size(options), options.detail, plan, loaded) <=
                     spare / 2;
    if (improves(options)) plan.answers = std::min(kMostAnswers, std::max<std::int64_t>(0, spare) / 4);
    if (options.trays != 1) {
        plan.keep = std::max<std::int64_t>(0, spare) / 2;
    }
}

std::int64_t record_memory(const LoadedJob& loaded) {
    std::int64_t copies = 0;
    for (const PackedPart& part : loaded.parts) {
        copies += part.count;
    }
    return kRecord + kListedCopy * copies;
}

void require_memory(const Plan& plan, const LoadedJob& loaded, const PackOptions& options, const Workers& workers) {
    if (plan.memory <= plan.memory_limit) return;
    double fitting = voxel_size(options);
    const Vec3 space = space_inside(options);
    const double coarsest = std::min({space.x, space.y, space.z});
    const auto grid_at = [&](double dx) {
        const double by = voxel_size(options) / dx;
        const auto coarser = [&](int voxels) { return std::max(1, static_cast<int>(std::ceil(voxels * by))); };
        return Extent{coarser(plan.grid.x), coarser(plan.grid.y), coarser(plan.grid.z)};
    };
    while (fitting < coarsest && parts_memory(fitting, options.detail, plan, loaded) +
                                         engines_memory(fitting, grid_at(fitting), plan, options, workers) >
                                     plan.memory_limit) {
        fitting *= 1.1;
    }
    const bool by_copies = 2 * plan.memory_of_copies > plan.memory;
    std::string advice = by_copies ? "; fewer copies would fit" : "; no voxel size fits";
    if (fitting < coarsest) {
        // Rounded up to two digits, so that it is a size a person would type.
        const double digit = std::pow(10, std::floor(std::log10(fitting)) - 1);
        advice = "; --voxel " + short_number(std::ceil(fitting / digit) * digit) + " would fit";
    }
    throw ResourceError("packing at --voxel " + short_number(voxel_size(options)) + " needs about " +
                        megabytes(plan.memory) + " of memory, and " + megabytes(plan.memory_limit) +
                        (options.memory > 0 && options.memory == plan.memory_limit ? " are allowed" : " are free") +
                        advice);
}

}  // namespace spectralpack
