/// Turning or moving everything turns or moves the answer: what catches a swapped axis, on
/// non-cubic grids larger than brute force can do.

#include <gtest/gtest.h>

#include <array>

#include "engines.hpp"
#include "random_scene.hpp"

namespace spectralpack::test {
namespace {

/// Axis `to` of the result is axis order[to] of the original.
using AxisOrder = std::array<int, 3>;
constexpr std::array<AxisOrder, 5> kOrders{{{1, 0, 2}, {0, 2, 1}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}};

template <class Triple>
Triple permuted(const Triple& original, const AxisOrder& order) {
    Triple result;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = original[order[static_cast<std::size_t>(axis)]];
    }
    return result;
}

BitGrid permuted_bits(const BitGrid& original, const AxisOrder& order) {
    BitGrid result(permuted(original.extent(), order));
    for_each_voxel(original.extent(), [&](int x, int y, int z) {
        const VoxelIndex at = permuted(VoxelIndex{x, y, z}, order);
        result.set(at.x, at.y, at.z, original.get(x, y, z));
    });
    return result;
}

Shape permuted_shape(const Shape& original, const AxisOrder& order) {
    Shape shape = original;
    shape.id += 1000;
    for (OrientedShape& oriented : shape.orientations) {
        oriented.reach = permuted(oriented.reach, order);
        oriented.turned_from = -1;  // it would be another turn
        oriented.solid = std::make_shared<const BitGrid>(permuted_bits(*oriented.solid, order));
        change_widened(oriented, [&](const WidenedVoxels& wide) {
            return WidenedVoxels{LazyGrid(permuted_bits(*wide.voxels, order)), permuted(wide.offset, order)};
        });
    }
    return shape;
}

Tray permuted_tray(const Tray& original, const AxisOrder& order) {
    TraySetup setup = original.setup();
    setup.size = permuted(setup.size, order);
    setup.reference_layers = original.reference_layers();
    if (!setup.blocked.extent().empty()) setup.blocked = permuted_bits(setup.blocked, order);
    Tray tray(setup);
    for (ObjectId id = 0; id < original.object_count(); ++id) {
        const TrayObject& object = original.object(id);
        const ObjectId copy = tray.add({std::make_shared<const BitGrid>(permuted_bits(*object.solid, order)),
                                        permuted(object.position, order), object.gap_class, object.fixed});
        if (!original.find(id)) tray.remove(copy);
    }
    return tray;
}

/// With two opposite corners set and a size of whole millimetres (voxels of 1 mm): then the voxels
/// keep the box in, as the walls of a container do.
OrientedShape touching_its_box(const OrientedShape& original) {
    OrientedShape shape = original;
    const Extent& a = original.solid->extent();
    shape.reach = {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
    BitGrid solid = *original.solid;
    solid.set(0, 0, 0);
    solid.set(a.x - 1, a.y - 1, a.z - 1);
    change_widened(shape, [&](const WidenedVoxels& wide) {
        BitGrid voxels = *wide.voxels;
        unite(voxels, solid, VoxelIndex{} - wide.offset);
        return WidenedVoxels{LazyGrid(std::move(voxels)), wide.offset};
    });
    shape.solid = std::make_shared<const BitGrid>(std::move(solid));
    return shape;
}

SceneLimits larger_scene() {
    SceneLimits limits;
    limits.least = {17, 12, 8};
    limits.most = {75, 31, 22};
    limits.objects = 12;
    return limits;
}

class EquivarianceTest : public testing::TestWithParam<EngineFactory> {
  protected:
    std::unique_ptr<PlacementSearch> engine = GetParam().make(Workers(2));
};

TEST_P(EquivarianceTest, PermutedAxesPermuteFreePositions) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const Scene scene = random_scene(random, larger_scene(), 1 + 2000 * seed);
        const AxisOrder& order = kOrders[seed % kOrders.size()];
        const Shape& shape = scene.shapes[0];
        FreeQuery query{std::nullopt, 2};
        if (!scene.present.empty()) query.without = scene.present.back();
        const FreePositions free = engine->free_positions(scene.tray, shape, 0, query);
        const FreePositions turned =
            engine->free_positions(permuted_tray(scene.tray, order), permuted_shape(shape, order), 0, query);
        EXPECT_EQ(turned.origin, permuted(free.origin, order));
        EXPECT_EQ(turned.free, permuted_bits(free.free, order));
    }
}

