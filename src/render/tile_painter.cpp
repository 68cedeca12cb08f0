#include "render/tile_painter.hpp"

#include <algorithm>

#include "model/palette.hpp"
#include "render/tile_samples.hpp"

namespace spectralpack {
namespace {

constexpr int kRim = Shading::kPattern / 2;  // half the window that exposures are averaged over
constexpr int kSide = kTileSide + 2 * kRim;
constexpr double kDrawnCrease = 0.7;  // largest cosine between normals on two sides of a drawn crease
constexpr double kStep = 0.02;        // stage units in depth that make an edge within one copy
constexpr double kEdgeInk = 0.62, kCreaseInk = 0.2;
constexpr double kHatch = 9, kHatchLine = 0.28;  // between two hatch lines, pixels; of that the line
constexpr double kCutInk = 0.35, kKeepOutLine = 0.5, kKeepOutShade = 0.1;
constexpr double kDots = 8, kDotInk = 0.9;  // pixels from dot to dot
constexpr double kFarFloor = 4;             // stage units from the centre: no shadow reaches there

class TilePainter {
  public:
    TilePainter(const PaintInput& input, int left, int top)
        : in_(input),
          n_(input.samples),
          left_(left - kRim),
          top_(top - kRim),
          seen_(input.stage, input.rays, left_, top_, kSide, n_),
          edges_(input.outline.near(left_, top_, left_ + kSide, top_ + kSide)) {}

    void paint(Picture& picture) {
        Image& image = picture.image;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                expose_pixel(x, y);
            }
        }
        const int right = kRim + std::min(kTileSide, image.width - left_ - kRim);
        const int bottom = kRim + std::min(kTileSide, image.height - top_ - kRim);
        for (int y = kRim; y < bottom; ++y) {
            for (int x = kRim; x < right; ++x) {
                colour_pixel(x, y);
                const Vec3 colour = resolve_pixel(x, y);
                const auto at = static_cast<std::size_t>(top_ + y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(left_ + x);
                picture.seen[at] = seen_.fragment(seen_.sample(x * n_ + n_ / 2, y * n_ + n_ / 2)).copy;
                std::uint8_t* out = &image.rgb[3 * at];
                out[0] = to_srgb(colour.x);
                out[1] = to_srgb(colour.y);
                out[2] = to_srgb(colour.z);
            }
        }
    }

  private:
    void expose_pixel(int x, int y) {
        if (!in_.shadows) return;
        for (Fragment& f : seen_.fragments(x, y)) {
            if (f.copy == kNothing || (f.copy == kFloor && length(f.position) > kFarFloor)) continue;
            f.exposure = in_.shading.exposure(in_.rays, left_ + x, top_ + y, f.position, f.face, f.smooth);
        }
    }

    /// Mean exposure over the window, of fragments that lie on the same surface.
    Exposure averaged(int x, int y, const Fragment& f) {
        if (!in_.shadows) return {};
        Exposure sum{0, 0};
        double weights = 0;
        const double flatness = seen_.flatness(f.position);
        for (int dy = -kRim; dy <= kRim; ++dy) {
            for (int dx = -kRim; dx <= kRim; ++dx) {
                // Half the weight at the ends: each cell of the pattern then counts the same.
                const double weight = (std::abs(dx) == kRim ? 0.5 : 1) * (std::abs(dy) == kRim ? 0.5 : 1);
                for (const Fragment& other : seen_.fragments(x + dx, y + dy)) {
                    if (!f.same_surface(other.copy, other.cut, other.smooth) ||
                        std::abs(dot(other.position - f.position, f.face)) > flatness) {
                        continue;
                    }
                    sum.sky += weight * other.exposure.sky;
                    sum.key += weight * other.exposure.key;
                    weights += weight;
                }
            }
        }
        return {sum.sky / weights, sum.key / weights};
    }

    void colour_pixel(int x, int y) {
        const Vec3 background = in_.shading.background(left_ + x + 0.5, top_ + y + 0.5);
        for (Fragment& f : seen_.fragments(x, y)) {
            if (f.copy == kNothing) {
                f.colour = background;
            } else if (f.cut) {
                f.colour = in_.stage.copies[static_cast<std::size_t>(f.copy)].colour;
            } else if (f.copy == kFloor) {
                f.colour = in_.shading.floor(background, averaged(x, y, f));
            } else {
                f.colour = in_.shading.surface(in_.stage.copies[static_cast<std::size_t>(f.copy)].colour, f.smooth,
                                               in_.stage.camera.to_viewer(f.position), averaged(x, y, f));
            }
        }
    }

