#pragma once
/// What stands in a tray, as disassembly sees it (disassembly/body.hpp).

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "disassembly/subassembly.hpp"
#include "packing/containers/physical_walls.hpp"
#include "packing/tray/context.hpp"
#include "packing/tray/part_surfaces.hpp"

namespace spectralpack {

struct BodyOptions {
    double wall_gap = 0;  ///< mm
    std::optional<double>
        ray_spacing;  ///< mm; none: DisassemblyOptions::spacing_for() voxels that collisions are decided on
    PartSurfaces* surfaces = nullptr;
    std::vector<Body> fixed;               ///< what stands in the tray besides the copies placed, and never moves
    const PhysicalWalls* walls = nullptr;  ///< of a physical container; null: copies alone are in the way
};

class PlacedBodies {
  public:
    /// All that is referred to outlives it; `tray` holds what is `placed`.
    PlacedBodies(const BodyOptions& options, const Tray& tray, const std::vector<PlacedCopy>& placed,
                 const TrayContext& context);
    PlacedBodies(const PlacedBodies&) = delete;
    PlacedBodies& operator=(const PlacedBodies&) = delete;

    /// Names are indices into `placed`.
    const DisassemblyOptions& disassembly() const { return disassembly_; }
    /// Under an open ceiling the tray grows. Makes the grid that ways out are looked for in as high; true where it was
    /// not.
    bool follow_tray();

    /// `object` is what it is, or would be, in the tray.
    Body of(const PlacedCopy& placed, const TrayObject& object) const;
    /// The first `count` of what is placed, or all.
    std::vector<Body> placed(std::size_t count = kAll) const;
    /// Fixed copies come after all others.
    void add_fixed(std::vector<Body>& bodies) const;
    /// Fixed copies, and the walls of a physical container.
    void add_what_stays(std::vector<Body>& bodies) const;

  private:
    static constexpr auto kAll = std::numeric_limits<std::size_t>::max();

    TrayObject in_grid(const TrayObject& object) const;

    const BodyOptions& options_;
    const Tray& tray_;
    const std::vector<PlacedCopy>& placed_;
    DisassemblyOptions disassembly_;
};

}  // namespace spectralpack
