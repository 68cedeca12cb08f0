#pragma once
/// A part: one input mesh with a count and its constraints. A copy is one instance of it.

#include <optional>
#include <string>
#include <vector>

#include "geometry/transform.hpp"
#include "model/orientation.hpp"

namespace spectralpack {

struct Part {
    int id = 0;                         ///< position in Packing::parts
    std::string name;                   ///< for people; part number in a 3MF
    std::string mesh;                   ///< path of the mesh file; relative to the packing file once that is written
    std::optional<std::string> object;  ///< 3MF: id of the object in the file
    std::optional<Transform> item_transform;  ///< 3MF: the build item's, in the file's unit
    int count = 1;
    int share = 0;  ///< of a packing filled in shares: the count asked for, while `count` is what came of it; else 0
    double scale = 1;
    double unit = 1;                   ///< millimetres per unit of the mesh file
    double gap = 0;                    ///< mm
    PartOrientations orientations;     ///< those it may take
    double volume = 0;                 ///< signed volume of one scaled copy, mm^3
    std::vector<std::string> repairs;  ///< what was mended on loading, in words

    /// From the mesh as loaded to millimetres.
    double to_mm() const { return unit * scale; }
};

}  // namespace spectralpack
