#pragma once
/// The narrow waist: packing strategies, disassembly and the cluster see only this, whatever
/// computes behind it. Every engine returns the same answers, bit for bit; they differ in speed and
/// memory only.
///
/// Definition (docs/conventions.md; section 3.1 and appendix A.1), A being one orientation:
///
///   zeta(q) = sum over x of s_A(x) s_W(x + q)
///           + sum over gap classes c and fine x of s_{A+g(c)}(x) s_{O(c)}(x + s q)    (equation 2)
///             with W the walls, container mask and keep-out, O(c) the fine voxels of class c's objects
///   rho(q)  = sum over x of s_A(x) phi(x + q), phi the Manhattan distance to Omega_place      (4)
///   best    = least (cost, orientation index, z, y, x) over candidates with zeta(q) = 0       (6)
///             that the shape admits

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/parallel.hpp"
#include "search/cost.hpp"
#include "search/shape.hpp"
#include "search/tray.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct BestPlacement {
    int index = 0;               ///< in Shape::orientations
    VoxelIndex position;         ///< q: the voxel of A's lower corner
    std::int64_t proximity = 0;  ///< rho(q)
    Cost cost;
    /// Costs at q - ex, q + ex, q - ey, q + ey, q - ez, q + ez, with phi = 0 outside the grid: the
    /// discrete gradient of section 3.2. Defined whether or not the neighbour collides.
    std::array<Cost, 6> neighbours{};

    bool operator==(const BestPlacement&) const = default;
};

struct SearchResult {
    std::optional<BestPlacement> best;  ///< none: no candidate is free (or the search was stopped)
    bool stopped = false;               ///< ended early by the stop token: `best` is not to be used
};

/// Bit (x, y, z) tells of position origin + (x, y, z): set = free. Those beyond the bits are free.
struct FreePositions {
    VoxelIndex origin;
    BitGrid free;
};

struct FreeQuery {
    std::optional<ObjectId> without{};  ///< this object is out while asking
    /// Extra positions on every side beyond those whose voxels can overlap the grid; at least 1, so
    /// that the outermost positions are wholly outside it.
    int padding = 1;
    /// Of free_tiles(): what is worked out of the tray for all that ask about it goes with the last of the readers that
    /// were made so. For many small trays.
    bool for_readers = false;
};

/// Free positions by tiles of 64 along x (bits of a word) and 8 along y, for who needs few of them: what
/// free_positions() would give. For one thread.
class FreeTileReader {
  public:
    static constexpr int kRows = 8;
    using Rows = std::array<std::uint64_t, kRows>;
    /// Bits of positions; those beyond the extent count as not free.
    struct Told {
        Rows known{}, free{};
    };

    virtual ~FreeTileReader() = default;
    virtual const VoxelIndex& origin() const = 0;
    virtual const Extent& extent() const = 0;
    /// What it takes to tell which of the positions `wanted` of a tile are free: tells of those and of whatever else is
    /// found on the way. Bit x of row y is position origin + (64 i + x, 8 j + y, z).
    virtual Told tell(int i, int j, int z, const Rows& wanted) = 0;
};

class PlacementSearch {
  public:
    virtual ~PlacementSearch() = default;

    /// The best placement of `shape` in the tray. Polls `stop` at least once per orientation.
    virtual SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                        const StopToken& stop) = 0;

    /// Positions q at which the unwidened voxels A of orientation `index` meet nothing of
    /// Omega_move (what overhangs the grid meets nothing), in voxels of dx also where the tray has finer ones: copies
    /// that share voxels of dx are in each other's way here. Per axis, with a = A's extent and n = the grid's: origin
    /// is -(a - 1) - padding, extent n + a - 1 + 2 padding.
    virtual FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) = 0;

    /// Likewise for any voxels, in tiles. The reader may be used until the tray changes. Computed whole by
    /// free_positions() unless an engine knows better.
    virtual std::unique_ptr<FreeTileReader> free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                                       const FreeQuery& query);

    virtual const char* name() const = 0;

    /// Bytes the engine holds now.
    virtual std::int64_t memory() const = 0;

    /// Gives back the memory of all that is kept to answer sooner: the next answers take longer, and are the same.
    virtual void forget() {}
};

}  // namespace spectralpack
