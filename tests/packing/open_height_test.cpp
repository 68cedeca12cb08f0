#include "packing/tray/open_height.hpp"

#include <gtest/gtest.h>

#include "packing/tray/greedy.hpp"
#include "search/cpu/cpu_search.hpp"
#include "spectralpack/error.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

std::vector<Copy> copies(int parts, int count) {
    std::vector<Copy> copies;
    for (int part = 0; part < parts; ++part) {
        for (int copy = 0; copy < count; ++copy) {
            copies.push_back({part, copy});
        }
    }
    return copies;
}

const std::vector<Mat3> kTurns = test::three_turns();

/// Tori and boxes of growing size.
Mesh mesh_of(int part) {
    if (part % 2 == 0) return test::torus_mesh(3 + part, 2, 24, 12);
    return test::box_mesh({0, 0, 0}, {3.0 + part, 9, 5});
}

class OpenHeight : public testing::Test {
  protected:
    GreedyResult pack(const CostModel& model, double height, double gap, const PlaceLimits& limits = {}) {
        TraySetup setup;
        setup.size = {20, 16, height};
        setup.voxel_size = 1;
        setup.gap_classes = {gap};
        setup.ceiling = Ceiling::open;
        setup.reference_layers = 20;
        tray_.emplace(setup);
        const std::vector<Copy> wanted = copies(5, 4);
        const Workers workers(2);
        ShapeStore shapes(
            [&](int part, const Workers&) {
                return std::make_shared<const Shape>(
                    make_shape(static_cast<std::uint64_t>(part) + 1, mesh_of(part), kTurns, 1, 1, gap, {gap}, workers));
            },
            workers);
        shapes.start_tray(wanted);
        const Settle settle = [](const Copy&, const Shape& shape, const BestPlacement& best) {
            return settle_on_grid(shape, best, 1, 1, 0);
        };
        const auto engine = make_cpu_search({}, workers);
        GreedyResult result;
        pack_greedily(
            *tray_, {{*engine, shapes, workers}, 0, model, limits, settle}, wanted, [](std::size_t) {}, result);
        return result;
    }

    std::optional<Tray> tray_;
};

TEST_F(OpenHeight, WhatTheGridBeginsWithDoesNotShow) {
    for (const CostModel& model : {CostModel{1e8, HeightAt::top}, CostModel{1e8, HeightAt::bottom}}) {
        for (const double gap : {0.0, 1.3}) {
            const GreedyResult tall = pack(model, 400, gap);
            ASSERT_EQ(tray_->extent().z, 400);
            EXPECT_EQ(tall.placed.size(), 20u);
            EXPECT_TRUE(tall.left_over.empty());
            for (const double height : {1.0, 17.0, 40.0}) {
                const GreedyResult low = pack(model, height, gap);
                ASSERT_EQ(low.placed.size(), tall.placed.size());
                for (std::size_t i = 0; i < tall.placed.size(); ++i) {
                    EXPECT_EQ(low.placed[i].position, tall.placed[i].position) << i;
                    EXPECT_EQ(low.placed[i].orientation, tall.placed[i].orientation) << i;
                    EXPECT_EQ(low.placed[i].object, tall.placed[i].object) << i;
                }
            }
        }
    }
}

TEST_F(OpenHeight, GrowsNoFurtherThanAllowed) {
    PlaceLimits limits;
    limits.most_layers = 20;
    EXPECT_THROW(pack({1e8, HeightAt::top}, 10, 0, limits), ResourceError);
    EXPECT_LE(tray_->extent().z, 20);
}

TEST(GrownTray, HoldsTheSameUnderTheSameIds) {
    TraySetup setup;
    setup.size = {10, 10, 5};
    setup.voxel_size = 1;
    setup.ceiling = Ceiling::open;
    Tray tray(setup);
    BitGrid cube({3, 3, 3});
    cube.fill(true);
    const auto solid = std::make_shared<const BitGrid>(cube);
    for (int i = 0; i < 3; ++i) {
        tray.add({solid, {3 * i, 2, i}, 0, false});
    }
    tray.remove(1);
    const Tray taller = grown(tray, 12);
    EXPECT_EQ(taller.extent(), (Extent{10, 10, 12}));
    EXPECT_EQ(taller.reference_layers(), 5);
    EXPECT_EQ(taller.object_count(), 3);
    EXPECT_FALSE(taller.find(1));
    ASSERT_TRUE(taller.find(2));
    EXPECT_EQ(taller.find(2)->position, (VoxelIndex{6, 2, 2}));
    EXPECT_EQ(taller.omega_move().count(), tray.omega_move().count());
    EXPECT_NE(taller.instance(), tray.instance());
}

}  // namespace
}  // namespace spectralpack
