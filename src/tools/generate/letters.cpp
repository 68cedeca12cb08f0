#include "tools/generate/letters.hpp"

#include <map>
#include <utility>
#include <vector>

#include "tools/generate/outline.hpp"

namespace spectralpack::tools {
namespace {

constexpr double kSide = 322, kDeep = 80;  // mm
constexpr double kStroke = 64;             // mm, width of a stroke
constexpr int kArcPoints = 25;             // of half a circle

/// A flat shape as convex polygons that share whole edges; extruded in the end.
class Shape2 {
  public:
    void polygon(const Outline& corners) {
        std::vector<std::uint32_t> indices;
        for (const Vec2& p : corners) {
            const auto next = static_cast<std::uint32_t>(points_.size());
            const auto [at, fresh] = index_.emplace(std::pair(p.x, p.y), next);
            if (fresh) points_.push_back(p);
            indices.push_back(at->second);
        }
        polygons_.push_back(std::move(indices));
    }

    /// Quads between two lines of as many points; `left` lies on the left as one goes along.
    void strip(const Outline& left, const Outline& right) {
        for (std::size_t i = 0; i + 1 < left.size(); ++i) {
            polygon({right[i], right[i + 1], left[i + 1], left[i]});
        }
    }

    Mesh extruded(double depth) const {
        Mesh mesh;
        const auto count = static_cast<std::uint32_t>(points_.size());
        for (const double z : {0.0, depth}) {
            for (const Vec2& p : points_) {
                mesh.vertices.push_back({p.x, p.y, z});
            }
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const std::vector<std::uint32_t>& p : polygons_) {
            for (std::size_t i = 0; i < p.size(); ++i) {
                ++edges[{p[i], p[(i + 1) % p.size()]}];
            }
            for (std::size_t i = 1; i + 1 < p.size(); ++i) {
                mesh.triangles.push_back({p[0], p[i + 1], p[i]});
                mesh.triangles.push_back({p[0] + count, p[i] + count, p[i + 1] + count});
            }
        }
        for (const auto& [edge, times] : edges) {
            const auto [a, b] = edge;
            if (edges.contains({b, a})) continue;  // inside
            mesh.triangles.push_back({a, b, b + count});
            mesh.triangles.push_back({a, b + count, a + count});
        }
        return mesh;
    }

