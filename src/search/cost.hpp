#pragma once
/// The cost sigma = rho + h (equations 4 to 6) and the total order in which "best" is decided. Shared by all
/// engines so that they round alike.

#include <compare>
#include <cstdint>
#include <vector>

#include "voxel/grid.hpp"

namespace spectralpack {

enum class HeightAt {
    bottom,  ///< sigma = rho + H[q_z], H[z] = p (z / nz)^3: the paper's
    top,     ///< (q_z + the object's layers, rho), compared lexicographically
};

struct CostModel {
    double height_penalty = 4;  ///< p of equation 5
    HeightAt height_at = HeightAt::bottom;
};

/// H[z] for z in [0, nz): p * t * t * t with t = z / nz (equation 5). `reference_layers` is nz.
double height_penalty_at(const CostModel& model, int z, int reference_layers);

/// The part of the order that is a cost: bottom: (sigma, 0); top: (top layer, rho).
struct Cost {
    double primary = 0;
    std::int64_t secondary = 0;

    auto operator<=>(const Cost&) const = default;
};

/// Cost of an object of `layers` layers whose lower corner is in layer z with proximity rho.
Cost cost_of(const CostModel& model, int z, int layers, int reference_layers, std::int64_t rho);

}  // namespace spectralpack
