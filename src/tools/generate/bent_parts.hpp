#pragma once
/// Parts bent from bars and tubes: what hangs together with others of its kind. `size`: about the
/// longest side in mm; what else there is to choose, the dice choose. All are closed, outward and free
/// of self-intersections.

#include "tools/generate/dice.hpp"

namespace spectralpack::tools {

Mesh ring(Dice& dice, double size);       ///< plain torus
Mesh link(Dice& dice, double size);       ///< oval chain link
Mesh curb_link(Dice& dice, double size);  ///< chain link, twisted
Mesh poly_ring(Dice& dice, double size);  ///< ring with corners
Mesh c_hook(Dice& dice, double size);     ///< ring with a gap
Mesh j_hook(Dice& dice, double size);     ///< walking stick
Mesh s_hook(Dice& dice, double size);
Mesh clip(Dice& dice, double size);    ///< C of flat stock
Mesh handle(Dice& dice, double size);  ///< U of round stock
Mesh spring(Dice& dice, double size);  ///< helix
Mesh knot(Dice& dice, double size);    ///< closed torus knot
Mesh elbow(Dice& dice, double size);   ///< bent pipe

/// Torus with a bent, stretched and swaying centre line and an oval section; 48 times 14 quads.
Mesh distorted_torus(Dice& dice, double size);

}  // namespace spectralpack::tools
