#pragma once
/// Voxel coordinates and dense scalar grids. Index order everywhere: x fastest, then y, then z
/// (offset = (z * ny + y) * nx + x); see docs/conventions.md.

#include <cstdint>
#include <vector>

namespace spectralpack {

/// A voxel's coordinates, or a displacement in voxels. May be negative.
struct VoxelIndex {
    int x = 0, y = 0, z = 0;

    int operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    int& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    bool operator==(const VoxelIndex&) const = default;
};

inline VoxelIndex operator+(const VoxelIndex& a, const VoxelIndex& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline VoxelIndex operator-(const VoxelIndex& a, const VoxelIndex& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// Number of voxels along each axis, never negative.
struct Extent {
    int x = 0, y = 0, z = 0;

    int operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    int& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    bool operator==(const Extent&) const = default;
    bool empty() const { return x == 0 || y == 0 || z == 0; }
    /// Throws ResourceError where that is beyond 63 bits.
    std::int64_t count() const;
    bool contains(const VoxelIndex& i) const {
        return i.x >= 0 && i.y >= 0 && i.z >= 0 && i.x < x && i.y < y && i.z < z;
    }
};

template <class T>
class Grid {
  public:
    Grid() = default;
    explicit Grid(const Extent& extent, T value = T{})
        : extent_(extent), values_(static_cast<std::size_t>(extent.count()), value) {}

    const Extent& extent() const { return extent_; }
    std::int64_t offset(int x, int y, int z) const {
        return (static_cast<std::int64_t>(z) * extent_.y + y) * extent_.x + x;
    }
    T& at(int x, int y, int z) { return values_[static_cast<std::size_t>(offset(x, y, z))]; }
    const T& at(int x, int y, int z) const { return values_[static_cast<std::size_t>(offset(x, y, z))]; }
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    std::vector<T>& values() { return values_; }
    const std::vector<T>& values() const { return values_; }
    bool operator==(const Grid&) const = default;

  private:
    Extent extent_;
    std::vector<T> values_;
};

}  // namespace spectralpack
