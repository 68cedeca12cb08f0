#pragma once
/// Copies that stand in a tray from the start and never move.

#include <memory>

#include "core/parallel.hpp"
#include "disassembly/body.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack {

struct FixedCopy {
    int tray = 0;
    std::shared_ptr<const Mesh> mesh;  ///< in the mesh file's own coordinates
    Transform transform;               ///< to the container's
    double gap = 0;                    ///< mm; one of the tray's gap classes
};

/// Puts it into the tray. `mesh`: where it stands, mm. The grid's lower corner is `wall_gap` inside the container.
Body stand_fixed(const Mesh& mesh, double gap, Tray& tray, double wall_gap, const Workers& workers);

}  // namespace spectralpack
