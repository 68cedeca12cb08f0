#pragma once
/// Small packings for the tests of pictures.

#include <memory>
#include <vector>

#include "core/random.hpp"
#include "model/rotation_samples.hpp"
#include "render/ray_scene.hpp"
#include "render/render.hpp"
#include "spectralpack/orientations.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {

struct SmallScene {
    Packing packing;
    std::vector<std::shared_ptr<const Mesh>> meshes;

    int add_part(const Mesh& mesh) {
        PackedPart part;
        part.id = static_cast<int>(meshes.size());
        packing.parts.push_back(part);
        meshes.push_back(std::make_shared<const Mesh>(mesh));
        return part.id;
    }

    void place(int part, const Transform& transform, int copy = 0, std::size_t tray = 0) {
        if (packing.trays.size() <= tray) packing.trays.resize(tray + 1);
        Placement placement;
        placement.part = part;
        placement.copy = copy;
        placement.transform = transform;
        packing.trays[tray].placements.push_back(placement);
    }
};

inline SmallScene empty_scene(const Vec3& container = {90, 60, 40}) {
    SmallScene scene;
    scene.packing.container.size = container;
    return scene;
}

/// Six parts of different shape, two copies of each, turned and scaled, some mirrored, in two
/// layers.
inline SmallScene varied_scene() {
    SmallScene scene = empty_scene();
    const std::vector<Mesh> shapes{box_mesh({-5, -3, -1}, {5, 3, 1}), sphere_mesh(4),   torus_mesh(4, 1.5),
                                   box_mesh({2, 2, 2}, {9, 5, 9}),    torus_mesh(5, 1), cube_mesh(6)};
    const std::vector<Mat3> turns = euler_orientations(45);
    RandomStream random(5);
    for (int copy = 0; copy < 2; ++copy) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            const int part = copy == 0 ? scene.add_part(shapes[i]) : static_cast<int>(i);
            Mat3 linear = (0.8 + 0.4 * random.unit()) * turns[random.below(turns.size())];
            if (i % 3 == 1) linear.rows[0] = -linear.rows[0];
            const Box box = bounding_box(transformed(shapes[i], {linear, {}}));
            const Vec3 cell{15.0 + 30 * static_cast<double>(i % 3), 15.0 + 30 * static_cast<double>(i / 3),
                            10.0 + 20 * copy};
            scene.place(part, {linear, cell - 0.5 * (box.min + box.max)}, copy);
        }
    }
    return scene;
}

/// What rays meet on a stage.
class StageRays {
  public:
    explicit StageRays(const Stage& stage) : rays(stage, held(stage)) {}

  private:
    const RayMeshes& held(const Stage& stage) {
        meshes_.add(stage.meshes, Workers(1));
        return meshes_;
    }
    RayMeshes meshes_;

  public:
    const RayScene rays;
};

inline RenderOptions small_picture(int width = 200, int height = 150) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    return options;
}

inline Image picture(const SmallScene& scene, const RenderOptions& options = small_picture(), int threads = 2) {
    return render(scene.packing, scene.meshes, options, Workers(threads));
}

inline Vec3 pixel(const Image& image, int x, int y) {
    const auto at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return {double(image.rgb[at]), double(image.rgb[at + 1]), double(image.rgb[at + 2])};
}

}  // namespace spectralpack::test
