#pragma once
/// Rotations that take axes to axes, such as the 24 of the cube: what turns the mesh turns its
/// voxels, as long as the voxel grid keeps its place on the mesh. Exchanging axes keeps it.
/// Reversing one does not where the mesh's box is no whole number of voxels, because the grid
/// starts at the box minimum. So there are 8 cases, the sign patterns.

#include <array>
#include <optional>
#include <vector>

#include "voxel/grid_mesh.hpp"

namespace spectralpack {

/// Axes of the mesh are reversed first, then exchanged: axis i of the result is axis `axes[i]`.
struct AxisTurn {
    std::array<int, 3> axes;
    Signs reversed;

    /// The exchange that undoes `axes`.
    std::array<int, 3> inverse_axes() const {
        std::array<int, 3> inverse{};
        for (int i = 0; i < 3; ++i) {
            inverse[static_cast<std::size_t>(axes[static_cast<std::size_t>(i)])] = i;
        }
        return inverse;
    }
};

/// None where the matrix is no permutation with signs.
std::optional<AxisTurn> axis_turn(const Mat3& rotation);

/// The axis turns among some rotations, by sign pattern.
struct SignPatterns {
    explicit SignPatterns(const std::vector<Mat3>& rotations);

    std::vector<std::optional<AxisTurn>> turns;  ///< by rotation
    std::vector<std::size_t> pattern_of;  ///< by rotation; index into first_of, for axis turns
    std::vector<std::size_t> first_of;    ///< by pattern: the first rotation that has it

    const Signs& signs(std::size_t pattern) const { return turns[first_of[pattern]]->reversed; }
};

}  // namespace spectralpack
