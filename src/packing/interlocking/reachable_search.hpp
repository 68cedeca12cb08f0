#pragma once
/// Placement among reachable positions only (section 4.3): an engine whose best_placement() never answers with a
/// position from which the copy could not be taken out again.
///
/// Definition: a position q of an orientation is reachable if A can be moved there from outside the grid by single
/// steps along x, y and z through positions that are free among the objects (Omega_move, free_positions()), all in the
/// voxels that collisions are decided on (dx / s). The best
/// reachable placement is the best placement (conventions.md) among the candidates that are also reachable.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "packing/containers/physical_walls.hpp"
#include "search/forwarding_search.hpp"
#include "voxel/outlines.hpp"

namespace spectralpack {

class ReachableSearch : public ForwardingSearch {
  public:
    /// `engine` and `walls` outlive it. With walls, which are those of the trays that are asked about, what leaves has
    /// to pass them, too. Of larger solids a row_sample() of so many rows along walks first, whatever comes of it.
    /// `kept`: bytes that walks may remember in one search, about; the answer does not depend on it.
    explicit ReachableSearch(PlacementSearch& engine, const PhysicalWalls* walls = nullptr, int rows_along = 10,
                             std::int64_t kept = kKept)
        : ForwardingSearch(engine), walls_(walls), rows_along_(rows_along), kept_(kept) {}

    static constexpr std::int64_t kKept = std::int64_t{512} << 20;
    /// Of kKept, what walks come by in such a grid, about: of a position they keep three bits, and of few orientations
    /// they see it all.
    static std::int64_t kept_in(const Extent& grid) {
        constexpr std::int64_t kOrientations = 8, kBits = 3;
        return std::min(kKept, kOrientations * grid.count() * kBits / 8);
    }

    /// Asks the engine, which asks back of each candidate that would be the best so far whether it is reachable. Where
    /// it cannot be drawn straight out, which outlines tell, a walk outwards answers that and is remembered while the
    /// engine searches, so that each position is visited once at most as long as there is room.
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override;
    void forget() override;

  private:
    /// The tray in the voxels that collisions are decided on: itself, or a copy of it in those, with the walls, that
    /// follows it.
    const Tray& finest(const Tray& tray);

    /// Brings the outlines of what stands in it up to `fine`.
    const Outlines& outlines(const Tray& fine);

    const PhysicalWalls* walls_;
    int rows_along_;
    std::int64_t kept_;
    std::optional<Tray> finest_;  // where collisions are decided on finer voxels than positions, or with walls
    std::uint64_t followed_ = 0;  // the tray that it follows
    std::optional<Outlines> outlines_;
    std::uint64_t outlined_ = 0, outlined_version_ = 0;  // the tray whose objects these are of, and until when
};

}  // namespace spectralpack