TEST_P(EquivarianceTest, PermutedAxesKeepTheLeastCost) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random, larger_scene(), 1 + 2000 * seed);
        const AxisOrder& order = kOrders[seed % kOrders.size()];
        CostModel model;  // height and an open top tell z from x and y: left out where z turns
        if (order[2] == 2) {
            model.height_penalty = 1e8;
        } else {
            model.height_penalty = 0;
            TraySetup setup = scene.tray.setup();
            setup.ceiling = Ceiling::closed;
            scene.tray = Tray(setup);
            scene.present.clear();
            for (int i = 0; i < 9; ++i) {
                add_random_object(scene, random);
            }
        }
        const Tray turned_tray = permuted_tray(scene.tray, order);
        for (const Shape& shape : scene.shapes) {
            const auto best = engine->best_placement(scene.tray, shape, model, {}).best;
            const auto turned = engine->best_placement(turned_tray, permuted_shape(shape, order), model, {}).best;
            ASSERT_EQ(best.has_value(), turned.has_value());
            if (!best) continue;
            // Between positions of equal cost the order of axes decides, so these may differ.
            EXPECT_EQ(best->index, turned->index);
            EXPECT_EQ(best->cost, turned->cost);
            ++found;
        }
    }
    EXPECT_GT(found, 20);
}

TEST_P(EquivarianceTest, AShiftedTrayShiftsTheAnswer) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random, larger_scene(), 1 + 2000 * seed);
        // A whole number of voxels, so that walls of voxels stand where the container ends.
        TraySetup setup = scene.tray.setup();
        const Extent n = scene.tray.extent();
        setup.voxel_size = 1;
        setup.size = {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
        setup.ceiling = Ceiling::closed;
        setup.reference_layers = 50;
        for (Shape& shape : scene.shapes) {
            for (OrientedShape& oriented : shape.orientations) {
                oriented = touching_its_box(oriented);
            }
        }
        // The same walls as voxels of a larger tray, the room inside moved by `shift`.
        const VoxelIndex shift{between(random, 1, 70), between(random, 1, 9), 0};
        TraySetup around = setup;
        const Extent larger{n.x + shift.x + 3, n.y + shift.y + 1, n.z + 2};
        around.size = {static_cast<double>(larger.x), static_cast<double>(larger.y), static_cast<double>(larger.z)};
        BitGrid room(n);
        room.fill(true);
        around.blocked = BitGrid(larger);
        around.blocked.fill(true);
        subtract(around.blocked, room, shift);
        if (!setup.blocked.extent().empty()) unite(around.blocked, setup.blocked, shift);

        Tray small(setup), large(around);
        for (int i = 0; i < 9; ++i) {
            const Shape& shape = scene.shapes[random.below(scene.shapes.size())];
            const auto solid = shape.orientations[0].solid.share();
            VoxelIndex at;
            bool fits = true;  // what overhangs the small tray would stand in the large one's walls
            for (int axis = 0; axis < 3; ++axis) {
                fits = fits && solid->extent()[axis] <= n[axis];
                at[axis] = between(random, 0, std::max(0, n[axis] - solid->extent()[axis]));
            }
            if (!fits) continue;
            small.add({solid, at, shape.gap_class, false});
            large.add({solid, at + shift, shape.gap_class, false});
        }
        for (const Shape& shape : scene.shapes) {
            const CostModel model = random_model(random);
            auto expected = engine->best_placement(small, shape, model, {}).best;
            const auto shifted = engine->best_placement(large, shape, model, {}).best;
            if (expected) {
                expected->position = expected->position + shift;
                ++found;
            }
            EXPECT_EQ(shifted, expected);
        }
    }
    EXPECT_GT(found, 20);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EquivarianceTest);
INSTANTIATE_TEST_SUITE_P(Engines, EquivarianceTest, testing::ValuesIn(engines()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace spectralpack::test
