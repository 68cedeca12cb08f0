#pragma once
/// Polyhedra of a few large faces, convex and not, as the literature on packing polyhedra uses them. `size`: about the
/// longest side in mm; what else there is to choose, the dice choose. All are closed, outward and free of
/// self-intersections.

#include "tools/generate/dice.hpp"

namespace spectralpack::tools {

// Convex.
Mesh tetrahedron(Dice& dice, double size);
Mesh pyramid(Dice& dice, double size);    ///< over four or five corners, its tip off the middle
Mesh frustum(Dice& dice, double size);    ///< a pyramid without its tip
Mesh bipyramid(Dice& dice, double size);  ///< two unequal pyramids base to base

// Not convex.
Mesh twisted_prism(Dice& dice, double size);  ///< its lid turned against its foot, its sides folded inwards
Mesh dart(Dice& dice, double size);           ///< two pyramids over an arrowhead
Mesh star(Dice& dice, double size);           ///< two pyramids over a star

}  // namespace spectralpack::tools
