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

#include "search/placement_search.hpp"

namespace spectralpack {

class ReachableSearch final : public PlacementSearch {
  public:
    /// `engine` outlives it.
    explicit ReachableSearch(PlacementSearch& engine) : engine_(engine) {}

    /// Asks the engine. An answer that is not reachable lies in a closed pocket: the pocket is excluded, after
    /// several of one orientation all that is not reachable in it, and the engine is asked again. Further copies of
    /// the same shape start from what is excluded already while the tray only grows: what cannot be reached now never
    /// can be then.
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override;
    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        return engine_.free_positions(tray, shape, index, query);
    }
    std::unique_ptr<FreeRowReader> free_rows(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                             const FreeQuery& query) override {
        return engine_.free_rows(tray, std::move(solid), query);
    }
    const char* name() const override { return engine_.name(); }
    std::int64_t memory() const override { return engine_.memory(); }

  private:
    using Excluded = std::vector<std::shared_ptr<const BitGrid>>;

    /// None where `position` is reachable; else the positions of its pocket.
    std::optional<BitGrid> pocket(const Tray& tray, const OrientedShape& oriented, const VoxelIndex& position);
    BitGrid unreachable(const Tray& tray, const OrientedShape& oriented);
    /// The tray in the voxels that collisions are decided on: itself, or a copy of it in those that follows it.
    const Tray& finest(const Tray& tray);

    PlacementSearch& engine_;
    std::optional<Tray> finest_;            // where voxels for collisions are finer than those of positions
    std::uint64_t followed_ = 0;            // the tray that it follows
    std::uint64_t tray_ = 0, shape_ = 0;  // whose exclusions these are: copies of a part mostly come one after the other
    std::size_t journal_ = 0;             // how long the tray's journal was then
    Excluded excluded_;                   // by index of the shape's orientations; null: none
    std::uint64_t asked_ = 0;             // shapes with fresh exclusions: each is a shape of its own to the engine
};

}  // namespace spectralpack
