#pragma once
/// Boxes and paths that move parallel to the axes.

#include <cmath>
#include <functional>
#include <vector>

#include "geometry/slide.hpp"
#include "spectralpack/geometry.hpp"

namespace spectralpack {

inline Box moved(const Box& box, const Vec3& by) { return {box.min + by, box.max + by}; }

inline Box at_end(Box box, const std::vector<Vec3>& path) {
    for (const Vec3& move : path) {
        box = moved(box, move);
    }
    return box;
}

inline Box swept(Box box, AxisDirection direction, double way) {
    (direction.sign > 0 ? box.max : box.min)[direction.axis] += direction.sign * way;
    return box;
}

inline Vec3 along(AxisDirection direction, double way) {
    Vec3 move;
    move[direction.axis] = direction.sign * way;
    return move;
}

/// Of an axis-parallel move.
inline AxisDirection direction_of(const Vec3& move) {
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(move[i]) > std::abs(move[axis])) axis = i;
    }
    return {axis, move[axis] < 0 ? -1 : 1};
}

/// Of `box`, moved until it is past `others` in that direction: how far; not positive where it is already.
inline double way_past(const Box& box, const Box& others, AxisDirection direction) {
    const int axis = direction.axis;
    return direction.sign > 0 ? others.max[axis] - box.min[axis] : box.max[axis] - others.min[axis];
}

/// Moves along one axis that follow each other become one; moves of no length go.
std::vector<Vec3> merged(const std::vector<Vec3>& path);

/// Whether an axis-parallel move is free from somewhere on a path, as seen from its start.
using FreeMove = std::function<bool(const Vec3& from, const Vec3& move)>;
/// Of a free path: two moves along the same axis with one between them become one, before it or after it, where that is
/// free as well, until no more do.
std::vector<Vec3> shortened(std::vector<Vec3> path, const FreeMove& free);

}  // namespace spectralpack
