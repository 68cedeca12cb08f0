#pragma once
/// Small random trays, shapes and changes for testing engines. Everything follows from the
/// RandomStream, so a seed names a scene on every machine. Shapes are hand-made bit grids: an engine does not care that
/// orientations of one mesh belong together.

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "random_grids.hpp"
#include "search/cost.hpp"
#include "search/shape.hpp"
#include "search/tray.hpp"

namespace spectralpack::test {

struct SceneLimits {
    Extent least{1, 1, 1};  ///< of the tray's grid
    Extent most{13, 9, 7};
    int shapes = 3;
    int orientations = 4;  ///< at most, per shape
    int gap_classes = 3;   ///< at most
    int reach = 2;         ///< voxels by which A+g goes beyond A, at most
    int objects = 8;       ///< in the tray at first, at most
    int detail = 1;        ///< of the tray, at most
};

/// Rows of several words along `axis`, thin across: for what engines do at word and block
/// boundaries.
inline SceneLimits long_scene(int axis) {
    SceneLimits limits;
    limits.least = {2, 2, 2};
    limits.most = {6, 5, 4};
    limits.least[axis] = 60;
    limits.most[axis] = 140;
    limits.reach = 3;
    return limits;
}

struct Scene {
    Tray tray;
    std::vector<Shape> shapes;
    std::vector<ObjectId> present;  ///< objects standing in the tray
};

/// A length that takes `voxels` voxels: exactly, or up to an eighth short of a whole one less.
inline double random_length(RandomStream& random, int voxels, double voxel_size) {
    const double short_by = one_in(random, 2) ? 0 : between(random, 1, 7) / 8.0;
    return (voxels - short_by) * voxel_size;
}

inline OrientedShape random_orientation(RandomStream& random, const TraySetup& setup, const Extent& tray, int own_class,
                                        int reach) {
    OrientedShape shape;
    Extent extent;
    const int kind = between(random, 0, 11);
    for (int axis = 0; axis < 3; ++axis) {
        // Two draws: small objects are more common, as in a packing.
        extent[axis] = std::min(between(random, 1, tray[axis]), between(random, 1, tray[axis]));
        if (kind == 0) extent[axis] = 1;
        if (kind == 1) extent[axis] = tray[axis];
        shape.reach[axis] = random_length(random, extent[axis], setup.voxel_size);
        if (kind == 1 && !one_in(random, 4)) shape.reach[axis] = setup.size[axis];
    }
    if (kind == 2) {
        const int axis = between(random, 0, 2);  // too large for the tray
        extent[axis] = tray[axis] + between(random, 1, 2);
        shape.reach[axis] = extent[axis] * setup.voxel_size;
    }
    Extent fine;
    for (int axis = 0; axis < 3; ++axis) {
        fine[axis] = voxels_along(shape.reach[axis], setup.voxel_size / setup.detail);
    }
    auto solid = std::make_shared<const BitGrid>(random_solid(random, fine));
    shape.solid = solid;
    if (setup.detail > 1) {
        shape.solid = std::make_shared<const BitGrid>(reached_voxels(*solid, {}, setup.detail).voxels);
        shape.fine = solid;
    }
    const double own = setup.gap_classes[static_cast<std::size_t>(own_class)];
    WidenedVoxels previous;
    double previous_gap = -1;
    for (const double other : setup.gap_classes) {
        const double gap = std::max(own, other);
        if (gap != previous_gap) {
            previous = gap > 0 ? random_widened(random, *solid, reach) : WidenedVoxels{solid, {}};
            previous_gap = gap;
        }
        shape.widened.push_back(previous);
    }
    return shape;
}

/// Widened grids made anew by `change`; those that classes shared stay shared.
template <class Change>
void change_widened(OrientedShape& shape, const Change& change) {
    const auto before = shape.widened;
    for (std::size_t c = 0; c < before.size(); ++c) {
        shape.widened[c] = c > 0 && before[c] == before[c - 1] ? shape.widened[c - 1] : change(before[c]);
    }
}

/// An orientation that follows from one of the shape's by a turn, where that keeps voxels of dx.
inline std::optional<OrientedShape> random_turned(RandomStream& random, const Shape& shape, int detail) {
    const std::size_t index = random.below(shape.orientations.size());
    const OrientedShape& from = shape.orientations[index];
    if (from.is_exchanged()) return std::nullopt;
    const AxisTurn turn = random_turn(random, !from.is_turned());
    const Extent fine = from.fine ? from.fine->extent() : from.solid->extent();
    OrientedShape result = from;
    result.turned_from = static_cast<int>(index);
    result.turn = turn;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (turn.reversed[axis] && fine[turn.order[axis]] % detail != 0) return std::nullopt;
        result.reach[static_cast<int>(axis)] = from.reach[turn.order[axis]];
    }
    result.solid = std::make_shared<const BitGrid>(turned(*from.solid, turn));
    if (from.fine) result.fine = std::make_shared<const BitGrid>(turned(*from.fine, turn));
    change_widened(result, [&](const WidenedVoxels& wide) { return turned(wide, fine, turn); });
    return result;
}

