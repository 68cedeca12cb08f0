#pragma once
/// A mesh made fit for a benchmark (appendix B.1): judged, simplified, scaled.

#include <cstddef>
#include <string>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

struct PrepareRules {
    Vec3 tray{480, 245, 200};      ///< mm; what is larger as it lies is scaled down to fit
    double least_side = 2;         ///< mm; what fits into a cube of this side is scaled up to it
    std::size_t triangles = 4000;  ///< meshes of more are simplified
};

/// What became of a mesh.
enum class Prepared {
    kept,
    unusable,      ///< its file cannot be read, or it encloses nothing
    open,          ///< it has border edges
    inconsistent,  ///< neighbouring facets face opposite ways
    non_manifold,  ///< an edge has more than two facets
    no_volume,     ///< its signed volume is not positive
};

struct PreparedMesh {
    Prepared outcome = Prepared::kept;
    std::string detail;  ///< why it was dropped, or what simplification could not do; in words
    Mesh mesh;           ///< mm, box minimum at the origin; empty where dropped
    double scale = 1;    ///< uniform; applied
};

/// `mesh` in millimetres, after the repairs that are safe. Kept are closed, consistently oriented meshes whose
/// edges have two facets each and whose signed volume is positive; shells may meet and cross. Simplification must
/// leave all that as it is, the box to 2 % of its longest side and the volume to 3 %; where it does not, more
/// triangles are kept, in the end all of them.
PreparedMesh prepare_mesh(const Mesh& mesh, const PrepareRules& rules);

}  // namespace spectralpack
