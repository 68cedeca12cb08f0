#pragma once
/// From which positions there is a way to outside (section 4.3): a walk over free positions, 64 side by side at a time.
/// Each word goes to its neighbours along y and z at once; along x, where little is found that they do not find, last.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/stop.hpp"
#include "disassembly/tile_map.hpp"
#include "search/placement_search.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

class ReachableRegion {
  public:
    /// Whether a straight way leads outside from a position that is free. Asked of where a walk begins and now and then
    /// on it, so that it need not go on to the end.
    using StraightOut = std::function<bool(const VoxelIndex&)>;

    /// As FloodFill. When stopped a walk ends where it is, and what has been said of positions is not to be used.
    ReachableRegion(FreeTileReader& tiles, const Extent& solid, const VoxelBox& rest, StopToken stop,
                    StraightOut straight_out = {});

    bool free(const VoxelIndex& position);
    /// On a walk so far.
    bool visited(const VoxelIndex& position);

    /// Whether there is a way from `start`, which is free, to outside, in single steps from face to face. Every
    /// position visited for that is remembered with the answer, and a walk that meets one ends there: none is visited
    /// twice.
    bool contains(const VoxelIndex& start);

    /// Around all positions visited so far.
    const VoxelBox& visited_box() const { return visited_box_; }

    /// What is remembered takes.
    std::int64_t bytes() const { return tiles_made_ * static_cast<std::int64_t>(sizeof(Tile)); }

  private:
    /// What is known of 64 positions.
    struct Word {
        std::uint64_t known = 0, free = 0;  ///< whether each is free
        std::uint64_t visited = 0;
        std::uint64_t outside = 0;   ///< of the visited: there is a way
        std::uint64_t sideways = 0;  ///< of the visited: to be gone on from along x
    };
    static constexpr int kRows = FreeTileReader::kRows;
    using Tile = std::array<Word, kRows>;
    /// Some of the positions of word i of row (y, z), from the tiles' origin.
    struct Some {
        int y = 0, z = 0, i = 0;
        std::uint64_t positions = 0;
    };
    /// What a walk has come to.
    struct Visited {
        Some some;
        Tile* tile;  // theirs
    };

    Tile& tile(int y, int z, int i);
    static Word& word(Tile& tile, int y) { return tile[static_cast<std::size_t>(y % kRows)]; }
    Word& word(int y, int z, int i) { return word(tile(y, z, i), y); }
    int to_go(int y, int z) const;
    std::uint64_t outside_along_x(int i) const;
    void reach(const Some& fresh, Tile& tile);
    void look(const Some& wanted, Tile& tile);
    void touch(const Some& neighbours, Tile& tile);
    void go_on(const Visited& from);
    void go_sideways(const Visited& where);

    FreeTileReader& tiles_;
    Extent extent_;  // of the tiles
    Extent solid_;
    VoxelBox rest_;  // from the tiles' origin
    TileMap<Tile> known_;
    std::int64_t tiles_made_ = 0;
    StopToken stop_;
    StraightOut straight_out_;
    VoxelBox visited_box_;

    // The walk under way.
    bool outside_ = false;
    std::vector<Visited> walked_;
    std::vector<std::vector<Visited>> open_;  // by steps at least to go
    std::size_t least_ = 0;                   // of those that hold something
    std::vector<Visited> sideways_;
};

}  // namespace spectralpack
