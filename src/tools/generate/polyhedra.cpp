#include "tools/generate/polyhedra.hpp"

#include "tools/generate/loft.hpp"

namespace spectralpack::tools {
namespace {

/// Of a star-shaped outline at height 0, counter-clockwise, up to a tip over its kernel, and closed below by a fan from
/// `bottom`, which lies in the kernel at height 0 or under it.
Mesh double_pyramid(const Outline& belt, const Vec3& top, const Vec3& bottom) {
    Mesh mesh;
    mesh.vertices = at_height(belt, 0);
    const auto count = static_cast<std::uint32_t>(belt.size());
    mesh.vertices.push_back(top);
    mesh.vertices.push_back(bottom);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        mesh.triangles.push_back({i, next, count});
        mesh.triangles.push_back({next, i, count + 1});
    }
    return mesh;
}

Mesh single_pyramid(const Outline& base, const Vec3& top) { return double_pyramid(base, top, {}); }

/// Corners in equal directions, each at a distance of its own of up to half of `size`.
Outline uneven(Dice& dice, int corners, double size) {
    Outline outline = circle(size / 2, corners);
    for (Vec2& corner : outline) {
        const double share = dice.between(0.75, 1);
        corner = {share * corner.x, share * corner.y};
    }
    return outline;
}

}  // namespace

Mesh tetrahedron(Dice& dice, double size) {
    const double lean = dice.between(-0.15, 0.15) * size;
    const double height = dice.mm(0.35 * size, 0.8 * size);
    return single_pyramid(uneven(dice, 3, size), {lean, 0, height});
}

Mesh pyramid(Dice& dice, double size) {
    const double lean = dice.between(-0.2, 0.2) * size;
    const double height = dice.mm(0.3 * size, 0.7 * size);
    return single_pyramid(uneven(dice, dice.number(4, 5), size), {lean, 0, height});
}

Mesh frustum(Dice& dice, double size) {
    const Outline foot = uneven(dice, dice.number(4, 6), size);
    const double share = dice.between(0.4, 0.8), lean = dice.between(-0.1, 0.1) * size;
    Outline lid = foot;
    for (Vec2& corner : lid) {
        corner = {lean + share * corner.x, share * corner.y};
    }
    return loft({at_height(foot, 0), at_height(lid, dice.mm(0.3 * size, 0.6 * size))}, LoftEnds::capped);
}

Mesh bipyramid(Dice& dice, double size) {
    const Outline belt = uneven(dice, dice.number(4, 6), size);
    const double below = dice.mm(0.1 * size, 0.3 * size), above = dice.mm(0.2 * size, 0.4 * size);
    return double_pyramid(belt, {0, 0, above}, {0, 0, -below});
}

Mesh twisted_prism(Dice& dice, double size) {
    const int corners = dice.number(3, 4);
    const double turn = dice.between(0.04, 0.08);  // in full turns; the other way the sides would bulge
    return loft({at_height(circle(size / 2, corners), 0),
                 at_height(circle(size / 2, corners, turn), dice.mm(0.4 * size, 0.7 * size))},
                LoftEnds::capped);
}

Mesh dart(Dice& dice, double size) {
    const double wing = dice.mm(0.35 * size, 0.5 * size), notch = dice.mm(0.15 * size, 0.3 * size);
    const Outline belt{{size, 0}, {0, wing}, {notch, 0}, {0, -wing}};
    const double middle = (notch + size) / 2;
    const double below = dice.mm(0.1 * size, 0.2 * size), above = dice.mm(0.15 * size, 0.3 * size);
    return double_pyramid(belt, {middle, 0, above}, {middle, 0, -below});
}

Mesh star(Dice& dice, double size) {
    const int tips = dice.number(3, 5);
    const double inner = dice.between(0.4, 0.6);
    Outline belt = circle(size / 2, 2 * tips);
    for (std::size_t i = 1; i < belt.size(); i += 2) {
        belt[i] = {inner * belt[i].x, inner * belt[i].y};
    }
    const double below = dice.mm(0.1 * size, 0.25 * size), above = dice.mm(0.2 * size, 0.35 * size);
    return double_pyramid(belt, {0, 0, above}, {0, 0, -below});
}

}  // namespace spectralpack::tools
