#pragma once
/// What the camera sees in one tile of the picture and a rim around it: samples, and the surfaces
/// they fall on.

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "render/ray_scene.hpp"
#include "render/shading.hpp"
#include "render/stage.hpp"

namespace spectralpack {

inline constexpr int kNothing = -1, kFloor = -2;  ///< in place of a copy

/// The samples of one pixel that see one surface: one copy, about one normal.
struct Fragment {
    int copy = kNothing;
    bool cut = false;             ///< where the section cuts it
    Vec3 position, face, smooth;  ///< of its first sample; see RayHit
    Exposure exposure;
    Vec3 colour;

    bool same_surface(int other_copy, bool other_cut, const Vec3& other_smooth) const {
        return copy == other_copy && cut == other_cut && (copy == kNothing || dot(smooth, other_smooth) > 0.9);
    }
};

struct Sample {
    int fragment = 0;
    float depth = std::numeric_limits<float>::infinity();
};

/// `side` x `side` pixels from (left, top), each of n x n samples, jittered by a hash of their
/// place in the picture. Coordinates below count from there, in pixels (x, y) or samples (sx, sy).
class TileSamples {
  public:
    /// Two rays go to each pixel; the others only where those and the neighbours' do not all fall
    /// on one surface.
    TileSamples(const Stage& stage, const RayScene& rays, int left, int top, int side, int n);

    const Sample& sample(int sx, int sy) const { return samples_[index(sx, sy)]; }
    const Fragment& fragment(const Sample& sample) const {
        return fragments_[static_cast<std::size_t>(sample.fragment)];
    }
    std::span<Fragment> fragments(int x, int y);

    /// Where in the picture a sample lies, pixels.
    std::pair<double, double> place(int sx, int sy) const;

    /// How far off a plane through `position` a point seen by a pixel nearby may lie and still be
    /// taken as on it.
    double flatness(const Vec3& position) const;

  private:
    struct Seen {
        RayHit hit;
        Vec3 position;
    };
    Seen look(int sx, int sy) const;
    bool uniform(int x, int y) const;
    void trace_pixel(int x, int y);

    std::size_t index(int sx, int sy) const { return static_cast<std::size_t>(sy * side_ * n_ + sx); }
    std::size_t pixel(int x, int y) const { return static_cast<std::size_t>(y * side_ + x); }

    const Stage& stage_;
    const RayScene& rays_;
    int left_, top_, side_, n_;
    std::vector<Seen> first_look_;  ///< two a pixel
    std::vector<Sample> samples_;
    std::vector<Fragment> fragments_;  ///< pixel by pixel
    std::vector<std::size_t> begin_;   ///< of each pixel's fragments
};

}  // namespace spectralpack