  private:
    std::vector<Vec2> points_;
    std::map<std::pair<double, double>, std::uint32_t> index_;
    std::vector<std::vector<std::uint32_t>> polygons_;
};

Outline rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Outline operator+(Outline first, const Outline& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Shape2 letter_s() {
    // Two rings, one on the other, each open on one side.
    const double outer = (kSide + kStroke) / 4, inner = outer - kStroke;
    const Vec2 upper{outer, kSide - outer}, lower{kSide - outer, outer};
    Shape2 s;
    s.strip(Outline{{kSide, kSide - kStroke}} + arc(upper, inner, 0.25, 0.75, kArcPoints) +
                arc(lower, outer, 0.25, -0.25, kArcPoints) + Outline{{0, 0}},
            Outline{{kSide, kSide}} + arc(upper, outer, 0.25, 0.75, kArcPoints) +
                arc(lower, inner, 0.25, -0.25, kArcPoints) + Outline{{0, kStroke}});
    return s;
}

Shape2 letter_i() {
    const double left = (kSide - kStroke) / 2, right = left + kStroke, top = kSide - kStroke;
    Shape2 i;
    for (const double y : {0.0, top}) {
        i.polygon(rectangle(0, y, left, y + kStroke));
        i.polygon(rectangle(left, y, right, y + kStroke));
        i.polygon(rectangle(right, y, kSide, y + kStroke));
    }
    i.polygon(rectangle(left, kStroke, right, top));
    return i;
}

Shape2 letter_g() {
    const double outer = kSide / 2, inner = outer - kStroke;
    const Vec2 middle{outer, outer};
    const double bar = middle.y + 54;  // top of the bar that ends the letter
    Shape2 g;
    const double angles[] = {0.14, 0.25, 0.5, 0.75, 1};  // so that the letter reaches its box exactly
    for (int i = 0; i < 4; ++i) {
        g.strip(arc(middle, inner, angles[i], angles[i + 1], kArcPoints / 2),
                arc(middle, outer, angles[i], angles[i + 1], kArcPoints / 2));
    }
    const double right = middle.x + inner;
    g.polygon(rectangle(right, middle.y, kSide, bar));
    g.polygon(rectangle(middle.x + 9, middle.y, right, bar));
    return g;
}

/// The stem and bowl that P and R share. Points on the lower edge of the bowl are named, so that a leg
/// can stand on them.
Shape2 stem_and_bowl(const Outline& leg) {
    const double outer = 101, inner = outer - kStroke, low = kSide - 2 * outer;
    const Vec2 middle{kSide - outer, kSide - outer};
    Shape2 p;
    const double heights[] = {0, low, low + kStroke, kSide - kStroke, kSide};
    for (int i = 0; i < 4; ++i) {
        p.polygon(rectangle(0, heights[i], kStroke, heights[i + 1]));
    }
    Outline below{{kStroke, low}}, above{{kStroke, low + kStroke}};
    for (const Vec2& point : leg) {
        below.push_back({point.x, low});
        above.push_back({point.x, low + kStroke});
    }
    p.strip(above + arc(middle, inner, -0.25, 0.25, kArcPoints) + Outline{{kStroke, kSide - kStroke}},
            below + arc(middle, outer, -0.25, 0.25, kArcPoints) + Outline{{kStroke, kSide}});
    return p;
}

Shape2 letter_r() {
    const double low = kSide - 2 * 101.0;
    const Outline leg{{130, low}, {210, low}};
    Shape2 r = stem_and_bowl(leg);
    r.polygon({{kSide - 80, 0}, {kSide, 0}, leg[1], leg[0]});
    return r;
}

Shape2 letter_a() {
    const double foot = 68, lean = 126.0 / kSide;  // x per y of a leg
    const double apex = (kSide / 2 - foot) / lean;
    const auto outer = [&](double y) { return Vec2{lean * y, y}; };
    const auto inner = [&](double y) { return Vec2{foot + lean * y, y}; };
    const auto mirrored = [](const Vec2& p) { return Vec2{kSide - p.x, p.y}; };
    const double bar[] = {80, 140};
    const Vec2 top{kSide / 2, apex};
    Shape2 a;
    a.strip({outer(0), outer(bar[0]), outer(bar[1]), outer(apex)}, {inner(0), inner(bar[0]), inner(bar[1]), top});
    a.strip({mirrored(inner(0)), mirrored(inner(bar[0])), mirrored(inner(bar[1])), top},
            {mirrored(outer(0)), mirrored(outer(bar[0])), mirrored(outer(bar[1])), mirrored(outer(apex))});
    a.polygon({top, mirrored(outer(apex)), mirrored(outer(kSide)), outer(kSide), outer(apex)});
    a.polygon({inner(bar[0]), mirrored(inner(bar[0])), mirrored(inner(bar[1])), inner(bar[1])});
    return a;
}

Shape2 letter_h() {
    const double low = (kSide - kStroke) / 2, heights[] = {0, low, low + kStroke, kSide};
    Shape2 h;
    for (const double x : {0.0, kSide - kStroke}) {
        for (int i = 0; i < 3; ++i) {
            h.polygon(rectangle(x, heights[i], x + kStroke, heights[i + 1]));
        }
    }
    h.polygon(rectangle(kStroke, low, kSide - kStroke, low + kStroke));
    return h;
}

Shape2 shape_of(char letter) {
    switch (letter) {
        case 'S':
            return letter_s();
        case 'I':
            return letter_i();
        case 'G':
            return letter_g();
        case 'R':
            return letter_r();
        case 'A':
            return letter_a();
        case 'P':
            return stem_and_bowl({});
        default:
            return letter_h();
    }
}

}  // namespace

Mesh letter_mesh(char letter) { return shape_of(letter).extruded(kDeep); }

}  // namespace spectralpack::tools
