#include "tools/generate/turned_parts.hpp"

#include <algorithm>

#include "tools/generate/loft.hpp"

namespace spectralpack::tools {
namespace {

constexpr int kSegments = 32;

double thin_wall(Dice& dice, double size) { return dice.mm(std::max(1.0, 0.02 * size), std::max(1.6, 0.05 * size)); }

/// A vessel from its outside (upwards) and the wall's thickness, with a floor as thick.
Mesh vessel(const Outline& outside, double wall) {
    const double floor = outside.front().y + wall;
    std::vector<Loop> loops;
    for (const Vec2& p : outside) {
        loops.push_back(at_height(circle(p.x, kSegments), p.y));
    }
    for (std::size_t i = outside.size(); i-- > 0 && outside[i].y > floor + wall / 2;) {
        loops.push_back(at_height(circle(outside[i].x - wall, kSegments), outside[i].y));
    }
    // The floor looks upwards from inside, so it is a last cap like any other.
    loops.push_back(at_height(circle(outside.front().x - wall, kSegments), floor));
    return loft(loops, LoftEnds::capped);
}

}  // namespace

Mesh washer(Dice& dice, double size) {
    const double bore = dice.between(0.25, 0.65) * size / 2;
    return ring_prism(circle(size / 2, kSegments), circle(bore, kSegments), 0, dice.mm(0.05 * size, 0.3 * size));
}

Mesh bushing(Dice& dice, double size) {
    const double bore = dice.between(0.2, 0.35) * size / 2, sleeve = dice.between(0.5, 0.7) * size / 2;
    const double flange = dice.mm(0.08 * size, 0.15 * size), height = dice.mm(0.4 * size, 0.95 * size);
    return turned_ring(
        {{bore, 0}, {size / 2, 0}, {size / 2, flange}, {sleeve, flange}, {sleeve, height}, {bore, height}}, kSegments);
}

Mesh pin(Dice& dice, double size) {
    const double head = dice.between(0.2, 0.45) * size / 2, shaft = dice.between(0.45, 0.7) * head;
    const double tall = dice.between(0.1, 0.25) * size;
    return turned_solid(
        {{0.85 * head, 0}, {head, 0.15 * tall}, {head, tall}, {shaft, tall}, {shaft, 0.97 * size}, {0.8 * shaft, size}},
        24);
}

Mesh knob(Dice& dice, double size) {
    const int lobes = dice.number(3, 8), count = 6 * lobes;
    const double depth = dice.between(0.05, 0.12), radius = size / 2 / (1 + depth);
    const double neck = dice.between(0.35, 0.55) * radius, height = dice.between(0.35, 0.8) * size;
    const double under = dice.between(0.2, 0.5) * height;
    std::vector<Loop> loops{at_height(circle(neck, count), 0), at_height(circle(neck, count), under)};
    for (const Vec2& p : {Vec2{0.9, 0}, Vec2{1, 0.15}, Vec2{1, 0.8}, Vec2{0.88, 1}}) {
        loops.push_back(at_height(lobed(p.x * radius, depth, lobes, count), under + p.y * (height - under)));
    }
    return loft(loops, LoftEnds::capped);
}

Mesh gear(Dice& dice, double size) {
    const int teeth = dice.number(10, 28);
    const double tip = size / 2, root = tip * (1 - dice.between(1.6, 2.4) / (teeth + 2));
    const Outline bore = circle(dice.between(0.15, 0.5) * root, 4 * teeth);
    return ring_prism(gear_outline(root, tip, teeth), bore, 0, dice.mm(0.1 * size, 0.4 * size));
}

Mesh pipe(Dice& dice, double size) {
    const double radius = dice.between(0.08, 0.25) * size, wall = thin_wall(dice, size);
    return ring_prism(circle(radius, kSegments), circle(std::max(radius - wall, 0.5 * radius), kSegments), 0, size);
}

Mesh cup(Dice& dice, double size) {
    const double wall = thin_wall(dice, size), rim = dice.between(0.25, 0.45) * size;
    const double foot = dice.between(0.6, 1) * rim;
    Outline outside;
    for (int i = 0; i <= 6; ++i) {
        const double t = i / 6.0;
        outside.push_back({foot + t * t * (rim - foot), t * size});
    }
    return vessel(outside, std::min(wall, 0.3 * foot));
}

Mesh bowl(Dice& dice, double size) {
    const double wall = thin_wall(dice, size), height = dice.between(0.3, 0.5) * size;
    Outline outside;
    for (int i = 0; i <= 8; ++i) {
        const Vec2 d = direction(0.25 * i / 8);  // from the foot round to the rim
        outside.push_back({size / 2 * (0.4 + 0.6 * d.y), height * (1 - d.x)});
    }
    return vessel(outside, std::min(wall, 0.09 * size));
}

Mesh funnel(Dice& dice, double size) {
    const double wall = std::min(thin_wall(dice, size), 0.04 * size), rim = dice.between(0.3, 0.5) * size;
    const double neck = dice.between(0.15, 0.3) * rim + wall, throat = dice.between(0.3, 0.5) * size;
    return turned_ring(
        {{neck - wall, 0}, {neck, 0}, {neck, throat}, {rim, size}, {rim - wall, size}, {neck - wall, throat}},
        kSegments);
}

}  // namespace spectralpack::tools
