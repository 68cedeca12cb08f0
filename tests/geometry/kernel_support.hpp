#pragma once
/// Slow and plain counterparts of the distance and slide kernels, in quadruple precision.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "core/random.hpp"
#include "geometry/bvh.hpp"
#include "geometry/slide.hpp"

namespace spectralpack::test {

inline Vec3 along(AxisDirection d, double way) {
    Vec3 v;
    v[d.axis] = d.sign * way;
    return v;
}

/// How far `moving` may go as far as `still` is concerned.
inline double slide(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction, double gap,
                    double at_most) {
    std::atomic<double> free = at_most;
    spectralpack::slide(moving, offset, still, direction, gap, at_most, free);
    return free;
}

/// A mesh of this triangle only.
inline Bvh alone(const Corners& t) { return Bvh(Mesh{{t.begin(), t.end()}, {{0, 1, 2}}}); }

using Quad = __float128;

struct QuadPoint {
    Quad x = 0, y = 0, z = 0;
};
inline QuadPoint quad(const Vec3& p) { return {p.x, p.y, p.z}; }
inline QuadPoint operator+(const QuadPoint& a, const QuadPoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline QuadPoint operator-(const QuadPoint& a, const QuadPoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline QuadPoint operator*(Quad s, const QuadPoint& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Quad dot(const QuadPoint& a, const QuadPoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Least distance of two triangles as a convex quadratic programme in the four barycentric weights,
/// solved by trying every set of active constraints: each pair of faces (corner, edge or whole
/// triangle) in turn, the unconstrained minimum over their affine hulls, kept when it lies within.
/// No case distinctions by geometry.
inline double quad_distance(const Corners& a, const Corners& b) {
    static constexpr std::array<std::array<int, 4>, 7> faces{
        {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 0, 0}, {2, 0, 1, 0}, {2, 1, 2, 0}, {2, 2, 0, 0}, {3, 0, 1, 2}}};
    Quad best = -1;
    for (const auto& fa : faces) {
        for (const auto& fb : faces) {
            // p = a0 + sum s_i u_i, q = b0 + sum t_j v_j; minimise |p - q|^2: normal equations.
            const QuadPoint a0 = quad(a[fa[1]]), b0 = quad(b[fb[1]]);
            std::array<QuadPoint, 4> d;
            int n = 0;
            for (int i = 1; i < fa[0]; ++i)
                d[n++] = quad(a[fa[1 + i]]) - a0;
            const int na = n;
            for (int j = 1; j < fb[0]; ++j)
                d[n++] = b0 - quad(b[fb[1 + j]]);
            const QuadPoint r = a0 - b0;
            Quad m[4][5];
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j)
                    m[i][j] = dot(d[i], d[j]);
                m[i][n] = -dot(d[i], r);
            }
            bool singular = false;
            for (int c = 0; c < n && !singular; ++c) {
                int pivot = c;
                for (int i = c + 1; i < n; ++i) {
                    if (std::fabs(static_cast<double>(m[i][c])) > std::fabs(static_cast<double>(m[pivot][c])))
                        pivot = i;
                }
                std::swap(m[c], m[pivot]);
                if (m[c][c] < Quad(1e-26) && m[c][c] > Quad(-1e-26)) {
                    singular = true;  // a lower-dimensional pair of faces has the same minimum
                    break;
                }
                for (int i = 0; i < n; ++i) {
                    if (i == c) continue;
                    const Quad f = m[i][c] / m[c][c];
                    for (int j = c; j <= n; ++j)
                        m[i][j] -= f * m[c][j];
                }
            }
            if (singular) continue;
            Quad sum_a = 0, sum_b = 0;
            bool inside = true;
            QuadPoint apart = r;
            for (int i = 0; i < n; ++i) {
                const Quad w = m[i][n] / m[i][i];
                inside = inside && w >= 0;
                (i < na ? sum_a : sum_b) += w;
                apart = apart + w * d[i];
            }
            if (!inside || sum_a > 1 || sum_b > 1) continue;
            const Quad square = dot(apart, apart);
            if (best < 0 || square < best) best = square;
        }
    }
    return std::sqrt(static_cast<double>(best));
}

inline double quad_distance(const Bvh& a, const Vec3& offset, const Bvh& b) {
    double best = Box::kInfinity;
    for (std::size_t i = 0; i < a.triangle_count(); ++i) {
        Corners one = a.corners(i);
        for (Vec3& corner : one)
            corner = corner + offset;
        for (std::size_t j = 0; j < b.triangle_count(); ++j) {
            best = std::min(best, quad_distance(one, b.corners(j)));
        }
    }
    return best;
}

/// Numbers that make trouble: few distinct ones (so that corners, edges and planes coincide), or
/// anything.
class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : random_(seed) {}

    double coarse() { return static_cast<double>(random_.below(4)); }
    double fine() { return 10 * random_.unit() - 5; }
    std::uint64_t below(std::uint64_t n) { return random_.below(n); }
    double unit() { return random_.unit(); }

    Vec3 point(bool coarse_ones) {
        return coarse_ones ? Vec3{coarse(), coarse(), coarse()} : Vec3{fine(), fine(), fine()};
    }

    /// Any triangle: also needles, segments, points, ones with two equal corners.
    Corners triangle(bool coarse_ones) {
        Corners t{point(coarse_ones), point(coarse_ones), point(coarse_ones)};
        switch (below(8)) {
            case 0:
                t[2] = t[1];
                break;
            case 1:
                t[1] = t[2] = t[0];
                break;
            case 2:
                t[2] = t[0] + unit() * (t[1] - t[0]);
                break;
            case 3:
                t[2] = t[0] + (t[1] - t[0]) * 0.5 + 1e-7 * point(false);
                break;
            case 4:
                t[2] = t[1] + 1e-9 * point(false);
                break;
            default:
                break;
        }
        return t;
    }

  private:
    RandomStream random_;
};

inline AxisDirection any_direction(Numbers& numbers) {
    return {static_cast<int>(numbers.below(3)), numbers.below(2) ? 1 : -1};
}

inline Corners moved(Corners t, const Vec3& by) {
    for (Vec3& corner : t)
        corner = corner + by;
    return t;
}

}  // namespace spectralpack::test
