#pragma once
/// What rays meet. The only place that sees the ray tracing library.

#include <memory>

#include "render/stage.hpp"
#include "spectralpack/geometry.hpp"

namespace spectralpack {

struct RayHit {
    int copy = -1;      ///< index into Stage::copies; -1: nothing met
    double at = 0;      ///< ray parameter
    Vec3 face, smooth;  ///< unit normals towards the ray's origin: of the facet, and to shade with
};

/// Each distinct mesh is held once, each copy is an instance of it. Const calls may come from many
/// threads at once.
class RayScene {
  public:
    /// Throws ResourceError where memory does not suffice.
    explicit RayScene(const Stage& stage);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    RayHit first(const Vec3& origin, const Vec3& direction) const;

    /// True when something is met before ray parameter `reach`.
    bool blocked(const Vec3& origin, const Vec3& direction, double reach) const;

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

}  // namespace spectralpack
