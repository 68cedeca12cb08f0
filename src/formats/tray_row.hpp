#pragma once
/// Where the trays of a packing stand in files that show all of them: in a row along x.

#include "spectralpack/packing.hpp"

namespace spectralpack {

inline constexpr double kTrayMargin = 20;  ///< mm between two trays

inline double tray_shift(const Packing& packing, std::size_t tray) {
    return static_cast<double>(tray) * (packing.container.size.x + kTrayMargin);
}

}  // namespace spectralpack
