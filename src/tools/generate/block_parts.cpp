#include "tools/generate/block_parts.hpp"

#include <algorithm>

#include "tools/generate/blocks.hpp"
#include "tools/generate/loft.hpp"

namespace spectralpack::tools {
namespace {

/// How far a cut reaches beyond what it cuts.
constexpr double kThrough = 1;

/// The wall of a part of this size: as thin as printers make it, thicker in large parts.
double wall_of(Dice& dice, double size) { return dice.mm(std::max(1.0, 0.035 * size), std::max(1.6, 0.09 * size)); }

/// Cuts `count` windows into a plate, side by side in x between x0 and x1; z is the plate's own way.
void cut_row(Blocks& blocks, int count, double x0, double x1, double y0, double y1, double z0, double z1) {
    const double pitch = (x1 - x0) / (3 * count + 1);
    for (int i = 0; i < count; ++i) {
        const double x = x0 + (3 * i + 1) * pitch;
        blocks.cut({x, y0, z0 - kThrough}, {x + 2 * pitch, y1, z1 + kThrough});
    }
}

/// A block without a lid; its walls and floor are `wall` thick.
Blocks open_case(double length, double width, double height, double wall) {
    Blocks blocks;
    blocks.add({0, 0, 0}, {length, width, height});
    blocks.cut({wall, wall, wall}, {length - wall, width - wall, height + kThrough});
    return blocks;
}

}  // namespace

Mesh bracket(Dice& dice, double size) {
    const double wall = wall_of(dice, size);
    const double width = dice.mm(0.3 * size, 0.8 * size), height = dice.mm(0.35 * size, 0.95 * size);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, width, wall});
    blocks.add({0, 0, 0}, {wall, width, height});
    const int slots = dice.number(0, 3);
    if (slots > 0) {
        cut_row(blocks, slots, 0.3 * size, size, 0.1 * width, 0.4 * width, 0, wall);
        cut_row(blocks, slots, 0.3 * size, size, 0.6 * width, 0.9 * width, 0, wall);
    }
    if (dice.chance(0.6)) {
        blocks.add({wall, 0.44 * width, wall}, {0.6 * size, 0.56 * width, 0.55 * height});
    }
    return blocks.mesh();
}

Mesh channel(Dice& dice, double size) {
    const double wall = wall_of(dice, size);
    const double width = dice.mm(0.2 * size, 0.6 * size), height = dice.mm(0.2 * size, 0.5 * size);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, width, height});
    blocks.cut({-kThrough, wall, wall}, {size + kThrough, width - wall, height + kThrough});
    const int slots = dice.number(0, 4);
    if (slots > 0) cut_row(blocks, slots, 0, size, 0.4 * width, 0.6 * width, 0, wall);
    return blocks.mesh();
}

Mesh l_block(Dice& dice, double size) {
    const double width = dice.mm(0.2 * size, 0.7 * size), height = dice.mm(0.3 * size, 0.9 * size);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, width, height});
    blocks.cut({dice.mm(0.3 * size, 0.7 * size), -kThrough, dice.mm(0.3 * height, 0.7 * height)},
               {size + kThrough, width + kThrough, height + kThrough});
    return blocks.mesh();
}

Mesh tee(Dice& dice, double size) {
    const double width = dice.mm(0.2 * size, 0.6 * size), height = dice.mm(0.3 * size, 0.9 * size);
    const double foot = dice.mm(0.15 * height, 0.4 * height), stem = dice.mm(0.2 * size, 0.4 * size);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, width, foot});
    blocks.add({(size - stem) / 2, 0, foot}, {(size + stem) / 2, width, height});
    return blocks.mesh();
}

Mesh steps(Dice& dice, double size) {
    const double width = dice.mm(0.2 * size, 0.7 * size), rise = dice.mm(0.1 * size, 0.25 * size);
    const int count = dice.number(2, 4);
    Blocks blocks;
    for (int i = 0; i < count; ++i) {
        blocks.add({0, 0, i * rise}, {size * (count - i) / count, width, (i + 1) * rise});
    }
    return blocks.mesh();
}

