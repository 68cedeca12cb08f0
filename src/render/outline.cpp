#include "render/outline.hpp"

#include <algorithm>

#include "model/palette.hpp"

namespace spectralpack {
namespace {

constexpr double kHalfWidth = 0.85, kSoftness = 0.5, kDash = 7, kSpace = 6;  // pixels
constexpr double kNear = 0.9, kFar = 0.45, kHidden = 0.3;                    // opacities
constexpr double kTouching = 2e-3;  // stage units: a surface this near the edge does not hide it

}  // namespace

Outline::Outline(const Stage& stage)
    : lens_(stage.camera.lens), pixel_(std::max(0.8, std::min(stage.camera.width, stage.camera.height) / 1200.0)) {
    for (const auto& [from, to] : stage.edges) {
        edges_.push_back({stage.camera.project(from), stage.camera.project(to), kNear});
    }
    for (const Box& box : stage.outlined) {
        const auto corner = [&](int i) {
            return stage.camera.project(
                {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z});
        };
        int furthest = 0;
        for (int i = 1; i < 8; ++i) {
            if (corner(i).depth > corner(furthest).depth) furthest = i;
        }
        for (int i = 0; i < 8; ++i) {
            for (const int axis : {1, 2, 4}) {
                const int j = i | axis;
                if (i == j) continue;
                edges_.push_back({corner(i), corner(j), i == furthest || j == furthest ? kFar : kNear});
            }
        }
    }
}

std::vector<Outline::Edge> Outline::near(int x0, int y0, int x1, int y1) const {
    const double margin = (kHalfWidth + kSoftness) * pixel_ + 1;
    std::vector<Edge> result;
    for (const Edge& edge : edges_) {
        const auto [left, right] = std::minmax(edge.from.x, edge.to.x);
        const auto [top, bottom] = std::minmax(edge.from.y, edge.to.y);
        if (right + margin < x0 || left - margin > x1 || bottom + margin < y0 || top - margin > y1) continue;
        result.push_back(edge);
    }
    return result;
}

double Outline::opacity(const Edge& edge, double x, double y, double depth) const {
    const double dx = edge.to.x - edge.from.x, dy = edge.to.y - edge.from.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) return 0;
    const double off_line = std::abs((x - edge.from.x) * dy - (y - edge.from.y) * dx) / length;
    if (off_line > kHalfWidth * pixel_ + kSoftness) return 0;
    const double along = ((x - edge.from.x) * dx + (y - edge.from.y) * dy) / length;
    const double on_edge = std::clamp(along, 0.0, length);
    const double aside = std::hypot(x - edge.from.x - on_edge / length * dx, y - edge.from.y - on_edge / length * dy);
    const double cover = std::clamp((kHalfWidth * pixel_ - aside) / kSoftness + 0.5, 0.0, 1.0);
    if (cover == 0) return 0;
    // Perspective keeps 1 / depth straight.
    const double t = on_edge / length;
    const double edge_depth = lens_ == Lens::parallel ? (1 - t) * edge.from.depth + t * edge.to.depth
                                                      : 1 / ((1 - t) / edge.from.depth + t / edge.to.depth);
    if (edge_depth < depth + kTouching) return edge.strength * cover;
    const bool dash = std::fmod(on_edge, (kDash + kSpace) * pixel_) < kDash * pixel_;
    return dash ? kHidden * cover : 0;
}

Vec3 Outline::colour() { return from_oklch(0.33, 0.03, 255); }

}  // namespace spectralpack
