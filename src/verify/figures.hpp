#pragma once
/// The figures that a packing states of itself, against what its meshes give.

#include <vector>

#include "verify/check.hpp"

namespace spectralpack {

/// Relative difference that a stated density may have from the measured one.
inline constexpr double kDensityTolerance = 1e-6;

struct TrayMeasure {
    double volume = 0;  ///< sum of signed volumes, mm^3
    Box box;            ///< of the placed meshes
};

/// The measured density of a tray.
double measured_density(const Packing& packing, const TrayMeasure& tray);

/// Findings of kind density: density, density_bounding_box, bounding_box and height of each tray, and of the whole
/// packing density and (where both are there) least distance of two copies.
std::vector<Finding> figure_findings(const Packing& packing, const std::vector<TrayMeasure>& trays,
                                     std::optional<double> min_gap);

}  // namespace spectralpack
