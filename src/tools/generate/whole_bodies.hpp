#pragma once
/// Bodies that are made to be cut up, in the manner of those in the paper's figure 16, which are not available.

#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

/// Something like a sitting rabbit, 100 x 66 x 123 mm, its trunk and head hollow.
Mesh bunny_body();

/// Ten balls, six of them in a ring, joined by rods.
Mesh molecule_body();

/// Moved to where its box minimum is the origin, as parts are written.
Mesh at_origin(const Mesh& mesh);

}  // namespace spectralpack::tools
