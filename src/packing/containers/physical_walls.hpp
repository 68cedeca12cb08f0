#pragma once
/// A physical container as one more part that stands in the tray and never moves (model/physical_surfaces.hpp): what
/// leaves, leaves upwards.

#include "core/parallel.hpp"
#include "disassembly/body.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// As its surfaces and as voxels of `grid`, whose lower corner is `corner`: those wholly outside the container's box
/// (beside it and below), not wholly inside a container mesh, or entered by a keep-out. Layers that reach above the
/// container's top hold keep-outs alone.
Body standing_walls(const Container& container, const TraySetup& grid, const Vec3& corner, const Workers& workers);

/// The same for a tray's grid, which it makes larger, so that there are voxels outside the container all round.
struct PhysicalWalls {
    Body part;
    TraySetup grid;  ///< without gap classes of its own: those of the tray
    Vec3 corner;     ///< its lower one, mm
    int margin = 0;  ///< voxels that `grid` has more on every side but above

    /// An object of the tray's grid, in this one.
    TrayObject moved(TrayObject object) const;
};

/// Its margin, in voxels of `voxel_size` mm.
int walls_margin(double voxel_size, double wall_gap);

/// `tray`: in the voxels that collisions are decided on (finest_setup()), its lower corner `wall_gap` mm inside the
/// container. Precondition: the container has a height.
PhysicalWalls physical_walls(const Container& container, const TraySetup& tray, double wall_gap,
                             const Workers& workers);

}  // namespace spectralpack
