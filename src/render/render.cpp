#include "render/render.hpp"

#include "core/checked.hpp"
#include "render/marks.hpp"
#include "render/tile_painter.hpp"
#include "render/tile_samples.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr int kMostSide = 32768, kMostSamples = 16;
constexpr int kLeastMarked = 400;  // pixels: on smaller pictures bar and numbers would hide too much

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
    if (options.section && (options.section->axis < 0 || options.section->axis > 2)) {
        throw UsageError("a section stands across x, y or z");
    }
    if (options.explode && options.step) {
        throw UsageError("a picture shows a tray drawn apart or one step of its plan, not both");
    }
}

}  // namespace

Picture paint(const Stage& stage, const RayMeshes& meshes, int samples, const Workers& workers,
              const StopToken& hurry) {
    const RayScene rays(stage, meshes);
    const Shading shading(stage.camera, stage.backdrop);
    const Outline outline(stage);
    const PaintInput input{stage, rays, shading, outline, samples}, plain{stage, rays, shading, outline, 1, false};

    const int width = stage.camera.width, height = stage.camera.height;
    Picture picture{{width, height, {}}, {}};
    picture.image.rgb.resize(static_cast<std::size_t>(checked_product({3, width, height})));
    picture.seen.resize(picture.image.rgb.size() / 3, kNothing);
    const int columns = (width + kTileSide - 1) / kTileSide;
    const int rows = (height + kTileSide - 1) / kTileSide;
    workers.for_each(static_cast<std::int64_t>(columns) * rows, [&](std::int64_t tile) {
        const auto at = static_cast<int>(tile);
        paint_tile(hurry.stopped() ? plain : input, at % columns * kTileSide, at / columns * kTileSide, picture);
    });
    return picture;
}

Image render(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
             const RenderOptions& options, const Workers& workers, const DrawingTime& time) {
    check(options);
    const Workers drawing = workers.stopping_with(time.over);
    View view;
    view.options = options;
    const Stage stage = set_stage(packing, meshes, view);
    RayMeshes held;
    held.add(stage.meshes, drawing);
    Picture picture = paint(stage, held, options.samples, drawing, time.hurry);
    if (std::min(options.width, options.height) >= kLeastMarked) {
        if (options.marks) draw_marks(marks_of(stage), picture.image);
        if (options.numbers) draw_numbers(stage, picture);
    }
    return std::move(picture.image);
}

}  // namespace spectralpack