inline Shape random_shape(RandomStream& random, std::uint64_t id, const TraySetup& setup, const Extent& tray,
                          const SceneLimits& limits) {
    Shape shape;
    shape.id = id;
    shape.copies = std::vector{1, 2, 200}[id % 3];  // which says nothing of how often it is asked about
    shape.gap_class = between(random, 0, static_cast<int>(setup.gap_classes.size()) - 1);
    const int count = between(random, 1, limits.orientations);
    int orientation = -1;
    for (int i = 0; i < count; ++i) {
        orientation += between(random, 1, 3);  // indices merged away leave holes
        std::optional<OrientedShape> turned;
        if (i > 0 && one_in(random, 3)) turned = random_turned(random, shape, setup.detail);
        shape.orientations.push_back(turned ? *turned
                                            : random_orientation(random, setup, tray, shape.gap_class, limits.reach));
        shape.orientations.back().orientation = orientation;
    }
    return shape;
}

/// Keep-out boxes, or a rough mask, or the whole grid, or nothing.
inline BitGrid random_blocked(RandomStream& random, const Extent& tray) {
    BitGrid blocked;
    const int kind = between(random, 0, 7);
    if (kind <= 3) return blocked;
    blocked = BitGrid(tray);
    if (kind == 4) blocked = random_bits(random, tray, 12);
    if (kind == 5 && one_in(random, 3)) blocked.fill(true);
    if (kind >= 6) {
        const Extent box = random_extent(random, {1, 1, 1}, tray);
        BitGrid full({(box.x + 1) / 2, (box.y + 1) / 2, (box.z + 1) / 2});
        full.fill(true);
        unite(blocked, full,
              {between(random, 0, tray.x - 1), between(random, 0, tray.y - 1), between(random, 0, tray.z - 1)});
    }
    return blocked;
}

inline TraySetup random_setup(RandomStream& random, const SceneLimits& limits) {
    TraySetup setup;
    setup.voxel_size = std::vector<double>{2, 1, 0.5, 0.7}[random.below(4)];
    if (limits.detail > 1) setup.detail = between(random, 1, limits.detail);
    const Extent tray = random_extent(random, limits.least, limits.most);
    for (int axis = 0; axis < 3; ++axis) {
        setup.size[axis] = tray[axis] == 1  // a tray is at least one whole voxel long
                               ? setup.voxel_size
                               : random_length(random, tray[axis], setup.voxel_size);
    }
    const int classes = between(random, 1, limits.gap_classes);
    setup.gap_classes.clear();
    double gap = one_in(random, 3) ? 0.25 : 0;
    for (int c = 0; c < classes; ++c) {
        setup.gap_classes.push_back(gap);
        gap += 0.5;
    }
    setup.ceiling = one_in(random, 3) ? Ceiling::open : Ceiling::closed;
    setup.reference_layers = one_in(random, 3) ? between(random, 1, 3 * tray.z) : 0;
    setup.blocked = random_blocked(random, tray);
    setup.blocked_is_physical = one_in(random, 2);
    return setup;
}

