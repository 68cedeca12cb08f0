#pragma once
/// What rays meet. The only place that sees the ray tracing library.

#include <memory>

#include "core/parallel.hpp"
#include "render/stage.hpp"
#include "spectralpack/geometry.hpp"

namespace spectralpack {

struct RayHit {
    int copy = -1;      ///< index into Stage::copies; -1: nothing met
    double at = 0;      ///< ray parameter
    Vec3 face, smooth;  ///< unit normals towards the ray's origin: of the facet, and to shade with
    bool cut = false;   ///< the ray comes out of what Stage::kept leaves away into the middle of the copy
};

/// Meshes as rays see them, which several pictures share. What is added stays; adding is not for many threads at once.
class RayMeshes {
  public:
    /// Throws ResourceError where the ray tracing library cannot run.
    RayMeshes();
    ~RayMeshes();
    RayMeshes(const RayMeshes&) = delete;
    RayMeshes& operator=(const RayMeshes&) = delete;

    /// Adds those that are not there yet; keeps them alive.
    void add(const std::vector<std::shared_ptr<const Mesh>>& meshes, const Workers& workers);

  private:
    friend class RayScene;
    struct Held;
    std::unique_ptr<Held> held_;
};

/// Each distinct mesh is held once, each copy is an instance of it. Const calls may come from many
/// threads at once.
class RayScene {
  public:
    /// With the stage's meshes, which `meshes` holds and which must outlive this. Throws ResourceError where memory
    /// does not suffice.
    RayScene(const Stage& stage, const RayMeshes& meshes);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    RayHit first(const Vec3& origin, const Vec3& direction) const;

    /// True when something is met before ray parameter `reach`.
    bool blocked(const Vec3& origin, const Vec3& direction, double reach) const;

    /// Where the ray first meets the surface of a keep-out, which nothing else sees; none: infinity.
    double keep_out(const Vec3& origin, const Vec3& direction) const;

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

}  // namespace spectralpack
