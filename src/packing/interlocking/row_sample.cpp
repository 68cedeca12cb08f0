#include "packing/interlocking/row_sample.hpp"

#include <algorithm>

namespace spectralpack {

BitGrid row_sample(const BitGrid& solid, int rows_along) {
    const Extent& n = solid.extent();
    const int step = std::max(1, std::max({n.x, n.y, n.z}) / rows_along);
    BitGrid sample(n);
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            if ((y + z) % step == 0) std::copy_n(solid.row(y, z), solid.words_per_row(), sample.row(y, z));
        }
    }
    return sample;
}

}  // namespace spectralpack
