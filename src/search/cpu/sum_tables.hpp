#pragma once
/// Prefix sums of phi, or of phi pooled over blocks, along each axis, so that the sum over a run of
/// voxels is the difference of two loads whatever its length.
///
/// Elements are T, 16 bits or, of values that are small, bytes; b is their bits.
/// With block size P (1 or 4), phi_P(X) = min of phi(X + d) over d in [0, P)^3 with X + d in
/// the grid; where free positions keep off occupied voxels ("apart"), over those with phi(X + d) > 0
/// only, and kMostPooled where there are none or all are farther.
/// Invariant: table a at X = sum of phi_P(X - i e_a) over 1 <= i <= X_a, modulo 2^b.
/// Differences are exact as long as the true sum is below 2^b; plan.cpp splits what is not.
///
/// phi_P bounds rho from below on a whole block of positions: for every candidate q + d with d in
/// [0, P)^3,
///   rho(q + d) = sum over x in A of phi(x + q + d) >= sum over x in A of phi_P(x + q),
/// because x + q + d lies in the grid and is one of the voxels phi_P(x + q) is the least of (apart:
/// a free q + d has phi > 0 there, so that voxel is among those that count).
/// Positions are then only asked for at multiples of P, so that an element X lies at (X % P) *
/// phase + X / P of its row: consecutive blocks are consecutive in memory.

#include <cstdint>
#include <limits>
#include <vector>

#include "core/parallel.hpp"
#include "search/cpu/distance_grid.hpp"

namespace spectralpack {

/// Where in the tables what lies, in elements of whatever width.
class SumLayout {
  public:
    SumLayout() = default;
    /// `block`: 1 or kPooledBlock. Throws ResourceError when an offset would not fit 31 bits.
    SumLayout(const Extent& grid, int block);

    static constexpr int kPooledBlock = 4;

    bool operator==(const SumLayout&) const = default;

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
                return from + length * layer_;
        }
    }

  protected:
    std::int64_t row(int y, int z) const { return (static_cast<std::int64_t>(z) * (grid_.y + 1) + y) * stride_; }
    int within(int x) const { return (x & (block_ - 1)) * phase_ + (x >> shift_); }

    Extent grid_;
    int block_ = 1, shift_ = 0;  // block_ = 2^shift_
    int phase_ = 0;              // elements of one phase of a row
    int stride_ = 0;             // elements of a row
    int layer_ = 0;              // elements of a layer
    std::int64_t table_ = 0;
};

/// T: std::uint16_t, or std::uint8_t where no phi is above kMostPooled.
template <class T>
class SumTables : public SumLayout {
  public:
    SumTables() = default;
    /// Not right before the first update().
    SumTables(const Extent& grid, int block, bool apart);

    /// No pooled value is above it where `apart`. Of bytes: runs of 12 voxels and less are not split.
    static constexpr int kMostPooled = sizeof(T) == 1 ? 21 : 64;
    /// What an element holds: sums up to it are exact.
    static constexpr int kRange = std::numeric_limits<T>::max();

    /// Makes the tables right after phi changed within `changed`.
    void update(const DistanceGrid& phi, const VoxelBox& changed, const Workers& workers);

    bool operator==(const SumTables&) const = default;

    std::int64_t bytes() const { return static_cast<std::int64_t>((values_.size() + pooled_.size()) * sizeof(T)); }

    /// The element of position (block bx, y, z) in table 0; displacements are added to it as
    /// offsets.
    const T* base(int bx, int y, int z) const { return values_.data() + row(y, z) + bx; }

  private:
    const T* pooled_row(const DistanceGrid& phi, int y, int z) const;
    void sum_along(T* out, const T* from, int x) const;
    void pool(const DistanceGrid& phi, const VoxelBox& box, const Workers& workers);
    void narrow(const DistanceGrid& phi, const VoxelBox& box);

    bool apart_ = false;
    std::vector<T> values_;
    std::vector<T> pooled_;  // phi_P, laid out as a table; empty where phi is it, in as many bits
};

}  // namespace spectralpack
