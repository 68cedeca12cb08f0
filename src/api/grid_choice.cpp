#include "api/grid_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "api/check_options.hpp"

namespace spectralpack {
namespace {

// Of the time to improve, what a pass may be expected to take: finer voxels mostly pay even where hardly any other
// order can be tried. Other orders give more where large copies go first into a tray that overflows, unless there are
// so many that moving a few does little; and so they do for several trays.
constexpr double kFinerVoxels = 1.2, kFinerThanOrders = 0.1;
constexpr std::size_t kManyCopies = 1000;

// The same for more ways to stand, times the copies: they make most first packings higher, and pay where many orders
// can be tried for each copy.
constexpr double kMoreWays = 14;

constexpr double kShort = 10;  // seconds: who gives less is in a hurry, and takes the usual grid

double time_to_improve(const PackOptions& options) {
    const double seconds = options.improve.value_or(0) > 0 ? *options.improve : options.time_limit.value_or(0);
    return options.improve && seconds >= kShort ? seconds : 0;
}

double most_of_time(const Plan& plan, const PackOptions& options, bool more_ways) {
    const bool fair = plan.overflows && options.goal == Goal::fair && plan.items.size() < kManyCopies;
    const double most = fair || options.trays != 1 ? kFinerThanOrders : kFinerVoxels;
    return more_ways ? std::min(most, kMoreWays / static_cast<double>(plan.items.size())) : most;
}

/// Seconds that one pass takes on two cores, within a factor of two (measured): at 1 mm one for a
/// twenty-fourth of a square metre of the faces of all copies' boxes, if each may stand in the usual 24 ways. For the
/// least box, that of all passes.
double expected_pass(const LoadedJob& loaded, const Plan& plan, const PackOptions& options) {
    constexpr double kOfFace = 2.4e-5;  // s / mm^2
    constexpr double kUsualWays = 24;
    constexpr double kBases = 40;  // that the search for the least box tries, about
    double faces = 0;
    for (const Copy& copy : plan.items) {
        const auto part = static_cast<std::size_t>(copy.part);
        const double ways = static_cast<double>(plan.orientations[part]->size());
        faces += std::pow(loaded.box_volume[part], 2.0 / 3) * std::sqrt(ways / kUsualWays);
    }
    const double passes = options.minimise == Minimise::box ? kBases : 1;
    return passes * kOfFace * faces / std::pow(voxel_size(options), 1.5);
}

}  // namespace

Plan choose_grid(const LoadedJob& loaded, const Container& container, std::span<const Printer> own_printers,
                 const Workers& workers, PackOptions& options) {
    const double seconds = time_to_improve(options);
    const auto plan_for = [&](const PackOptions& grid) {
        return make_plan(loaded, container, grid, own_printers, workers);
    };
    if (seconds > 0) {
        const std::string usual = kUsualRotations;
        for (const std::string& rotations : {usual + "+box", usual}) {
            PackOptions grid = options;
            grid.voxel = options.voxel.value_or(kUsualVoxel / 2);
            grid.rotations = options.rotations.value_or(rotations);
            if (grid.voxel == options.voxel && grid.rotations == options.rotations) break;
            Plan plan = plan_for(grid);
            if (plan.memory > plan.memory_limit || !plan.keeps_all) continue;
            const bool more_ways = grid.rotations != rotations_of(options);
            if (expected_pass(loaded, plan, grid) > most_of_time(plan, options, more_ways) * seconds) continue;
            options = grid;
            return plan;
        }
    }
    options.voxel = voxel_size(options);
    options.rotations = rotations_of(options);
    return plan_for(options);
}

}  // namespace spectralpack
