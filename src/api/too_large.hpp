#pragma once
/// Parts that have no room in the tray, and what would have room for them.

#include <span>
#include <string>
#include <vector>

#include "spectralpack/mesh.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/orientations.hpp"
#include "spectralpack/printers.hpp"

namespace spectralpack {

/// Lengths of the mesh's box once it is turned, mm.
Vec3 turned_size(const Mesh& mesh, const Mat3& turn, double to_mm);

/// A part, and how it may stand.
struct TurnablePart {
    const Mesh& mesh;
    double to_mm = 1;
    const PartOrientations& may;
    const std::vector<Mat3>& orientations;
};

/// "400 x 45 x 49 mm, and there is room for 159 x 159 x 294 mm. ..." where the part fits into
/// `room` in none of its orientations, with what would take it: to be turned freely, or finer --rotations than those of
/// `options`, else the smallest printer, of the user's `own` and those that are known, unless a mesh is the container.
/// Empty where it fits.
std::string why_too_large(const TurnablePart& part, const Vec3& room, const PackOptions& options, bool box,
                          std::span<const Printer> own);

}  // namespace spectralpack
