#pragma once
/// A die in a box that it leaves by a way that voxels of 1 mm do not show.

#include "support/shapes.hpp"

namespace spectralpack::test {

/// 8 mm, half a voxel off the grid.
inline Mesh die_mesh() { return box_mesh({10.5, 10.5, 10.5}, {18.5, 18.5, 18.5}); }

/// Around the die, which has a tenth of a millimetre on either side, so that no voxel position is free, and
/// `room_above`. Open at +x above a sill that stands as high, mm, above the die's lower side.
inline Mesh box_with_sill(double sill, double room_above) {
    Mesh box = box_mesh({5, 5, 5}, {30, 25, 10.4});
    box = merged(box, box_mesh({5, 5, 5}, {10.4, 25, 25}));
    box = merged(box, box_mesh({5, 5, 5}, {30, 10.4, 25}));
    box = merged(box, box_mesh({5, 18.6, 5}, {30, 25, 25}));
    box = merged(box, box_mesh({5, 5, 18.5 + room_above}, {30, 25, 25}));
    return merged(box, box_mesh({19, 5, 10.4}, {30, 25, 10.5 + sill}));
}

}  // namespace spectralpack::test
