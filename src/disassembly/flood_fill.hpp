#pragma once
/// Flood-fill disassembly of one copy (section 4.1, Algorithm 3), from the copy outwards: a walk over free positions,
/// from face to face, that ends as soon as it is outside.

#include <array>
#include <cstdint>
#include <vector>

#include "core/stop.hpp"
#include "disassembly/tile_map.hpp"
#include "search/placement_search.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

class FloodFill {
  public:
    /// `tiles`: free positions of the copy's voxels of this extent, itself not in the way. Outside is where its box
    /// does not meet `rest`, the box of all other voxels (of which none may lie outside the tiles' grid). When stopped
    /// a walk ends where it is, as if there were no way.
    FloodFill(FreeTileReader& tiles, const Extent& solid, const VoxelBox& rest, StopToken stop = {});

    /// A shortest way from `start`, which is free, to outside: its ends and corners, axis-parallel from one to the
    /// next. Empty when there is none. Best-first by steps gone and steps at least to go, which are exact (A*); each
    /// tile of positions is computed when first touched.
    std::vector<VoxelIndex> way_out(const VoxelIndex& start);

  private:
    static constexpr int kRows = FreeTileReader::kRows;
    struct Tile {
        FreeTileReader::Rows free;
        std::array<std::array<std::uint8_t, 64>, kRows>
            came{};  ///< 0: not visited; kStart; else 1 + the move that led here
    };
    struct Entry {
        VoxelIndex at;  ///< from the tiles' origin
        int gone = 0;
        std::uint8_t came = 0;
    };
    static constexpr std::uint8_t kStart = 7;
    static constexpr std::int64_t kPoll = 4096;  ///< positions visited between looks at the token

    /// That of a position from the tiles' origin.
    Tile& tile(const VoxelIndex& at);
    static std::uint8_t& came(Tile& tile, const VoxelIndex& at) {
        return tile.came[static_cast<std::size_t>(at.y % kRows)][static_cast<std::size_t>(at.x % 64)];
    }
    /// Steps at least to go; 0 is outside.
    int to_go(const VoxelIndex& at) const;
    std::vector<VoxelIndex> trace(VoxelIndex at);

    FreeTileReader& tiles_;
    Extent solid_;
    VoxelBox rest_;  // from the tiles' origin
    TileMap<Tile> known_;
    StopToken stop_;
    std::int64_t visited_ = 0;
};

}  // namespace spectralpack
