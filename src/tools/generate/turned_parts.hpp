#pragma once
/// Parts as from a lathe, and gears. `size`: about the longest side in mm; what else there is to
/// choose, the dice choose. All are closed, outward and free of self-intersections.

#include "tools/generate/dice.hpp"

namespace spectralpack::tools {

Mesh washer(Dice& dice, double size);   ///< flat ring
Mesh bushing(Dice& dice, double size);  ///< sleeve with a flange
Mesh pin(Dice& dice, double size);      ///< bolt with a head
Mesh knob(Dice& dice, double size);     ///< handle with lobes
Mesh gear(Dice& dice, double size);     ///< spur gear with a bore
Mesh pipe(Dice& dice, double size);     ///< thin tube
Mesh cup(Dice& dice, double size);      ///< thin, with a floor
Mesh bowl(Dice& dice, double size);     ///< thin and wide, with a floor
Mesh funnel(Dice& dice, double size);   ///< thin, open at both ends

}  // namespace spectralpack::tools
