#pragma once
/// The containers' edges as lines in the picture.

#include <vector>

#include "render/stage.hpp"

namespace spectralpack {

class Outline {
  public:
    explicit Outline(const Stage& stage);

    struct Edge {
        PicturePoint from, to;
        double strength = 0;  ///< opacity where nothing hides it; far edges are fainter
    };

    /// Edges that may touch the rectangle of pixels [x0, x1) x [y0, y1).
    std::vector<Edge> near(int x0, int y0, int x1, int y1) const;

    /// How opaque the edge is at (x, y), where the surface behind or before it lies at `depth`:
    /// whole lines before it, faint dashes behind it; 0 beside the line.
    double opacity(const Edge& edge, double x, double y, double depth) const;

    static Vec3 colour();

  private:
    std::vector<Edge> edges_;
    Lens lens_;
    double pixel_ = 1;  ///< what widths are multiplied by: 1 in a picture of 1200 pixels
};

}  // namespace spectralpack
