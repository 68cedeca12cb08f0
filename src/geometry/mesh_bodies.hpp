#pragma once
/// Bodies: what of a closed mesh hangs together as matter.

#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

/// The bodies of a closed mesh, each a mesh of its own, in order of their first triangles. Shells whose surfaces touch
/// or cross are one body; a shell within another is of its body, as a cavity is.
std::vector<Mesh> bodies_of(const Mesh& mesh);

}  // namespace spectralpack
