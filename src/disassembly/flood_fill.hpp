#pragma once
/// Flood-fill disassembly of one copy (section 4.1, Algorithm 3), from the copy outwards: a walk over free positions,
/// from face to face, that ends as soon as it is outside.

#include <vector>

#include "core/stop.hpp"
#include "search/placement_search.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

class FloodFill {
  public:
    /// `rows`: free positions of the copy's voxels of this extent, itself not in the way. Outside is where its box
    /// does not meet `rest`, the box of all other voxels (of which none may lie outside the rows' grid). When stopped a
    /// walk ends where it is, as if there were no way.
    FloodFill(FreeRowReader& rows, const Extent& solid, const VoxelBox& rest, StopToken stop = {});

    /// A shortest way from `start`, which is free, to outside: its ends and corners, axis-parallel from one to the
    /// next. Empty when there is none. Best-first by steps gone and steps at least to go, which are exact (A*); each word
    /// of positions is computed when first touched.
    std::vector<VoxelIndex> way_out(const VoxelIndex& start);

  private:
    struct Row {
        std::vector<std::uint64_t> free;
        std::vector<bool> computed;        ///< which words of `free` are
        std::vector<std::uint8_t> came;    ///< 0: not visited; kStart; else 1 + the move that led here
    };
    struct Entry {
        VoxelIndex at;  ///< from the rows' origin
        int gone = 0;
        std::uint8_t came = 0;
    };
    static constexpr std::uint8_t kStart = 7;
    static constexpr std::int64_t kPoll = 4096;  ///< positions visited between looks at the token

    Row& row(int y, int z);
    bool is_free(Row& row, const VoxelIndex& at);
    /// Steps at least to go; 0 is outside.
    int to_go(const VoxelIndex& at) const;
    std::vector<VoxelIndex> trace(VoxelIndex at);

    FreeRowReader& rows_;
    Extent solid_;
    VoxelBox rest_;                 // from the rows' origin
    std::vector<std::int32_t> of_;  // index into known_ by z * ny + y, -1: not computed
    std::vector<Row> known_;
    StopToken stop_;
    std::int64_t visited_ = 0;
};

}  // namespace spectralpack
