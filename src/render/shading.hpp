#pragma once
/// Light: a soft key light from the upper left of the camera and a bright sky all round. Where rays
/// sample it they are fixed ones, so that pictures are the same every time.

#include <array>

#include "render/camera.hpp"
#include "render/ray_scene.hpp"
#include "render/stage.hpp"

namespace spectralpack {

/// Share of the light that reaches a point, each in [0, 1].
struct Exposure {
    double sky = 1, key = 1;
};

class Shading {
  public:
    explicit Shading(const Camera& camera, Backdrop backdrop = Backdrop::floor);

    /// Neighbouring pixels look along different rays; the mean over any 6 x 6 of them has seen all.
    static constexpr int kPattern = 6;

    /// Traces the rays of pattern cell (x mod 6, y mod 6) from `position` on a surface with these
    /// unit normals.
    Exposure exposure(const RayScene& scene, int x, int y, const Vec3& position, const Vec3& face,
                      const Vec3& smooth) const;

    /// Colour of a surface as shown (linear sRGB, in [0, 1]). `view`: unit vector towards the
    /// camera.
    Vec3 surface(const Vec3& albedo, const Vec3& normal, const Vec3& view, const Exposure& exposure) const;

    /// What lies behind everything.
    Vec3 background(double x, double y) const;

    /// The floor takes the background's colour where light reaches it, so that it has no end and no
    /// horizon.
    Vec3 floor(const Vec3& background, const Exposure& exposure) const;

  private:
    static constexpr int kSkyRays = 4, kKeyRays = 2;  ///< a pixel
    static constexpr int kCells = kPattern * kPattern;

    Camera camera_;
    Backdrop backdrop_;
    Vec3 key_;                                      ///< unit vector towards the key light
    std::array<Vec3, kCells * kSkyRays> sky_rays_;  ///< about +z, denser where light counts more
    std::array<Vec3, kCells * kKeyRays> key_rays_;
};

}  // namespace spectralpack
