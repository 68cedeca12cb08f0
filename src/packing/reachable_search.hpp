#pragma once
/// Placement among reachable positions only (section 4.3): an engine whose best_placement() never answers with a
/// position from which the copy could not be taken out again.
///
/// Definition: a position q of an orientation is reachable if A can be moved there from outside the grid by single
/// steps along x, y and z through positions that are free among the objects (Omega_move, free_positions()), all in the
/// voxels that collisions are decided on (dx / s). The best
/// reachable placement is the best placement (conventions.md) among the candidates that are also reachable.

#include <memory>
#include <optional>
#include <vector>

#include "packing/physical_walls.hpp"
#include "search/forwarding_search.hpp"

namespace spectralpack {

class ReachableSearch final : public ForwardingSearch {
  public:
    /// `engine` and `walls` outlive it. With walls, which are those of the trays that are asked about, what leaves has
    /// to pass them, too.
    explicit ReachableSearch(PlacementSearch& engine, const PhysicalWalls* walls = nullptr)
        : ForwardingSearch(engine), walls_(walls) {}

    /// Asks the engine, which asks back of each candidate that would be the best so far whether it is reachable. A walk
    /// outwards answers that and is remembered while the engine searches, so that each position is visited once at
    /// most.
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override;

  private:
    /// The tray in the voxels that collisions are decided on: itself, or a copy of it in those, with the walls, that
    /// follows it.
    const Tray& finest(const Tray& tray);

    const PhysicalWalls* walls_;
    std::optional<Tray> finest_;  // where collisions are decided on finer voxels than positions, or with walls
    std::uint64_t followed_ = 0;  // the tray that it follows
};

}  // namespace spectralpack
