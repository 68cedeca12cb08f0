#pragma once
/// Parts with flat, axis-aligned faces. `size`: about the longest side in mm; what else there is to
/// choose, the dice choose. All are closed, outward and free of self-intersections.

#include "tools/generate/dice.hpp"

namespace spectralpack::tools {

Mesh bracket(Dice& dice, double size);        ///< two plates at a right angle, with slots and a rib
Mesh channel(Dice& dice, double size);        ///< U profile
Mesh l_block(Dice& dice, double size);        ///< thick L
Mesh tee(Dice& dice, double size);            ///< T profile
Mesh steps(Dice& dice, double size);          ///< stairs
Mesh drilled_block(Dice& dice, double size);  ///< block with a square hole
Mesh window_plate(Dice& dice, double size);   ///< flat plate with rows of windows
Mesh tray(Dice& dice, double size);           ///< case without a lid
Mesh wedge(Dice& dice, double size);          ///< door stop

Mesh flat_frame(Dice& dice, double size);  ///< picture frame
Mesh ladder(Dice& dice, double size);      ///< frame with rungs
Mesh cage(Dice& dice, double size);        ///< the edges of a block as bars
Mesh basket(Dice& dice, double size);      ///< case without a lid, with windows in its walls

}  // namespace spectralpack::tools
