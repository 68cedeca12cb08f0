#pragma once
/// Bodies that are made to be cut up: of about the size and the build of those in the paper's figure 16.

#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

/// Something like a sitting rabbit, about 100 x 70 x 120 mm.
Mesh bunny_body();

/// Ten balls, six of them in a ring, joined by rods.
Mesh molecule_body();

}  // namespace spectralpack::tools