    /// Thin lines where one copy ends before another, on the further one, and fainter ones along
    /// creases.
    double ink(int sx, int sy) const {
        const Sample& here = seen_.sample(sx, sy);
        const Fragment& f = seen_.fragment(here);
        double strongest = 0;
        const int reach = (2 * n_ + 2) / 3;
        for (int k = 1; k <= reach; ++k) {
            for (const auto& [dx, dy] : {std::pair{k, 0}, {-k, 0}, {0, k}, {0, -k}}) {
                const Sample& there = seen_.sample(sx + dx, sy + dy);
                if (there.fragment == here.fragment) continue;
                const Fragment& g = seen_.fragment(there);
                if (g.copy != f.copy) {
                    if (stood_before(f) || stood_before(g)) return dot_ink(sx, sy);
                    if (there.depth < here.depth) return kEdgeInk;
                } else if (f.copy >= 0) {
                    if (there.depth < here.depth - kStep) return kEdgeInk;
                    if (dot(g.smooth, f.smooth) < kDrawnCrease) strongest = kCreaseInk;
                }
            }
        }
        return strongest;
    }

    bool stood_before(const Fragment& f) const {
        return f.copy >= 0 && in_.stage.copies[static_cast<std::size_t>(f.copy)].fixed;
    }

    /// The outlines of copies that stood there before are dotted.
    double dot_ink(int sx, int sy) const {
        const auto [x, y] = seen_.place(sx, sy);
        return std::fmod(std::abs(x + y) + std::abs(x - y), kDots) < kDots / 2 ? kDotInk : 0;
    }

    Vec3 point_at(double x, double y, double depth) const {
        return in_.stage.camera.origin(x, y) + depth * in_.stage.camera.ray(x, y);
    }

    bool on_hatch(const Vec3& point) const {
        const double step = kHatch * in_.stage.camera.pixel_size(point);
        const double along = (point.x + point.y + point.z) / step;
        return along - std::floor(along) < kHatchLine;
    }

    /// On what a section cuts through.
    double hatch(int sx, int sy) const {
        const auto [x, y] = seen_.place(sx, sy);
        return on_hatch(point_at(x, y, seen_.sample(sx, sy).depth)) ? kCutInk : 0;
    }

    /// Keep-outs are hatched and let see through; those behind a copy are not seen.
    double keep_out(int sx, int sy) const {
        if (in_.stage.keep_outs.empty()) return 0;
        const auto [x, y] = seen_.place(sx, sy);
        const double depth = in_.rays.keep_out(in_.stage.camera.origin(x, y), in_.stage.camera.ray(x, y));
        if (!(depth < seen_.sample(sx, sy).depth)) return 0;
        return on_hatch(point_at(x, y, depth)) ? kKeepOutLine : kKeepOutShade;
    }

    double line(int sx, int sy) const {
        double strongest = 0;
        if (edges_.empty()) return strongest;
        const auto [x, y] = seen_.place(sx, sy);
        for (const Outline::Edge& edge : edges_) {
            strongest = std::max(strongest, in_.outline.opacity(edge, x, y, seen_.sample(sx, sy).depth));
        }
        return strongest;
    }

    Vec3 resolve_pixel(int x, int y) const {
        Vec3 sum;
        double lines = 0;
        for (int sy = y * n_; sy < (y + 1) * n_; ++sy) {
            for (int sx = x * n_; sx < (x + 1) * n_; ++sx) {
                const Fragment& f = seen_.fragment(seen_.sample(sx, sy));
                const double dark = std::max(ink(sx, sy), f.cut && in_.stage.hatched_cuts ? hatch(sx, sy) : 0);
                sum = sum + (1 - dark) * f.colour;
                lines += std::max(line(sx, sy), keep_out(sx, sy));
            }
        }
        const double share = 1.0 / (n_ * n_);
        return (1 - share * lines) * (share * sum) + share * lines * Outline::colour();
    }

    const PaintInput& in_;
    int n_;
    int left_, top_;  ///< of the tile with its rim, in the picture
    TileSamples seen_;
    std::vector<Outline::Edge> edges_;
};

}  // namespace

void paint_tile(const PaintInput& input, int left, int top, Picture& picture) {
    TilePainter(input, left, top).paint(picture);
}

}  // namespace spectralpack
