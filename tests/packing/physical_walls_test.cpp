#include "packing/containers/physical_walls.hpp"

#include <gtest/gtest.h>

#include "packing/first_fit.hpp"
#include "packing/interlocking/reachable_search.hpp"
#include "search/cpu/cpu_search.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

TEST(PhysicalWalls, ABoxHasVoxelsBesideAndBelowItButNotAbove) {
    for (const double gap : {0.0, 0.7}) {
        TraySetup tray;
        tray.size = Vec3{5.4, 4, 3} - Vec3{2 * gap, 2 * gap, 2 * gap};
        tray.voxel_size = 0.5;
        const PhysicalWalls walls = physical_walls({{5.4, 4, 3}, {}, {}, true}, tray, gap, Workers(1));
        const BitGrid& solid = *walls.part.object.solid;
        const Extent inner = Tray(tray).extent(), outer = Tray(walls.grid).extent();
        EXPECT_EQ(solid.extent(), outer);
        EXPECT_TRUE(walls.part.object.fixed);
        const auto outside = [&](int index, int count) { return index == 0 || index == count - 1; };
        for (int z = 0; z < outer.z; ++z) {
            for (int y = 0; y < outer.y; ++y) {
                for (int x = 0; x < outer.x; ++x) {
                    const VoxelIndex in = VoxelIndex{x, y, z} - VoxelIndex{walls.margin, walls.margin, walls.margin};
                    if (inner.contains(in)) {
                        EXPECT_FALSE(solid.get(x, y, z)) << x << " " << y << " " << z;
                    } else if (outside(x, outer.x) || outside(y, outer.y) || z == 0) {
                        EXPECT_TRUE(solid.get(x, y, z)) << x << " " << y << " " << z;
                    }
                }
            }
        }
    }
}

/// A physical cube of a container, in voxels of 1 mm.
struct Walled {
    explicit Walled(double side) {
        setup.size = {side, side, side};
        setup.voxel_size = 1;
        walls = physical_walls({setup.size, {}, {}, true}, setup, 0, Workers(1));
    }

    TraySetup setup;
    PhysicalWalls walls;
    std::unique_ptr<PlacementSearch> engine = make_cpu_search({}, Workers(1));
};

/// As large as a layer of `side` voxels.
std::shared_ptr<BitGrid> whole_plate(int side) {
    auto plate = std::make_shared<BitGrid>(Extent{side, side, 1});
    plate->fill(true);
    return plate;
}

TEST(PhysicalWalls, WhatIsUnderAPlateIsReachedSidewaysOnlyWithoutThem) {
    const Walled scene(6);
    const auto shape = test::box_shape(1, 2);
    const auto lowest = [&](int hole) {
        Tray tray(scene.setup);
        const auto plate = whole_plate(6);
        for (int x = 0; x < hole; ++x) {
            plate->set(x, 0, 0, false);
            plate->set(x, 1, 0, false);
        }
        tray.add({plate, {0, 0, 3}});
        std::vector<int> heights;
        for (const PhysicalWalls* around : {static_cast<const PhysicalWalls*>(nullptr), &scene.walls}) {
            ReachableSearch reachable(*scene.engine, around);
            const auto best = reachable.best_placement(tray, *shape, {1e8, HeightAt::top}, {}).best;
            heights.push_back(best ? best->position.z : -1);
        }
        return heights;
    };
    EXPECT_EQ(lowest(0), (std::vector<int>{0, 4})) << "a whole plate";
    EXPECT_EQ(lowest(1), (std::vector<int>{0, 4})) << "too small a hole";
    EXPECT_EQ(lowest(2), (std::vector<int>{0, 0})) << "down through the hole";
}

TEST(PhysicalWalls, TheWalledTrayFollowsWhatComesAndGoes) {
    const Walled scene(4);
    ReachableSearch reachable(*scene.engine, &scene.walls);
    const auto plate = whole_plate(4);
    const auto shape = test::box_shape(1, 1);
    Tray tray(scene.setup);
    const auto height = [&] {
        return reachable.best_placement(tray, *shape, {1e8, HeightAt::top}, {}).best->position.z;
    };
    EXPECT_EQ(height(), 0);
    const ObjectId first = tray.add({plate, {0, 0, 1}});
    EXPECT_EQ(height(), 2);
    const ObjectId second = tray.add({plate, {0, 0, 2}});
    EXPECT_EQ(height(), 3);
    tray.remove(first);
    EXPECT_EQ(height(), 3);
    tray.remove(second);
    EXPECT_EQ(height(), 0);
}

}  // namespace
}  // namespace spectralpack
