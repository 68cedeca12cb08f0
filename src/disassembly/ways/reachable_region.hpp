#pragma once
/// From which positions there is a way to outside (section 4.3): a walk over free positions, 64 side by side at a time.
/// Each word goes to its neighbours along y and z at once; along x, where little is found that they do not find, last.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "disassembly/ways/tile_map.hpp"
#include "search/placement_search.hpp"
#include "spectralpack/stop.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

class ReachableRegion {
  public:
    /// Whether a straight way leads outside from a position that is free. Asked of where a walk begins and now and then
    /// on it, so that it need not go on to the end.
    using StraightOut = std::function<bool(const VoxelIndex&)>;

    /// `tiles`: free positions of a copy's voxels of this extent, itself not in the way. Outside is where its box does
    /// not meet `rest`, the box of all other voxels (of which none may lie outside the tiles' grid). When stopped a
    /// walk ends where it is, and what has been said of positions is not to be used.
    ReachableRegion(FreeTileReader& tiles, const Extent& solid, const VoxelBox& rest, StopToken stop,
                    StraightOut straight_out = {});

    /// Positions that are told of, as tiles are: origin() + (x, y, z), 0 <= (x, y, z) < extent().
    const VoxelIndex& origin() const { return tiles_.origin(); }
    const Extent& extent() const { return extent_; }

    /// Finds out at once which of these positions are free: sooner than one by one.
    void look_around(const VoxelBox& positions);
    /// Free, and not in a closed region that a walk found closed.
    bool free(const VoxelIndex& position);
    /// On a walk so far that led outside.
    bool visited(const VoxelIndex& position) const;
    /// Likewise of positions 64 i .. 64 i + 63, from origin(), of layer z and of the 8 rows that y is one of.
    FreeTileReader::Rows visited_rows(int i, int y, int z) const;

    /// Whether there is a way from `start`, which nothing is in the way of, to outside, in single steps from face to
    /// face. Every position visited for that is remembered with the answer, and a walk that meets one ends there: none
    /// is visited twice.
    bool contains(const VoxelIndex& start);
    /// Steps at least from a position, from origin(), to outside; 0 is outside.
    int to_go(const VoxelIndex& at) const;

    /// Around all positions visited so far.
    const VoxelBox& visited_box() const { return visited_box_; }

    /// What is remembered takes.
    std::int64_t bytes() const { return known_.bytes(); }

  private:
    static constexpr int kRows = FreeTileReader::kRows;
    /// What is known of 64 positions. There are millions of these, so they say much in few bits: of what the walk under
    /// way has visited nothing is known, and once it ends that stays free and visited which has a way. A closed region
    /// is as good as occupied: no later walk comes near it.
    struct Word {
        std::uint64_t known = 0, free = 0;  ///< whether each is free
        std::uint64_t visited = 0;

        std::uint64_t outside() const { return visited & known & free; }
        std::uint64_t on_walk() const { return visited & ~known; }
    };
    struct Tile {
        int i, y, z;  ///< word i of rows y .. y + 7 of layer z, from the tiles' origin
        bool on_walk = false;
        std::uint8_t onward = 0, sideways = 0;  ///< rows that are to be gone on from along y and z, and along x
        std::array<Word, kRows> words{};

        /// All of it is known, and none of it free.
        bool closed() const {
            return std::ranges::all_of(words, [](const Word& w) { return (~w.known | w.free) == 0; });
        }
    };
    static_assert(kRows <= 8);
    /// Row y of a tile.
    struct Place {
        Tile* tile;
        int y;

        Word& word() const { return tile->words[static_cast<std::size_t>(y % kRows)]; }
        /// Among those of a tile.
        std::uint8_t bit() const { return static_cast<std::uint8_t>(1 << (y % kRows)); }
    };

    Place place(int i, int y, int z);
    int to_go(int y, int z) const;
    std::uint64_t outside_along_x(int i) const;
    void reach(const Place& at, std::uint64_t fresh);
    bool look(const Place& at, std::uint64_t wanted);
    void touch(const Place& at, std::uint64_t neighbours);
    void go_on(const Place& from);
    void go_sideways(const Place& from);
    void end_walk();
    bool let_go_if_closed(const Tile& tile);

    FreeTileReader& tiles_;
    Extent extent_;  // of the tiles
    Extent solid_;
    VoxelBox rest_;  // from the tiles' origin
    TileMap<Tile> known_;
    Tile closed_{};  // stands for all such, wherever they are
    StopToken stop_;
    StraightOut straight_out_;
    VoxelBox visited_box_;

    /// The walk under way: what it has still to go on from is in the lists once each.
    struct Walk {
        bool outside = false;
        std::int64_t reached = 0;
        std::vector<Tile*> tiles;              ///< that it has come to
        std::vector<std::vector<Place>> open;  ///< with onward positions, by steps at least to go
        std::size_t least = 0;                 ///< of those that hold something
        std::vector<Place> sideways;
    };
    Walk walk_;
};

}  // namespace spectralpack
