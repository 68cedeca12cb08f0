#include "search/reference/error_bound.hpp"

#include <cmath>

namespace spectralpack {

double correlation_error_bound(const Extent& grid, double norms, int terms, double unit_roundoff) {
    const double stages = std::log2(static_cast<double>(grid.count())) + 1;
    const double e = 16 * unit_roundoff * stages;
    return (4 * e + terms * unit_roundoff) * norms;
}

}  // namespace spectralpack
