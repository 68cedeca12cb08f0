#pragma once
/// The camera: where it stands, which ray belongs to a point of the picture, and back.

#include <span>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// A point in the picture: pixels from the left and from the top (pixel centres lie at .5), and the
/// distance in front of the camera along its axis.
struct PicturePoint {
    double x = 0, y = 0, depth = 0;
};

/// How far things look: as they do to an eye, or the same at any distance, so that lengths can be measured.
enum class Lens { perspective, parallel };

struct Camera {
    Vec3 eye, right, up, forward;  ///< three unit vectors at right angles
    Lens lens = Lens::perspective;
    double tan_x = 0,
           tan_y = 0;           ///< half the field of view: tangents of its angles; half its size where it is parallel
    int width = 0, height = 0;  ///< of the picture, pixels

    /// Where the ray through (x, y) leads; as long as it takes for its depth to be 1, so that a ray
    /// parameter is a depth.
    Vec3 ray(double x, double y) const;
    /// Where that ray starts.
    Vec3 origin(double x, double y) const;

    PicturePoint project(const Vec3& point) const;

    /// Unit vector from the point to the viewer.
    Vec3 to_viewer(const Vec3& point) const;
    /// How wide a pixel is at this point.
    double pixel_size(const Vec3& point) const;
};

inline constexpr double kMargin = 0.07;  ///< of the picture, on each side

/// The nearest camera that stands `azimuth` and `elevation` degrees round and above the points and
/// sees them all with a margin, in the middle of the picture, from no nearer than half their depth.
/// Azimuth 0 looks along +y, 90 along -x; elevation is in [-90, 90]. Precondition: points that do
/// not all coincide. Scaling the points scales the camera's distance.
Camera fit_camera(std::span<const Vec3> points, double azimuth, double elevation, int width, int height);

/// The same with a parallel lens: the points fill the picture but for the margin one way or the other.
Camera fit_parallel_camera(std::span<const Vec3> points, double azimuth, double elevation, int width, int height,
                           double margin);

}  // namespace spectralpack
