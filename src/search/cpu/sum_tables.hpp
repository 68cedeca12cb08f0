#pragma once
/// Prefix sums of phi, or of phi pooled over blocks, along each axis, so that the sum over a run of
/// voxels is the difference of two loads whatever its length.
///
/// With block size P (1 or 4), phi_P(X) = min of phi(X + d) over d in [0, P)^3 with X + d in
/// the grid; where free positions keep off occupied voxels ("apart"), over those with phi(X + d) > 0
/// only, and kMostPooled where there are none or all are farther.
/// Invariant: table a at X = sum of phi_P(X - i e_a) over 1 <= i <= X_a, modulo 2^16.
/// Differences are exact as long as the true sum is below 65536; plan.cpp splits what is not.
///
/// phi_P bounds rho from below on a whole block of positions: for every candidate q + d with d in
/// [0, P)^3,
///   rho(q + d) = sum over x in A of phi(x + q + d) >= sum over x in A of phi_P(x + q),
/// because x + q + d lies in the grid and is one of the voxels phi_P(x + q) is the least of (apart:
/// a free q + d has phi > 0 there, so that voxel is among those that count).
/// Positions are then only asked for at multiples of P, so that an element X lies at (X % P) *
/// phase + X / P of its row: consecutive blocks are consecutive in memory.

#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "search/cpu/distance_grid.hpp"

namespace spectralpack {

class SumTables {
  public:
    SumTables() = default;
    /// `block`: 1 or kPooledBlock. Throws ResourceError when an offset would not fit 31 bits. Not right before the
    /// first update().
    SumTables(const Extent& grid, int block, bool apart);

    static constexpr int kPooledBlock = 4;
    /// No pooled value is above it where `apart`.
    static constexpr int kMostPooled = 64;

    /// Makes the tables right after phi changed within `changed`.
    void update(const DistanceGrid& phi, const VoxelBox& changed, const Workers& workers);

    bool operator==(const SumTables&) const = default;

    int block() const { return block_; }
    std::int64_t bytes() const { return static_cast<std::int64_t>(values_.size() * 2); }

    /// The element of position (block bx, y, z) in table 0; displacements are added to it as
    /// offsets.
    const std::uint16_t* base(int bx, int y, int z) const { return values_.data() + row(y, z) + bx; }
    /// Where displacement d along `axis` lies from a base; d >= 0.
    std::int32_t offset(int axis, const VoxelIndex& d) const {
        return static_cast<std::int32_t>(axis * table_ + row(d.y, d.z) + within(d.x));
    }

  private:
    std::int64_t row(int y, int z) const { return (static_cast<std::int64_t>(z) * (grid_.y + 1) + y) * stride_; }
    int within(int x) const { return x % block_ * phase_ + x / block_; }
    const std::uint16_t* pooled_row(const DistanceGrid& phi, int y, int z) const {
        return block_ == 1 ? phi.row(y, z) : pooled_.data() + row(y, z);
    }
    void sum_along(std::uint16_t* out, const std::uint16_t* from, int x) const;
    void pool(const DistanceGrid& phi, const VoxelBox& box, const Workers& workers);

    Extent grid_;
    int block_ = 1;
    bool apart_ = false;
    int phase_ = 0;   // elements of one phase of a row
    int stride_ = 0;  // elements of a row
    std::int64_t table_ = 0;
    std::vector<std::uint16_t> values_;
    std::vector<std::uint16_t> pooled_;  // phi_P, laid out as a table; empty for P = 1, where phi is it
};

}  // namespace spectralpack
