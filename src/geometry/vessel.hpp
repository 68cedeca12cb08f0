#pragma once
/// What a vessel holds: the room that water would fill, up to where it runs over.

#include <optional>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

struct Cavity {
    Mesh room;          ///< closed, facing outwards: the vessel's surface below the brim, and a flat lid at the brim
    double volume = 0;  ///< of that
    double brim = 0;    ///< z up to where it is filled: the lowest point at which it runs over
    bool open = false;  ///< at the top; else a hollow without an opening, and the brim is its top
};

/// The largest of the cavities of a closed mesh, z up; none where it holds nothing. A surface that hangs together below
/// some height, and bounds what is not the mesh there, bounds a cavity; it is filled up to where it comes together with
/// the surface outside, at the rim, a spout or a hole. Two basins with a common rim are one. What is less than a
/// twentieth of the mesh's height deep is no cavity, unless it is a hollow.
std::optional<Cavity> largest_cavity(const Mesh& mesh);

}  // namespace spectralpack
