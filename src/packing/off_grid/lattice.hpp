#pragma once
/// Equal boxes in rows, columns and layers: what people see at once, and what a greedy packing on a grid may miss.

#include <optional>
#include <set>
#include <vector>

#include "packing/off_grid/off_grid.hpp"

namespace spectralpack {

struct LatticeCopy {
    Copy copy;
    TurnedBox turned;
    Vec3 corner;  ///< lower, of its box
};

struct Lattice {
    std::vector<LatticeCopy> copies;
    std::set<int> parts;  ///< of which they are: those that have a box of the lattice's size, and its gap
};

/// The lattice of a part of which copies are left over (of one of the first few such parts) in a tray where only what
/// was there from the start stands, where it holds more, by volume of boxes, than all that is `placed` now; of several
/// the one that holds most. It takes copies of equal boxes in their order in `wanted`.
std::optional<Lattice> find_lattice(OffGrid& off_grid, PartSurfaces& surfaces, const std::vector<Copy>& wanted,
                                    const std::vector<PlacedCopy>& placed, const std::vector<Copy>& left_over);

}  // namespace spectralpack
