#include "api/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "api/engine_factory.hpp"
#include "api/machine.hpp"
#include "model/orientation.hpp"
#include "packing/shape_store.hpp"
#include "search/tray.hpp"

namespace spectralpack {
namespace {

// Of the free memory, how much a run may plan with: the rest is for the allocator and everyone else.
constexpr double kShareOfFree = 0.85;

// What engines may keep for copies where nobody said how much, in bytes per voxel of the tray and orientation: the
// maps of a few parts. More is slower: fresh memory costs more than looking again (docs/benchmarks.md).
constexpr double kCacheUnasked = 0.5;

// What engines keep takes up to this much more than they count: freed pieces of it are not always used again.
constexpr int kCacheShare = 2;

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

Vec3 room(const PackOptions& options) {
    const double wall = 2 * options.wall_gap;
    return options.tray - Vec3{wall, wall, wall};
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

bool fits(const Vec3& size, const Vec3& space) {
    return size.x <= space.x + kContainTolerance && size.y <= space.y + kContainTolerance &&
           size.z <= space.z + kContainTolerance;
}

/// Why the part fits in no orientation; empty where it fits in one.
std::string why_too_large(const Mesh& mesh, double to_mm, const std::vector<Mat3>& orientations,
                          const Vec3& space) {
    for (const Mat3& turn : orientations) {
        if (fits(turned_size(mesh, turn, to_mm), space)) return "";
    }
    const Vec3 size = turned_size(mesh, Mat3{}, to_mm);
    return "is " + number(size.x) + " x " + number(size.y) + " x " + number(size.z) +
           " mm and fits into " + number(space.x) + " x " + number(space.y) + " x " + number(space.z) +
           " mm in none of the " + std::to_string(orientations.size()) + " orientation" +
           (orientations.size() == 1 ? "" : "s") + " tried";
}

/// Bytes of a part's voxels in all orientations, about: bit rows are padded to words, so the mean over which
/// axis runs along x; one set for A and one for A+g per distinct positive gap.
std::int64_t shape_memory(const Vec3& size, double dx, std::size_t orientations,
                          const std::vector<double>& gap_classes) {
    const auto bits = [&](double margin) {
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = std::ceil((size[axis] + margin) / dx);
            const double across = std::ceil((size[(axis + 1) % 3] + margin) / dx) *
                                  std::ceil((size[(axis + 2) % 3] + margin) / dx);
            sum += std::ceil(along / 64) * 8 * across / 3;
        }
        return sum;
    };
    double bytes = bits(0);
    for (const double gap : gap_classes) {
        if (gap > 0) bytes += bits(2 * (gap + dx));
    }
    return static_cast<std::int64_t>(bytes * static_cast<double>(orientations));
}

/// Bytes of one run at voxel size dx, without caches.
std::int64_t memory_at(double dx, const Plan& plan, const LoadedJob& loaded, const PackOptions& options,
                       const Workers& workers) {
    Extent grid;
    for (int axis = 0; axis < 3; ++axis) {
        const double voxels = std::ceil(room(options)[axis] / dx - 1e-9);
        if (voxels > 1e9) return std::numeric_limits<std::int64_t>::max();
        grid[axis] = std::max(1, static_cast<int>(voxels));
    }
    std::int64_t meshes = 0;
    std::vector<std::int64_t> shapes;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        if (!loaded.meshes[i]) continue;
        const Mesh& mesh = *loaded.meshes[i];
        meshes += static_cast<std::int64_t>(mesh.vertices.size() * sizeof(Vec3) +
                                            mesh.triangles.size() * sizeof(Triangle));
        if (!plan.too_large[i].empty()) continue;
        shapes.push_back(shape_memory(turned_size(mesh, Mat3{}, loaded.parts[i].to_mm()), dx,
                                      plan.orientations.size(), plan.gap_classes));
    }
    const std::size_t held = std::min<std::size_t>(shapes.size(), 2 * ShapeStore::kAhead);
    std::partial_sort(shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(held), shapes.end(),
                      std::greater<>());
    const double widest = plan.gap_classes.empty() ? 0 : plan.gap_classes.back();
    const EngineNeed need{grid, widest > 0 ? static_cast<int>(std::ceil(widest / dx)) + 1 : 0,
                          static_cast<int>(plan.gap_classes.size())};
    std::int64_t bytes = kProgramMemory + meshes + engine_memory(plan.engine, need, workers);
    for (std::size_t i = 0; i < held; ++i) {
        bytes += shapes[i];
    }
    if (options.verify_with) {
        bytes += engine_memory(resolve_engine(options.verify_with->engine), need, workers);
    }
    return bytes;
}

}  // namespace

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
    for (int axis = 0; axis < 3; ++axis) {
        positive(options.tray[axis], "every side of --tray");
        if (options.tray[axis] <= 2 * options.wall_gap) {
            throw UsageError("--wall-gap " + number(options.wall_gap) + " leaves no room in a tray of " +
                             number(options.tray[axis]) + " mm");
        }
    }
    positive(options.voxel, "--voxel");
    not_negative(options.gap, "--gap");
    not_negative(options.wall_gap, "--wall-gap");
    if (options.height_penalty) not_negative(*options.height_penalty, "--height-penalty");
    if (options.memory < 0) throw UsageError("--memory must be a number of bytes");
    if (options.time_limit) not_negative(*options.time_limit, "--time-limit");
    const Vec3 space = room(options);
    if (std::min({space.x, space.y, space.z}) < options.voxel) {
        throw UsageError("the container, less the wall gap, is smaller than one voxel of " +
                         number(options.voxel) + " mm");
    }
}

