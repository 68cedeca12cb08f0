#include "render/render.hpp"

#include "core/checked.hpp"
#include "render/tile_painter.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr int kMostSide = 32768, kMostSamples = 16;

void check(const RenderOptions& options) {
    if (options.width < 1 || options.height < 1 || options.width > kMostSide || options.height > kMostSide) {
        throw UsageError("a picture is 1 to 32768 pixels wide and high");
    }
    if (options.samples < 1 || options.samples > kMostSamples) {
        throw UsageError("a picture takes 1 to 16 samples per pixel and axis");
    }
    if (!std::isfinite(options.azimuth)) throw UsageError("the camera's azimuth must be a number");
    if (!(options.elevation >= -90 && options.elevation <= 90)) {
        throw UsageError("the camera's elevation lies between -90 and 90 degrees");
    }
    if (options.explode && !(*options.explode >= 0 && std::isfinite(*options.explode))) {
        throw UsageError("a tray is drawn apart by a factor of 0 or more");
    }
    if (options.explode && options.step) {
        throw UsageError("a picture shows a tray drawn apart or one step of its plan, not both");
    }
}

}  // namespace

Image render(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
             const RenderOptions& options, const Workers& workers) {
    check(options);
    const Stage stage = set_stage(packing, meshes, options);
    const RayScene rays(stage);
    const Shading shading(stage.camera);
    const Outline outline(stage);
    const PaintInput input{stage, rays, shading, outline, options.samples};

    Image image{options.width, options.height, {}};
    image.rgb.resize(static_cast<std::size_t>(checked_product({3, image.width, image.height})));
    const int columns = (image.width + kTileSide - 1) / kTileSide;
    const int rows = (image.height + kTileSide - 1) / kTileSide;
    workers.for_each(static_cast<std::int64_t>(columns) * rows, [&](std::int64_t tile) {
        const auto at = static_cast<int>(tile);
        paint_tile(input, at % columns * kTileSide, at / columns * kTileSide, image);
    });
    return image;
}

}  // namespace spectralpack