/// `solid` unwidened against every gap class, at 1 mm voxels.
inline OrientedShape plain_shape(std::shared_ptr<const BitGrid> solid, int gap_classes = 1) {
    const Extent& e = solid->extent();
    const WidenedVoxels wide{solid, {}};
    return {0,
            {static_cast<double>(e.x), static_cast<double>(e.y), static_cast<double>(e.z)},
            {},
            std::move(solid),
            {static_cast<std::size_t>(gap_classes), wide}};
}

inline TraySetup box_tray(const Extent& n) {
    TraySetup setup;
    setup.voxel_size = 1;
    setup.size = {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
    return setup;
}

/// p = 0, 4, 1e8 or something between, measured at the bottom or at the top.
inline CostModel random_model(RandomStream& random) {
    CostModel model;
    model.height_penalty = std::vector<double>{0, 4, 1e8, 123.456}[random.below(4)];
    model.height_at = one_in(random, 4) ? HeightAt::top : HeightAt::bottom;
    return model;
}

/// Closes about a third of the layers to each orientation, in runs as caps do.
inline AllowedLayers random_layers(const Shape& shape, int layers, RandomStream& random) {
    AllowedLayers allowed;
    for (std::size_t i = 0; i < shape.orientations.size(); ++i) {
        std::vector<bool>& open = allowed.by_index.emplace_back();
        bool now = one_in(random, 2);
        for (int z = 0; z < layers; ++z) {
            if (one_in(random, now ? 4 : 2)) now = !now;
            open.push_back(now);
        }
    }
    return allowed;
}

/// Adds an object of a random shape and orientation anywhere, overhanging and sharing voxels at
/// times.
inline void add_random_object(Scene& scene, RandomStream& random) {
    const Shape& shape = scene.shapes[random.below(scene.shapes.size())];
    const OrientedShape& oriented = shape.orientations[random.below(shape.orientations.size())];
    const Extent& n = scene.tray.extent();
    const Extent& a = oriented.solid->extent();
    const bool overhang = one_in(random, 4);
    VoxelIndex position;
    for (int axis = 0; axis < 3; ++axis) {
        position[axis] =
            overhang ? between(random, -a[axis], n[axis]) : between(random, 0, std::max(0, n[axis] - a[axis]));
    }
    TrayObject object{oriented.solid.share(), position, shape.gap_class, false};
    const int detail = scene.tray.detail();
    if (detail > 1) {  // anywhere between grid positions
        VoxelIndex fine;
        for (int axis = 0; axis < 3; ++axis) {
            fine[axis] = detail * position[axis] + between(random, 0, detail - 1);
        }
        object = fine_object(oriented.fine.share(), fine, detail, shape.gap_class);
    }
    object.fixed = one_in(random, 5);
    scene.present.push_back(scene.tray.add(std::move(object)));
}

/// Adds an object or, once in three times, removes one.
inline void random_change(Scene& scene, RandomStream& random) {
    if (scene.present.empty() || !one_in(random, 3)) {
        add_random_object(scene, random);
        return;
    }
    const std::size_t gone = random.below(scene.present.size());
    scene.tray.remove(scene.present[gone]);
    scene.present.erase(scene.present.begin() + static_cast<std::ptrdiff_t>(gone));
}

/// Shape ids start at `first_id`: give scenes that one engine sees different ones.
inline Scene random_scene(RandomStream& random, const SceneLimits& limits = {}, std::uint64_t first_id = 1) {
    Scene scene{Tray(random_setup(random, limits)), {}, {}};
    for (int i = 0; i < limits.shapes; ++i) {
        scene.shapes.push_back(random_shape(random, first_id + static_cast<std::uint64_t>(i), scene.tray.setup(),
                                            scene.tray.extent(), limits));
    }
    const int objects = between(random, 0, limits.objects);
    for (int i = 0; i < objects; ++i) {
        add_random_object(scene, random);
    }
    return scene;
}

/// What a packing does: the object stands where the search says.
inline void place(Scene& scene, const Shape& shape, int index, const VoxelIndex& position) {
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(index)];
    const int s = scene.tray.detail();
    scene.present.push_back(scene.tray.add({oriented.solid.share(),
                                            position,
                                            shape.gap_class,
                                            false,
                                            oriented.fine.share(),
                                            {s * position.x, s * position.y, s * position.z}}));
}

}  // namespace spectralpack::test
