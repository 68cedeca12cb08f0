#include "api/check_options.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "api/short_number.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/orientations.hpp"

namespace spectralpack {
namespace {

// Nobody would wait for more.
constexpr int kMostRestarts = 1'000'000;
constexpr int kMostBeam = 100;

// Finer ones would be s times finer in each of three directions, for nothing: --voxel is the option to turn then.
constexpr int kMostDetail = 8;

// Rays to a voxel that collisions are decided on: more of them, squared, tell nothing that floods do not.
constexpr int kMostRays = 20;

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

Vec3 space_inside(const PackOptions& options) {
    const double wall = 2 * options.wall_gap;
    Vec3 space = tray_size(options) - Vec3{wall, wall, wall};
    if (is_open(options)) space.z = std::numeric_limits<double>::infinity();
    return space;
}

void check_ray_spacing(double spacing, double voxel) {
    if (!(spacing > 0) || !std::isfinite(spacing)) throw UsageError("--ray-spacing must be a positive number");
    if (spacing * kMostRays < voxel) {
        throw UsageError("--ray-spacing " + short_number(spacing) + " is too fine: " + short_number(voxel / kMostRays) +
                         " is the least for voxels of " + short_number(voxel) + " mm");
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
            throw UsageError("--wall-gap " + short_number(options.wall_gap) + " leaves no room in a tray of " +
                             short_number(tray[axis]) + " mm");
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
    const Vec3 space = space_inside(options);
    if (std::min({space.x, space.y, space.z}) < options.voxel) {
        throw UsageError("the container, less the wall gap, is smaller than one voxel of " +
                         short_number(options.voxel) + " mm");
    }
}

}  // namespace spectralpack
