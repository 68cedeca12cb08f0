#pragma once
/// The metrics of equations 2 and 4 at every candidate position of one orientation, for people who look at them; the
/// search itself asks for the best position only.

#include <cstdint>

#include "spectralpack/grid.hpp"

namespace spectralpack {

struct MetricFields {
    Grid<std::int64_t> collision;  ///< zeta
    Grid<std::int64_t> proximity;  ///< rho
};

}  // namespace spectralpack
