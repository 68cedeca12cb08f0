#pragma once
/// How the judge works (spectralpack/check.hpp): distances are decided by its own kernel for triangles at the leaves of
/// FCL's trees of boxes (nearness.hpp), insides by its own winding count in double precision. Where there is a
/// disassembly plan it is replayed by exact sweeps (sweep.hpp).

#include <memory>
#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/check.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack {

/// `meshes`: by part, in the mesh file's own coordinates. Nested means inside *material*: a copy in another's
/// closed hollow or in a cavity is fine; a copy in solid matter is not, even if no triangles meet. A mesh that is
/// not closed has a surface but no inside; the listener is warned. How overlap is decided: overlap.hpp.
/// Meshes of parts without placements may be null. Does not depend on the number of threads. Throws InternalError where
/// a placed part has no mesh.
CheckReport check_packing(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                          const Workers& workers, Listener& listener, const StopToken& stop);

}  // namespace spectralpack
