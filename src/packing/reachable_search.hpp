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
#include "search/placement_search.hpp"

namespace spectralpack {

class ReachableSearch final : public PlacementSearch {
  public:
    /// `engine` and `walls` outlive it. With walls, which are those of the trays that are asked about, what leaves has
    /// to pass them, too.
    explicit ReachableSearch(PlacementSearch& engine, const PhysicalWalls* walls = nullptr)
        : engine_(engine), walls_(walls) {}

    /// Asks the engine, which asks back of each candidate that would be the best so far whether it is reachable. A walk
    /// outwards answers that and is remembered while the engine searches, so that each position is visited once at
    /// most.
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override;
    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        return engine_.free_positions(tray, shape, index, query);
    }
    std::unique_ptr<FreeTileReader> free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                               const FreeQuery& query) override {
        return engine_.free_tiles(tray, std::move(solid), query);
    }
    const char* name() const override { return engine_.name(); }
    std::int64_t memory() const override { return engine_.memory(); }

  private:
    /// The tray in the voxels that collisions are decided on: itself, or a copy of it in those, with the walls, that
    /// follows it.
    const Tray& finest(const Tray& tray);

    PlacementSearch& engine_;
    const PhysicalWalls* walls_;
    std::optional<Tray> finest_;  // where collisions are decided on finer voxels than positions, or with walls
    std::uint64_t followed_ = 0;  // the tray that it follows
};

}  // namespace spectralpack
