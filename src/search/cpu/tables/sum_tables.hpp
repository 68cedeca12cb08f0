#pragma once
/// Prefix sums of phi, or of phi pooled over several positions, along each axis, so that the sum over a run of
/// voxels is the difference of two loads whatever its length.
///
/// Elements are T, 16 bits or bytes; b is their bits. Bytes serve where no phi is above kMostPooled.
/// With the window W, one voxel, a quad of 1 x 2 x 2 or a block of P^3 (P = 4), phi_W(X) = min of phi(X + d) over d in
/// W with X + d in the grid; where free positions keep off occupied voxels ("disjoint"), over those with phi(X + d) > 0
/// only, and kMostPooled where there are none or all are farther.
/// Invariant: table a at X less table a at Y = sum of phi_W(X - i e_a) over 1 <= i <= X_a - Y_a, modulo 2^b, for any X
/// and Y < X on a line along axis a of voxels below layer top(). Exact as long as the true sum is below 2^b;
/// loads.cpp splits what is not. Above top() nothing is right: with a steep height penalty nobody asks for
/// that part of a tray.
///
/// phi_W bounds rho from below on a whole window of positions: for every candidate q + d with d in W,
///   rho(q + d) = sum over x in A of phi(x + q + d) >= sum over x in A of phi_W(x + q),
/// because x + q + d lies in the grid and is one of the voxels phi_W(x + q) is the least of (disjoint:
/// a free q + d has phi > 0 there, so that voxel is among those that count).
/// Blocks are only asked for at multiples of P, so that an element X lies at (X % P) * phase + X / P of its row:
/// consecutive blocks are consecutive in memory.
/// Quads lie as single voxels do, so that the same loads serve both.
/// Layers of the three tables alternate, so that those above top(), never written, take no memory.

#include <cstdint>
#include <limits>

#include "core/parallel.hpp"
#include "core/zeroed.hpp"
#include "search/cpu/tables/changed_layers.hpp"
#include "search/cpu/tables/distance_grid.hpp"

namespace spectralpack {

/// Where in the tables what lies, in elements of whatever width.
class SumLayout {
  public:
    SumLayout() = default;
    /// `block`: 1 or kPooledBlock, the window's along x. Throws ResourceError when an offset would not fit 31 bits.
    SumLayout(const Extent& grid, int block);

    static constexpr int kPooledBlock = 4;
    /// Windows.
    static constexpr Extent kVoxel{1, 1, 1}, kQuad{1, 2, 2}, kBlock{kPooledBlock, kPooledBlock, kPooledBlock};

    /// Where displacement d along `axis` lies from a base; d >= 0.
    std::int32_t offset(int axis, const VoxelIndex& d) const {
        return static_cast<std::int32_t>(axis * table_ + row(d.y, d.z) + within(d.x));
    }
    /// Where d + length e_axis lies, `from` being where d does.
    std::int32_t further(int axis, const VoxelIndex& d, std::int32_t from, int length) const {
        switch (axis) {
            case 0:
                return from + within(d.x + length) - within(d.x);
            case 1:
                return from + length * stride_;
            default:
                return from + static_cast<std::int32_t>(length * layer_);
        }
    }

  protected:
    /// Of all three tables.
    std::int64_t elements() const;
    std::int64_t row(int y, int z) const { return z * layer_ + y * stride_; }
    std::int64_t in_pooled(int y, int z) const { return z * table_ + y * stride_; }
    int within(int x) const { return (x & (block_ - 1)) * phase_ + (x >> shift_); }

    Extent grid_;
    int block_ = 1, shift_ = 0;  // block_ = 2^shift_
    int phase_ = 0;              // elements of one phase of a row
    int stride_ = 0;             // elements of a row
    std::int64_t table_ = 0;     // elements of a table's layer
    std::int64_t layer_ = 0;     // of all three tables'
};

/// T: std::uint16_t, or std::uint8_t where phi is small.
template <class T>
class SumTables : public SumLayout {
  public:
    SumTables() = default;
    /// `window`: kVoxel, kQuad or kBlock. top() is 0.
    SumTables(const Extent& grid, const Extent& window, bool disjoint);

    static constexpr bool kBytes = sizeof(T) == 1;
    /// No pooled value is above it where `disjoint`, nor any of bytes, of which runs of 12 voxels and less are not
    /// split.
    static constexpr int kMostPooled = kBytes ? 21 : 64;
    /// What an element holds: sums up to it are exact.
    static constexpr int kRange = std::numeric_limits<T>::max();

    /// Takes note that phi changed within `changed`; the tables are not right before they follow().
    void note(const ChangedLayers& changed);
    /// Makes the tables right below layer `top`, or top() if that is higher, which it becomes. O(voxels that changed,
    /// and those next to them in rows and columns).
    void follow(const DistanceGrid& phi, int top, const Workers& workers);
    int top() const { return top_; }

    std::int64_t bytes() const { return static_cast<std::int64_t>((values_.size() + pooled_.size()) * sizeof(T)); }

    /// The element of position (block bx, y, z) in table 0; displacements are added to it as
    /// offsets.
    const T* base(int bx, int y, int z) const { return values_.data() + row(y, z) + bx; }

  private:
    void refresh(const DistanceGrid& phi, const ChangedLayers& changed, int top, const Workers& workers);
    const T* pooled_row(const DistanceGrid& phi, int y, int z) const;
    void sum_along(T* out, const T* from, int lo, int hi) const;
    void pool(const DistanceGrid& phi, const VoxelBox& layer);
    void pool_quads(const DistanceGrid& phi, const VoxelBox& layer);
    void pool_blocks(const DistanceGrid& phi, const VoxelBox& layer);
    void copy(const DistanceGrid& phi, const VoxelBox& layer);
    void sum_layer(const DistanceGrid& phi, const VoxelBox& layer);
    void sum_columns(const DistanceGrid& phi, const VoxelBox& box, int top, const Workers& workers);
    template <class Visit>
    void for_each_stretch(int lo, int hi, const Visit& visit) const;

    // Apart, values count from 1, and the 0 of an occupied voxel wraps around to the greatest.
    std::uint16_t floor() const { return disjoint_ ? 1 : 0; }
    std::uint16_t most() const;

    Extent window_ = kVoxel;
    bool disjoint_ = false;
    int top_ = 0;
    ChangedLayers noted_;  // of phi_W, since the tables followed
    ZeroedVector<T> values_;
    ZeroedVector<T> pooled_;  // phi_W; empty where phi is it, in as many bits
};

}  // namespace spectralpack