Mesh drilled_block(Dice& dice, double size) {
    const double width = dice.mm(0.3 * size, 0.9 * size), height = dice.mm(0.2 * size, 0.8 * size);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, width, height});
    blocks.cut({0.3 * size, 0.3 * width, -kThrough}, {0.6 * size, 0.7 * width, height + kThrough});
    return blocks.mesh();
}

Mesh window_plate(Dice& dice, double size) {
    const double width = dice.mm(0.3 * size, 0.95 * size), wall = wall_of(dice, size);
    const int rows = dice.number(1, 3), columns = dice.number(1, 5);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, width, wall});
    for (int i = 0; i < rows; ++i) {
        cut_row(blocks, columns, 0, size, width * (i + 0.2) / rows, width * (i + 0.8) / rows, 0, wall);
    }
    if (dice.chance(0.5)) blocks.add({0, 0, wall}, {size, 0.1 * width, wall + dice.mm(2, 0.2 * size + 2)});
    return blocks.mesh();
}

Mesh tray(Dice& dice, double size) {
    const double wall = wall_of(dice, size);
    const double width = dice.mm(0.5 * size, 0.95 * size), height = dice.mm(0.25 * size, 0.6 * size);
    Blocks blocks = open_case(size, width, height, wall);
    const int compartments = dice.number(1, 3);
    for (int i = 1; i < compartments; ++i) {
        const double x = size * i / compartments;
        blocks.add({x - wall / 2, wall, wall}, {x + wall / 2, width - wall, 0.8 * height});
    }
    return blocks.mesh();
}

Mesh wedge(Dice& dice, double size) {
    const double width = dice.mm(0.3 * size, 0.7 * size), height = dice.mm(0.25 * size, 0.6 * size);
    const double nose = dice.mm(0.05 * size, 0.1 * size);
    const Outline side{{0, 0}, {size, 0}, {size, nose}, {0, height}};
    return prism(side, 0, width);
}

Mesh flat_frame(Dice& dice, double size) {
    const double bar = dice.mm(0.035 * size, 0.08 * size), width = dice.mm(0.5 * size, size);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, width, bar});
    blocks.cut({bar, bar, -kThrough}, {size - bar, width - bar, bar + kThrough});
    return blocks.mesh();
}

Mesh ladder(Dice& dice, double size) {
    const double bar = dice.mm(0.03 * size, 0.05 * size), width = dice.mm(0.3 * size, 0.5 * size);
    const int rungs = dice.number(2, 5);
    Blocks blocks;
    blocks.add({0, 0, 0}, {size, bar, bar});
    blocks.add({0, width - bar, 0}, {size, width, bar});
    for (int i = 0; i < rungs; ++i) {
        const double x = (size - bar) * (i + 0.5) / rungs;
        blocks.add({x, bar, 0}, {x + bar, width - bar, bar});
    }
    return blocks.mesh();
}

Mesh cage(Dice& dice, double size) {
    const double bar = dice.mm(0.05 * size, 0.09 * size);
    const Vec3 high{size, dice.mm(0.5 * size, size), dice.mm(0.5 * size, size)};
    Blocks blocks;
    blocks.add({0, 0, 0}, high);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 from{bar, bar, bar}, to = high - from;
        from[axis] = -kThrough;
        to[axis] = high[axis] + kThrough;
        blocks.cut(from, to);
    }
    return blocks.mesh();
}

Mesh basket(Dice& dice, double size) {
    const double wall = dice.mm(0.025 * size, 0.05 * size);
    const double width = dice.mm(0.6 * size, size), height = dice.mm(0.4 * size, 0.8 * size);
    Blocks blocks = open_case(size, width, height, wall);
    const int windows = dice.number(2, 4);
    for (int i = 0; i < windows; ++i) {
        const double from = (i + 0.2) / windows, to = (i + 0.8) / windows;
        const double x0 = wall + from * (size - 2 * wall), x1 = wall + to * (size - 2 * wall);
        const double y0 = wall + from * (width - 2 * wall), y1 = wall + to * (width - 2 * wall);
        blocks.cut({x0, -kThrough, 0.3 * height}, {x1, width + kThrough, 0.85 * height});
        blocks.cut({-kThrough, y0, 0.3 * height}, {size + kThrough, y1, 0.85 * height});
    }
    return blocks.mesh();
}

}  // namespace spectralpack::tools
