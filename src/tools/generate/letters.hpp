#pragma once
/// The letters of SIGGRAPH as containers (appendix B.4 of the paper): 322 x 322 x 80 mm each.

#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

/// `letter` is one of S, I, G, R, A, P, H. Closed, outward, upright on its back: x across the letter,
/// y up the letter, z through it.
Mesh letter_mesh(char letter);

}  // namespace spectralpack::tools
