#pragma once
/// What pack options come to, and which of them make no sense.

#include <optional>
#include <string>

#include "spectralpack/pack.hpp"

namespace spectralpack {

/// True where the packing has no ceiling.
bool is_open(const PackOptions& options);

/// Whether the first packing is to be made better.
bool improves(const PackOptions& options);

// What is given, else the usual.
double voxel_size(const PackOptions& options);  ///< dx, mm
std::string rotations_of(const PackOptions& options);

/// Where height counts in all trays; none: in each where it serves best (HeightChoice).
std::optional<HeightReference> height_reference(const PackOptions& options);

/// By which rule the plan takes copies out of that container, unless the options say so.
Unpack unpack_rule(const std::optional<Unpack>& asked, const Container& container);

/// The tray with its z set where it was left open: the container, or with open height its base and reference height.
Vec3 tray_size(const PackOptions& options);

/// What is left of the tray inside the wall gap; under an open ceiling without end upwards.
Vec3 space_inside(const PackOptions& options);

/// Throws UsageError for rays of no use, too fine ones for voxels of that size among them.
void check_ray_spacing(double spacing, double voxel);

/// Throws UsageError for options that make no sense or are not built.
void check_options(const PackOptions& options);

}  // namespace spectralpack
