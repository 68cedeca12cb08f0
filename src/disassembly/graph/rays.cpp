#include "disassembly/graph/rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spectralpack {
namespace {

/// What a ray sees of one copy.
struct Span {
    std::int64_t ray;
    std::uint32_t copy;
    float first, last;  // 1e-5 of a millimetre in a metre: far below kRayTolerance
};

/// The rays along one axis that can hit a box, as a grid of their own.
class RayGrid {
  public:
    RayGrid(const Box& box, int axis, double spacing)
        : axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), spacing_(spacing) {
        u0_ = first(box.min[u_]);
        v0_ = first(box.min[v_]);
        nu_ = static_cast<std::size_t>(std::max<std::int64_t>(0, first(box.max[u_]) - u0_));
        nv_ = static_cast<std::size_t>(std::max<std::int64_t>(0, first(box.max[v_]) - v0_));
        first_.assign(nu_ * nv_, std::numeric_limits<float>::max());
        last_.assign(nu_ * nv_, std::numeric_limits<float>::lowest());
    }

    void add(const Corners& corners) {
        const Vec3 &a = corners[0], &b = corners[1], &c = corners[2];
        const double ub = b[u_] - a[u_], vb = b[v_] - a[v_], uc = c[u_] - a[u_], vc = c[v_] - a[v_];
        const double area = ub * vc - uc * vb;
        if (!(std::abs(area) > kFlat)) return;
        const double wb = b[axis_] - a[axis_], wc = c[axis_] - a[axis_];
        const double per_u = (wb * vc - wc * vb) / area, per_v = (wc * ub - wb * uc) / area;
        // Steep triangles: rounding must not lead out of them.
        const double least = std::min({a[axis_], b[axis_], c[axis_]});
        const double most = std::max({a[axis_], b[axis_], c[axis_]});
        const std::int64_t v_begin = std::max(v0_, first(std::min({a[v_], b[v_], c[v_]})));
        const std::int64_t v_end =
            std::min(v0_ + static_cast<std::int64_t>(nv_), first(std::max({a[v_], b[v_], c[v_]})));
        for (std::int64_t j = v_begin; j < v_end; ++j) {
            const double v = at(j);
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 &p = corners[i], &q = corners[(i + 1) % 3];
                if ((p[v_] <= v) == (q[v_] <= v)) continue;
                const double u = p[u_] + (v - p[v_]) / (q[v_] - p[v_]) * (q[u_] - p[u_]);
                low = std::min(low, u);
                high = std::max(high, u);
            }
            if (!(low < high)) continue;
            const std::int64_t u_begin = std::max(u0_, first(low));
            const std::int64_t u_end = std::min(u0_ + static_cast<std::int64_t>(nu_), first(high));
            for (std::int64_t i = u_begin; i < u_end; ++i) {
                const double w = a[axis_] + (at(i) - a[u_]) * per_u + (v - a[v_]) * per_v;
                const auto hit = static_cast<float>(std::clamp(w, least, most));
                const std::size_t k = static_cast<std::size_t>(j - v0_) * nu_ + static_cast<std::size_t>(i - u0_);
                first_[k] = std::min(first_[k], hit);
                last_[k] = std::max(last_[k], hit);
            }
        }
    }

    /// Appends the spans of rays that hit something. Rays are numbered alike for all boxes.
    void take(std::uint32_t copy, std::vector<Span>& spans) const {
        for (std::size_t k = 0; k < first_.size(); ++k) {
            if (first_[k] > last_[k]) continue;
            const std::int64_t u = u0_ + static_cast<std::int64_t>(k % nu_);
            const std::int64_t v = v0_ + static_cast<std::int64_t>(k / nu_);
            spans.push_back({(v << 32) + u, copy, first_[k], last_[k]});
        }
    }

  private:
    static constexpr double kFlat = 1e-12;  // mm^2: seen edge on

    double at(std::int64_t ray) const { return (static_cast<double>(ray) + 0.5) * spacing_; }
    /// The first ray at or beyond `coordinate`.
    std::int64_t first(double coordinate) const {
        return static_cast<std::int64_t>(std::ceil(coordinate / spacing_ - 0.5));
    }

    int axis_, u_, v_;
    double spacing_;
    std::int64_t u0_, v0_;
    std::size_t nu_, nv_;
    std::vector<float> first_, last_;
};

void add_edges(std::vector<Span>& spans, int axis, BlockingGraph& graph) {
    std::sort(spans.begin(), spans.end(),
              [](const Span& a, const Span& b) { return a.ray != b.ray ? a.ray < b.ray : a.copy < b.copy; });
    for (std::size_t begin = 0, end; begin < spans.size(); begin = end) {
        for (end = begin; end < spans.size() && spans[end].ray == spans[begin].ray;)
            ++end;
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t j = begin; j < end; ++j) {
                if (i != j && spans[i].first < spans[j].last - kRayTolerance) {
                    graph.add(spans[i].copy, {axis, 1}, spans[j].copy);
                }
            }
        }
    }
}

}  // namespace

void cast_rays(const std::vector<const Body*>& parts, double spacing, BlockingGraph& graph, const Workers& workers) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::vector<Span>> of_copy(parts.size());
        workers.for_each(static_cast<std::int64_t>(parts.size()), [&](std::int64_t i) {
            const auto copy = static_cast<std::size_t>(i);
            const Body& part = *parts[copy];
            RayGrid rays(part.box(), axis, spacing);
            for (std::size_t t = 0; t < part.surface->triangle_count(); ++t) {
                Corners corners = part.surface->corners(t);
                for (Vec3& corner : corners) {
                    corner = corner + part.offset;
                }
                rays.add(corners);
            }
            rays.take(static_cast<std::uint32_t>(copy), of_copy[copy]);
        });
        std::vector<Span> spans;
        for (std::vector<Span>& of : of_copy) {
            spans.insert(spans.end(), of.begin(), of.end());
            of = {};
        }
        add_edges(spans, axis, graph);
    }
}

}  // namespace spectralpack
