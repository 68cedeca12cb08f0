#pragma once
/// Figures of a finished tray, from its meshes: density, boxes, height, area per layer.

#include <memory>
#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Adds the mesh's cross-section areas half way up each of the layers that `area` has, which are `thickness` high and
/// start at z = 0. Signed, so that hollows count as empty.
void add_section_areas(const Mesh& mesh, double thickness, std::vector<double>& area);

/// The same areas of one mesh, from z = 0 up to its top.
std::vector<double> section_areas(const Mesh& mesh, double thickness);

/// Top of the tray's placements, mm; 0 where there are none. `meshes` as below.
double reached_height(const TrayPacking& tray, const std::vector<std::shared_ptr<const Mesh>>& meshes);

/// Fills density, density_bounding_box, bounding_box, height and layers of `tray` from its placements.
/// `meshes` by part, in the mesh file's own coordinates. Layer areas are those of the cross-section half way up
/// each layer (signed, so hollows count as empty); a layer is `thickness` mm.
void measure_tray(TrayPacking& tray, const Container& container, const std::vector<PackedPart>& parts,
                  const std::vector<std::shared_ptr<const Mesh>>& meshes, double thickness, const Workers& workers);

}  // namespace spectralpack
