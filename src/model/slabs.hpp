#pragma once
/// A tray in slabs, as it is dug out from above: the top views of the operator's sheet, and layers drawn apart.

#include <string>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

struct Slab {
    double low = 0, high = 0;     ///< mm above the floor
    std::vector<int> placements;  ///< whose boxes' middles lie in it, ascending
};

/// From the top down: about 50 mm each, six at most, cut on 5 mm; a slab in which no copy has its middle is joined to
/// the next. `boxes`: by placement. Empty without copies.
std::vector<Slab> slabs_of(const std::vector<Box>& boxes);

/// "A" is the top.
std::string slab_name(std::size_t slab);

}  // namespace spectralpack
