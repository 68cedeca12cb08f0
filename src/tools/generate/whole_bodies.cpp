#include "tools/generate/whole_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tools/generate/implicit_surface.hpp"

namespace spectralpack::tools {
namespace {

constexpr double kStep = 2.5;  // mm, of the grid that surfaces are made on
constexpr double kWall = 5;    // mm, of what is hollow

/// About the distance to an ellipsoid's surface, and exactly where its radii are equal.
double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
    const Vec3 d = p - centre;
    const Vec3 once{d.x / radii.x, d.y / radii.y, d.z / radii.z};
    const Vec3 twice{once.x / radii.x, once.y / radii.y, once.z / radii.z};
    const double slope = length(twice);
    const double share = length(once);
    return slope > 0 ? share * (share - 1) / slope : -std::min({radii.x, radii.y, radii.z});
}

/// Of a rod with round ends that grows from one radius to the other.
double rod(const Vec3& p, const Vec3& from, const Vec3& to, double radius, double end_radius) {
    const Vec3 along = to - from;
    const double share = std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0);
    return length(p - from - share * along) - (radius + share * (end_radius - radius));
}

/// The union of two, with a fillet of about that size (Quilez, "Smooth minimum").
double merged(double a, double b, double fillet) {
    const double h = std::max(fillet - std::abs(a - b), 0.0) / fillet;
    return std::min(a, b) - h * h * fillet / 4;
}

Vec3 mirrored(const Vec3& p) { return {p.x, -p.y, p.z}; }

/// Its trunk and head, without what sticks out.
double bunny_core(const Vec3& p) {
    const double body = ellipsoid(p, {0, 0, 32}, {35, 27, 30});
    const double chest = ellipsoid(p, {20, 0, 44}, {20, 19, 24});
    const double head = ellipsoid(p, {34, 0, 70}, {20, 16, 16});
    return merged(merged(body, chest, 10), head, 6);
}

double bunny(const Vec3& p) {
    const double core = bunny_core(p);
    double d = merged(core, ellipsoid(p, {-36, 0, 24}, {10, 10, 10}), 3);  // tail
    for (const Vec3& q : {p, mirrored(p)}) {
        d = merged(d, ellipsoid(q, {-12, 20, 24}, {20, 13, 20}), 5);  // haunch
        d = merged(d, rod(q, {-14, 24, 7}, {14, 25, 6}, 8, 7), 4);    // hind foot
        d = merged(d, rod(q, {26, 10, 24}, {38, 10, 7}, 8, 7), 4);    // foreleg
        d = merged(d, rod(q, {27, 8, 80}, {8, 17, 116}, 5.5, 7), 5);  // ear
    }
    // It sits on something flat, and is hollow.
    return std::max({d, -p.z, -core - kWall});
}

double molecule(const Vec3& p) {
    constexpr double kRing = 36, kHeight = 0.8660254037844386 * kRing;  // mm; half the root of 3
    constexpr double kRod = 4.5, kFillet = 3;
    static const std::vector<std::pair<Vec3, double>> atoms{{{kRing, 0, 0}, 13},
                                                            {{kRing / 2, kHeight, 3}, 13},
                                                            {{-kRing / 2, kHeight, -3}, 14},
                                                            {{-kRing, 0, 0}, 13},
                                                            {{-kRing / 2, -kHeight, 3}, 13},
                                                            {{kRing / 2, -kHeight, -3}, 14},
                                                            {{kRing + 32, 0, 14}, 10},
                                                            {{-kRing / 2 - 16, kHeight + 26, 10}, 11},
                                                            {{-kRing - 24, 0, -22}, 10},
                                                            {{kRing / 2 + 12, -kHeight - 20, -26}, 11}};
    static const std::vector<std::pair<int, int>> bonds{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5},
                                                        {5, 0}, {0, 6}, {2, 7}, {3, 8}, {5, 9}};
    const auto at = [&](int i) { return atoms[static_cast<std::size_t>(i)].first; };
    double d = Box::kInfinity;
    for (const auto& [centre, radius] : atoms) {
        d = std::min(d, length(p - centre) - radius);
    }
    for (const auto& [a, b] : bonds) {
        d = merged(d, rod(p, at(a), at(b), kRod, kRod), kFillet);
    }
    return d;
}

}  // namespace

Mesh at_origin(const Mesh& mesh) { return transformed(mesh, {Mat3{}, -bounding_box(mesh).min}); }

Mesh bunny_body() { return at_origin(surface_of(bunny, {{-52, -42, -3.75}, {62, 42, 131}}, kStep)); }

Mesh molecule_body() { return at_origin(surface_of(molecule, {{-76, -70, -46}, {84, 76, 32}}, kStep)); }

}  // namespace spectralpack::tools
