#pragma once
/// One tile of the picture at a time. Tiles know nothing of each other: each also traces a small
/// rim of its neighbours' pixels, so that the result does not depend on which is painted when.

#include "render/outline.hpp"
#include "render/ray_scene.hpp"
#include "render/shading.hpp"
#include "render/stage.hpp"
#include "spectralpack/render.hpp"

namespace spectralpack {

inline constexpr int kTileSide = 64;  ///< pixels

/// All that painting reads.
struct PaintInput {
    const Stage& stage;
    const RayScene& rays;
    const Shading& shading;
    const Outline& outline;
    int samples;          ///< per pixel and axis
    bool shadows = true;  ///< and occlusion of the sky, which take most of the time
};

/// A picture, and which copy each of its pixels shows: an index into Stage::copies, or less than 0.
struct Picture {
    Image image;
    std::vector<int> seen;
};

/// Paints the tile whose upper left pixel is (left, top). About 4 MB of working memory at 3
/// samples.
void paint_tile(const PaintInput& input, int left, int top, Picture& picture);

}  // namespace spectralpack
