#pragma once
/// Mending of meshes as files hold them. Only what is safe is changed, and everything that is
/// changed is told in words; what cannot be mended is a warning or makes the mesh unusable.

#include <optional>
#include <string>
#include <vector>

#include "core/remarks.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct MeshRepair {
    std::vector<std::string> repairs;     ///< what was changed
    std::vector<Remark> warnings;         ///< what the user should look at
    std::optional<std::string> unusable;  ///< why the mesh encloses nothing that could be packed
    bool closed = false;                  ///< is_closed() of the result
    Box box;                              ///< bounding_box() of the result
};

/// In this order, each step only where the mesh needs it:
///  1. equal coordinates become one vertex, unused vertices go (skipped for a mesh that is `welded`
///  already);
///  2. facets of zero area go, as long as that does not open a closed mesh;
///  3. facets stored twice the same way round go, on the same condition;
///  4. border vertices nearer than 1e-5 of the size are merged if that leaves fewer border edges;
///  5. facets that disagree with their neighbours are turned if that closes the mesh;
///  6. closed groups of shells (shells whose boxes meet) of negative volume are turned outwards; an
///  open mesh of
///     negative volume is turned as a whole.
/// Vertices stay where they are and in their order. Time is linear in the mesh, whatever its
/// connectivity. Preconditions: indices in range, finite coordinates, fewer than 2^32 / 3
/// triangles. Throws Stopped once `stop` is requested; the mesh is then good for nothing.
MeshRepair repair_mesh(Mesh& mesh, bool welded = false, const StopToken& stop = {});

/// A hint where a size is implausible in millimetres: under 3 mm (inch? metre?) or over 10 m
/// (micrometre?).
std::optional<Remark> size_warning(const Box& box, double mm_per_unit);

}  // namespace spectralpack
