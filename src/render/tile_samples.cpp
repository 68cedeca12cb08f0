#include "render/tile_samples.hpp"

#include <algorithm>
#include <array>

#include "core/random.hpp"

namespace spectralpack {

TileSamples::TileSamples(const Stage& stage, const RayScene& rays, int left, int top, int side, int n)
    : stage_(stage),
      rays_(rays),
      left_(left),
      top_(top),
      side_(side),
      n_(n),
      samples_(static_cast<std::size_t>(side * side * n * n)),
      begin_{0} {
    first_look_.reserve(static_cast<std::size_t>(2 * side * side));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            first_look_.push_back(look(x * n, y * n));
            first_look_.push_back(n == 1 ? first_look_.back() : look(x * n + n / 2, y * n + n / 2));
        }
    }
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            trace_pixel(x, y);
        }
    }
}

std::span<Fragment> TileSamples::fragments(int x, int y) {
    const std::size_t first = begin_[pixel(x, y)];
    return std::span(fragments_).subspan(first, begin_[pixel(x, y) + 1] - first);
}

std::pair<double, double> TileSamples::place(int sx, int sy) const {
    constexpr int kAboveZero = 1 << 20;  // the rim of the first tile has negative coordinates
    const auto gx = static_cast<std::uint64_t>(left_ * n_ + sx + kAboveZero);
    const auto gy = static_cast<std::uint64_t>(top_ * n_ + sy + kAboveZero);
    const std::uint64_t bits = RandomStream(gx << 32 | gy).next();
    const double jx = static_cast<double>(bits & 0xffff) / 0x10000;
    const double jy = static_cast<double>(bits >> 16 & 0xffff) / 0x10000;
    return {left_ + (sx + jx) / n_, top_ + (sy + jy) / n_};
}

double TileSamples::flatness(const Vec3& position) const {
    constexpr double kPixels = 3;
    return kPixels * stage_.camera.pixel_size(position);
}

TileSamples::Seen TileSamples::look(int sx, int sy) const {
    const Camera& camera = stage_.camera;
    const auto [x, y] = place(sx, sy);
    const Vec3 ray = camera.ray(x, y), origin = camera.origin(x, y);
    Seen seen{rays_.first(origin, ray), {}};
    const double above = origin.z - stage_.floor;
    if (stage_.backdrop == Backdrop::floor && seen.hit.copy == kNothing && ray.z < 0 && above > 0) {
        seen.hit = {kFloor, above / -ray.z, {0, 0, 1}, {0, 0, 1}};
    }
    seen.position = origin + seen.hit.at * ray;
    return seen;
}

/// Whether the first looks of a pixel and of those around it all fall on one surface.
bool TileSamples::uniform(int x, int y) const {
    const Seen& here = first_look_[2 * pixel(x, y)];
    const Fragment surface{here.hit.copy, here.hit.cut, here.position, here.hit.face, here.hit.smooth, {}, {}};
    const double flatness = this->flatness(here.position);
    for (int j = std::max(0, y - 1); j <= std::min(side_ - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(side_ - 1, x + 1); ++i) {
            for (const std::size_t k : {0, 1}) {
                const Seen& other = first_look_[2 * pixel(i, j) + k];
                if (!surface.same_surface(other.hit.copy, other.hit.cut, other.hit.smooth) ||
                    std::abs(dot(other.position - here.position, here.hit.face)) > flatness) {
                    return false;
                }
            }
        }
    }
    return true;
}

void TileSamples::trace_pixel(int x, int y) {
    const bool all_alike = uniform(x, y);
    const std::size_t first = fragments_.size();
    for (int sy = y * n_; sy < (y + 1) * n_; ++sy) {
        for (int sx = x * n_; sx < (x + 1) * n_; ++sx) {
            const Seen seen = all_alike ? first_look_[2 * pixel(x, y)] : look(sx, sy);
            std::size_t i = first;
            while (i < fragments_.size() && !fragments_[i].same_surface(seen.hit.copy, seen.hit.cut, seen.hit.smooth)) {
                ++i;
            }
            if (i == fragments_.size()) {
                fragments_.push_back(
                    {seen.hit.copy, seen.hit.cut, seen.position, seen.hit.face, seen.hit.smooth, {}, {}});
            }
            Sample& sample = samples_[index(sx, sy)];
            sample.fragment = static_cast<int>(i);
            if (seen.hit.copy != kNothing) sample.depth = static_cast<float>(seen.hit.at);
        }
    }
    begin_.push_back(fragments_.size());
}

}  // namespace spectralpack
