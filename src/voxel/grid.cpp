#include "spectralpack/grid.hpp"

#include "core/checked.hpp"

namespace spectralpack {

std::int64_t Extent::count() const { return checked_product({x, y, z}); }

}  // namespace spectralpack
