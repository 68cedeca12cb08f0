#pragma once
/// phi of Omega_place (equation 3, Manhattan, appendix A.1), kept up to date as objects are added and removed.
///
/// Invariant: below layer top(), at(x, y, z) = Manhattan distance in voxels to the nearest occupied voxel, everything
/// outside the grid included (above it only under a closed ceiling). From top() on nothing is known. It never exceeds
/// (min(nx, ny) + 1) / 2, the distance to the nearer side wall, which is why 16 bits do.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "core/zeroed.hpp"
#include "search/cpu/tables/changed_layers.hpp"
#include "voxel/distance_field.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

class DistanceGrid {
  public:
    DistanceGrid() = default;
    /// An empty grid with top() 0. Throws ResourceError where 16 bits would not do.
    DistanceGrid(const Extent& extent, Ceiling ceiling);

    /// Takes in what `solid` at `at` occupies; what overhangs the grid is dropped. Returns where
    /// something changed. Exact: min(phi, distance to the object), computed axis by
    /// axis (the Manhattan distance is separable), and only as far as it changes something: phi is
    /// 1-Lipschitz, so where the new object does not lower a row, it does not lower the rows behind
    /// it. Precondition: the object lies below top().
    ChangedLayers add(const BitGrid& solid, const VoxelIndex& at, const Workers& workers);

    /// A box outside of which nothing changes when what lies in `gone` goes, nor has its nearest occupied voxel there;
    /// below top(). O(its surface).
    VoxelBox reach_of(const VoxelBox& gone) const;
    /// Takes in that objects went: `reaches` are those of their boxes, before that, and `occupied` together all that is
    /// occupied now, of the grid's extent. Returns where something changed. O(voxels of the boxes; those that meet or
    /// touch count as one).
    ChangedLayers remove(const std::vector<VoxelBox>& reaches, const std::vector<const BitGrid*>& occupied,
                         const Workers& workers);

    /// Makes the values right below `top`, too: as all objects lie below top(), from the walls and in one sweep up from
    /// there. O(voxels in between).
    void raise(int top, const Workers& workers);
    int top() const { return top_; }

    const Extent& extent() const { return extent_; }
    int stride() const { return stride_; }  ///< elements from a row to the next one along y
    std::uint16_t* row(int y, int z) { return values_.data() + offset(y, z); }
    const std::uint16_t* row(int y, int z) const { return values_.data() + offset(y, z); }
    std::uint16_t at(int x, int y, int z) const { return row(y, z)[x]; }

    /// No value is above it, nor will be when top() is raised; with all layers below top() the greatest.
    int most() const { return std::max(most_, most_above_); }
    /// No value is ever above it, whatever is added or removed: that of the middle between the nearer side walls.
    int most_ever() const { return (std::min(extent_.x, extent_.y) + 1) / 2; }

    std::int64_t bytes() const { return static_cast<std::int64_t>((values_.size() + most_of_row_.size()) * 2); }

  private:
    std::size_t row_number(int y, int z) const {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(extent_.y) + static_cast<std::size_t>(y);
    }
    std::size_t offset(int y, int z) const { return row_number(y, z) * static_cast<std::size_t>(stride_); }

    int from_floor_and_ceiling(int z) const;
    void fill_row(int y, int z, int lo, int hi);
    int in_reach(const VoxelBox& face, const VoxelBox& gone) const;
    void recompute(const VoxelBox& window, const std::vector<const BitGrid*>& occupied, const Workers& workers,
                   ChangedLayers& changed);
    void note_most_of_row(int y, int z);
    void note_most();

    Extent extent_;
    Ceiling ceiling_ = Ceiling::closed;
    int stride_ = 0;
    int top_ = 0;
    int most_ = 0;        // below top_
    int most_above_ = 0;  // of what there may be above
    ZeroedVector<std::uint16_t> values_;
    std::vector<std::uint16_t> most_of_row_;
    std::vector<std::uint16_t> sides_;  // distances along x to the nearer side wall
};

}  // namespace spectralpack