Plan make_plan(const LoadedJob& loaded, const PackOptions& options, const Workers& workers) {
    check_options(options);
    Plan plan;
    plan.orientations = orientation_set(options.rotations);
    plan.engine = resolve_engine(options.engine);
    plan.gap_classes = {};
    const double container = options.tray.x * options.tray.y * options.tray.z;

    std::vector<PartSize> sizes;
    plan.too_large.resize(loaded.parts.size());
    workers.for_each(static_cast<std::int64_t>(loaded.parts.size()), [&](std::int64_t k) {
        const auto i = static_cast<std::size_t>(k);
        if (!loaded.meshes[i]) return;
        plan.too_large[i] = why_too_large(*loaded.meshes[i], loaded.parts[i].to_mm(), plan.orientations,
                                          room(options));
    });
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const Part& part = loaded.parts[i];
        if (!loaded.meshes[i]) continue;
        plan.box_ratio += part.count * loaded.box_volume[i] / container;
        plan.volume_ratio += part.count * part.volume / container;
        plan.gap_classes.push_back(part.gap);
        if (plan.too_large[i].empty()) sizes.push_back({part.id, part.count, loaded.box_volume[i]});
    }
    std::sort(plan.gap_classes.begin(), plan.gap_classes.end());
    plan.gap_classes.erase(std::unique(plan.gap_classes.begin(), plan.gap_classes.end()),
                           plan.gap_classes.end());
    plan.items = order_items(sizes, options.order, options.seed);
    plan.height_penalty =
        options.height_penalty.value_or(automatic_height_penalty(sizes, container));
    for (int axis = 0; axis < 3; ++axis) {
        const double voxels = std::ceil(room(options)[axis] / options.voxel - 1e-9);
        if (voxels > 1e9) throw ResourceError("--voxel is too fine: over a billion voxels along one axis");
        plan.grid[axis] = std::max(1, static_cast<int>(voxels));
    }
    plan.memory_limit = options.memory > 0
                            ? options.memory
                            : static_cast<std::int64_t>(kShareOfFree *
                                                        static_cast<double>(available_memory()));
    plan.memory = memory_at(options.voxel, plan, loaded, options, workers);
    plan.cache = std::max<std::int64_t>(0, plan.memory_limit - plan.memory) / kCacheShare;
    if (options.memory == 0) {
        const double wanted = kCacheUnasked * static_cast<double>(plan.grid.count()) *
                              static_cast<double>(plan.orientations.size());
        plan.cache = static_cast<std::int64_t>(std::min(static_cast<double>(plan.cache), wanted));
    }
    return plan;
}

void require_memory(const Plan& plan, const LoadedJob& loaded, const PackOptions& options,
                    const Workers& workers) {
    if (plan.memory <= plan.memory_limit) return;
    double fitting = options.voxel;
    const Vec3 space = room(options);
    const double coarsest = std::min({space.x, space.y, space.z});
    while (fitting < coarsest && memory_at(fitting, plan, loaded, options, workers) > plan.memory_limit) {
        fitting *= 1.1;
    }
    std::string advice = "; no voxel size fits";
    if (fitting < coarsest) {
        // Rounded up to two digits, so that it is a size a person would type.
        const double digit = std::pow(10, std::floor(std::log10(fitting)) - 1);
        advice = "; --voxel " + number(std::ceil(fitting / digit) * digit) + " would fit";
    }
    throw ResourceError("packing at --voxel " + number(options.voxel) + " needs about " +
                        megabytes(plan.memory) + " of memory, and " + megabytes(plan.memory_limit) +
                        (options.memory > 0 ? " are allowed" : " are free") + advice);
}

}  // namespace spectralpack
