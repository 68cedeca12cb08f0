#pragma once
/// Regular samples of the rotations (paper sections 3.1 and 5: "evenly sample Euler angles", "subdivisions of an
/// icosahedron"). Sines of multiples of 30 and 45 degrees come from exact constants and square roots, others from a
/// sum in a fixed order: the same doubles on every machine.

#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// Right-handed turn about a coordinate axis (0: x, 1: y, 2: z).
Mat3 turn_about(int axis, double degrees);

/// Throws UsageError unless `degrees` is in [6, 360] and divides 360; `what` names it in the message.
void require_step(double degrees, const char* what);

/// R = Rx(i step) Ry(j step) Rz(k step), k innermost, first of equal matrices kept; index 0 is the identity. 90 gives
/// the 24 rotations of the cube. Throws as require_step.
std::vector<Mat3> euler_orientations(double step_degrees);

/// Steps of the turn about the upward direction in icosahedral_orientations(): 90 degrees halved N times.
double icosahedral_roll(int subdivisions);
inline constexpr int kMostSubdivisions = 3;  ///< 20 544 orientations

/// For every vertex v of an icosahedron whose edges were halved N times (12, 42, 162, 642 of them; the first is +z,
/// each halving appends the middles of the edges, on the sphere): R = (least turn from +z to v) Rz(k roll),
/// k innermost; index 0 is the identity. 48, 336, 2 592 or 20 544 orientations. Throws UsageError beyond
/// kMostSubdivisions.
std::vector<Mat3> icosahedral_orientations(int subdivisions);

/// The first of each set of matrices that are equal up to rounding (entries in units of 1e-6).
std::vector<Mat3> distinct(const std::vector<Mat3>& rotations);

}  // namespace spectralpack
