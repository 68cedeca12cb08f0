#include "api/check_options.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "api/short_number.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack {
namespace {

// Rays to a voxel that collisions are decided on: more of them, squared, tell nothing that floods do not.
constexpr int kMostRays = 20;

}  // namespace

bool is_open(const PackOptions& options) { return options.open_height || options.minimise == Minimise::box; }

bool improves(const PackOptions& options) { return options.improve || options.improve_steps > 0; }

double voxel_size(const PackOptions& options) { return options.voxel.value_or(kUsualVoxel); }

std::string rotations_of(const PackOptions& options) { return options.rotations.value_or(kUsualRotations); }

std::optional<HeightReference> height_reference(const PackOptions& options) {
    if (options.height_at) return options.height_at;
    if (is_open(options)) return HeightReference::top;
    // A penalty weighs at the bottom only; what is filled with as many copies as fit is never roomy.
    if (options.height_penalty || options.fill) return HeightReference::bottom;
    return std::nullopt;
}

Unpack unpack_rule(const std::optional<Unpack>& asked, const Container& container) {
    return asked.value_or(container.mesh ? Unpack::any : Unpack::top);
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
    for (const Option& option : option_table()) {
        if (option.in_pack.get) require_accepted(option, option.in_pack.get(options));
    }
    const Vec3 tray = tray_size(options);
    if (tray.z == 0) throw UsageError("--tray needs a height, except with --open-height");
    for (int axis = 0; axis < 3; ++axis) {
        if (tray[axis] <= 2 * options.wall_gap) {
            throw UsageError("--wall-gap " + short_number(options.wall_gap) + " leaves no room in a tray of " +
                             short_number(tray[axis]) + " mm");
        }
    }
    if (options.ray_spacing) check_ray_spacing(*options.ray_spacing, voxel_size(options) / options.detail);
    if (is_open(options)) {
        const std::string open = options.open_height ? "--open-height" : "--minimise box";
        if (options.fill) throw UsageError("--fill needs a height to fill: it does not go with " + open);
        if (options.max_density) {
            throw UsageError("--max-density is a share of the tray's volume: it does not go with " + open);
        }
        if (height_reference(options) == HeightReference::bottom && options.height_penalty == 0) {
            throw UsageError(open + " with --height-at bottom needs a --height-penalty above 0");
        }
    }
    const Vec3 space = space_inside(options);
    if (std::min({space.x, space.y, space.z}) < voxel_size(options)) {
        throw UsageError("the tray, less the wall gap, is smaller than one voxel of " +
                         short_number(voxel_size(options)) + " mm");
    }
}

}  // namespace spectralpack
