#pragma once
/// The cost sigma = rho + h (equations 4 to 6) and the total order in which "best" is decided.
/// Shared by all engines so that they round alike.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spectralpack {

enum class HeightAt {
    bottom,  ///< sigma = rho + H[q_z], H[z] = p (z / nz)^3: the paper's
    top,     ///< (q_z + the object's layers, rho), compared lexicographically
};

/// Layers in which the lower corner of an orientation may lie: where others are closed (a cap on what a layer holds),
/// their positions are no candidates.
struct AllowedLayers {
    std::vector<std::vector<bool>> by_index;  ///< by index in Shape::orientations and layer; beyond the end: closed

    bool at(int index, int z) const {
        const std::vector<bool>& layers = by_index[static_cast<std::size_t>(index)];
        return static_cast<std::size_t>(z) < layers.size() && layers[static_cast<std::size_t>(z)];
    }
};

struct CostModel {
    double height_penalty = 4;  ///< p of equation 5
    HeightAt height_at = HeightAt::bottom;
    const AllowedLayers* allowed = nullptr;  ///< null: all layers; outlives the search it is for

    bool allows(int index, int z) const { return !allowed || allowed->at(index, z); }
};

/// H[z] for z in [0, nz): p * t * t * t with t = z / nz (equation 5). `reference_layers` is nz.
/// Outside that range the same polynomial.
inline double height_penalty_at(const CostModel& model, int z, int reference_layers) {
    const double t = static_cast<double>(z) / static_cast<double>(reference_layers);
    return model.height_penalty * t * t * t;
}

/// The part of the order that is a cost: bottom: (sigma, 0); top: (top layer, rho).
struct Cost {
    double primary = 0;
    std::int64_t secondary = 0;

    auto operator<=>(const Cost&) const = default;
};

/// Cost of an object of `layers` layers whose lower corner is in layer z with proximity rho.
/// Inline: engines ask for millions, and the compiler keeps H[z] for a whole layer.
inline Cost cost_of(const CostModel& model, int z, int layers, int reference_layers, std::int64_t rho) {
    if (model.height_at == HeightAt::top) return {static_cast<double>(z + layers), rho};
    return {static_cast<double>(rho) + height_penalty_at(model, z, reference_layers), 0};
}

}  // namespace spectralpack
