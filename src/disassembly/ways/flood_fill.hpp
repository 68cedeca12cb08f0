#pragma once
/// The second half of flood-fill disassembly of one copy (section 4.1, Algorithm 3). A walk from the copy outwards, 64
/// positions at a time, has found that there is a way (disassembly/reachable_region); a short one is looked for among
/// the positions that it came to, which are few and known to be free.

#include <array>
#include <cstdint>
#include <vector>

#include "disassembly/ways/reachable_region.hpp"
#include "disassembly/ways/tile_map.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

class FloodFill {
  public:
    /// `region` stays as it is meanwhile.
    explicit FloodFill(const ReachableRegion& region, StopToken stop = {});

    /// A shortest way from `start`, which a walk of the region's has found a way from, to outside, through positions
    /// that the region has visited: its ends and corners, axis-parallel from one to the next. Empty when it was
    /// stopped. To be asked once. Best-first by steps gone and steps at least to go, which are exact (A*); of its
    /// corners then those are left out that such positions lead past.
    std::vector<VoxelIndex> way_out(const VoxelIndex& start);

  private:
    static constexpr int kRows = FreeTileReader::kRows;
    struct Tile {
        FreeTileReader::Rows open;  ///< visited by the region
        std::array<std::array<std::uint8_t, 64>, kRows>
            came{};  ///< 0: not come to; kStart; else 1 + the move that led here
    };
    struct Entry {
        VoxelIndex at;  ///< from the tiles' origin
        int gone = 0;
        std::uint8_t came = 0;
    };
    static constexpr std::uint8_t kStart = 7;
    static constexpr std::int64_t kPoll = 4096;  ///< positions between looks at the token

    /// That of a position from the tiles' origin.
    Tile& tile(const VoxelIndex& at);
    static std::uint8_t& came(Tile& tile, const VoxelIndex& at) {
        return tile.came[static_cast<std::size_t>(at.y % kRows)][static_cast<std::size_t>(at.x % 64)];
    }
    std::vector<VoxelIndex> trace(VoxelIndex at);
    std::vector<VoxelIndex> with_few_corners(const std::vector<VoxelIndex>& way) const;
    /// The corners of a leg between two positions, axis by axis, but `from`; empty where none goes that has fewer
    /// moves.
    std::vector<VoxelIndex> leg_between(const VoxelIndex& from, const VoxelIndex& to, std::size_t fewer_than) const;

    const ReachableRegion& region_;
    TileMap<Tile> known_;
    StopToken stop_;
};

}  // namespace spectralpack
