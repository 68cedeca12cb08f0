#pragma once
/// A perspective camera: where it stands, which ray belongs to a point of the picture, and back.

#include <span>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// A point in the picture: pixels from the left and from the top (pixel centres lie at .5), and the
/// distance in front of the camera along its axis.
struct PicturePoint {
    double x = 0, y = 0, depth = 0;
};

struct Camera {
    Vec3 eye, right, up, forward;  ///< three unit vectors at right angles
    double tan_x = 0, tan_y = 0;   ///< half the field of view: tangents of its angles
    int width = 0, height = 0;     ///< of the picture, pixels

    /// Where the ray through (x, y) leads; as long as it takes for its depth to be 1, so that a ray
    /// parameter is a depth.
    Vec3 ray(double x, double y) const;

    PicturePoint project(const Vec3& point) const;
};

/// The nearest camera that stands `azimuth` and `elevation` degrees round and above the points and
/// sees them all with a margin, in the middle of the picture, from no nearer than half their depth.
/// Azimuth 0 looks along +y, 90 along -x; elevation is in [-90, 90]. Precondition: points that do
/// not all coincide. Scaling the points scales the camera's distance.
Camera fit_camera(std::span<const Vec3> points, double azimuth, double elevation, int width, int height);

}  // namespace spectralpack
