#include "packing/job/trays.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "disassembly/scenes.hpp"
#include "packing/first_fit.hpp"
#include "packing/mesh_parts.hpp"

namespace spectralpack {
namespace {

/// Cubes of side part + 1 in trays of 4 x 4 x 2.
class ManyTrays : public testing::Test {
  protected:
    ManyTrays()
        : shapes_(
              [this](int part, const Workers&) {
                  return test::box_shape(static_cast<std::uint64_t>(part), part + 1, &made_);
              },
              Workers(1), 1 << 20) {
        setup_.tray.size = {4, 4, 2};
        setup_.tray.voxel_size = 1;
        setup_.container.size = {4, 4, 2};
    }

    void pack(const std::vector<Copy>& copies, const TraysLimit& limit) {
        TrayFiller filler(setup_, {search_, shapes_, Workers(1), stop_.token()}, {});
        fill_trays(
            copies, limit, filler, nullptr,
            [this](const GreedyResult&, std::size_t done) {
                if (done == stop_after_) stop_.request(StopReason::cancelled);
            },
            result_);
    }

    static std::vector<Copy> copies(int part, int count) {
        std::vector<Copy> all;
        for (int copy = 0; copy < count; ++copy) {
            all.push_back({part, copy});
        }
        return all;
    }

    FillOptions setup_;
    test::FirstFit search_;
    std::atomic<int> made_{0};
    ShapeStore shapes_;
    StopSource stop_;
    std::size_t stop_after_ = 0;  // copies; 0: never
    TraysResult result_;
};

TEST_F(ManyTrays, AsManyAsItTakes) {
    pack(copies(1, 10), {0, 0});  // four to a tray
    ASSERT_EQ(result_.trays.size(), 3u);
    EXPECT_EQ(result_.trays[0].placed.size(), 4u);
    EXPECT_EQ(result_.trays[1].placed.size(), 4u);
    EXPECT_EQ(result_.trays[2].placed.size(), 2u);
    EXPECT_EQ(result_.trays[1].placed[0].copy, (Copy{1, 4}));
    EXPECT_TRUE(result_.left_over.empty());
    EXPECT_FALSE(result_.stuck);
    EXPECT_EQ(result_.placed(), 10);
    EXPECT_EQ(made_, 1) << "the shape was not kept from tray to tray";
}

TEST_F(ManyTrays, NoMoreThanAllowed) {
    pack(copies(1, 10), {2, 0});
    EXPECT_EQ(result_.trays.size(), 2u);
    EXPECT_EQ(result_.left_over, (std::vector<Copy>{{1, 8}, {1, 9}}));
}

TEST_F(ManyTrays, EachIsFullOnceSoManyPartsFindNoPlace) {
    std::vector<Copy> wanted = copies(1, 6);
    wanted.push_back({0, 0});
    pack(wanted, {0, 1});
    ASSERT_EQ(result_.trays.size(), 2u);
    EXPECT_EQ(result_.trays[0].placed.size(), 4u);  // a fifth finds no place, so part 0 is not tried
    EXPECT_EQ(result_.trays[0].searches, 5);
    ASSERT_EQ(result_.trays[1].placed.size(), 3u);
    EXPECT_EQ(result_.trays[1].placed[2].copy, (Copy{0, 0}));
    // One tray alone tries all.
    result_ = {};
    pack(wanted, {1, 1});
    EXPECT_EQ(result_.trays[0].searches, 6);
}

TEST_F(ManyTrays, ATrayThatStaysEmptyEndsIt) {
    std::vector<Copy> wanted = copies(2, 2);  // too high for any tray
    wanted.push_back({1, 0});
    pack(wanted, {0, 0});
    ASSERT_EQ(result_.trays.size(), 1u);
    EXPECT_EQ(result_.trays[0].placed.size(), 1u);
    EXPECT_TRUE(result_.stuck);
    EXPECT_EQ(result_.left_over, copies(2, 2));
    // One tray alone is no error.
    result_ = {};
    pack(copies(2, 2), {1, 0});
    EXPECT_FALSE(result_.stuck);
    EXPECT_EQ(result_.left_over, copies(2, 2));
}

TEST_F(ManyTrays, FixedCopiesStandInTheirTrays) {
    const auto cube = std::make_shared<const Mesh>(test::cube_mesh(2));
    setup_.fixed = {{0, cube, {Mat3{}, {0, 0, 0}}, 0}, {0, cube, {Mat3{}, {2, 2, 0}}, 0}, {1, cube, {}, 0}};
    pack(copies(1, 3), {0, 0});
    ASSERT_EQ(result_.trays.size(), 2u);
    ASSERT_EQ(result_.trays[0].placed.size(), 2u);
    EXPECT_EQ(result_.trays[0].placed[0].position, (VoxelIndex{2, 0, 0}));
    EXPECT_EQ(result_.trays[0].placed[1].position, (VoxelIndex{0, 2, 0}));
    EXPECT_EQ(result_.trays[1].placed[0].position, (VoxelIndex{2, 0, 0}));
    // A tray that fixed copies fill is not one that stays empty, and they stand there though nothing is left for it.
    result_ = {};
    setup_.fixed = {{0, std::make_shared<const Mesh>(test::box_mesh({0, 0, 0}, {4, 4, 2})), {}, 0}, {2, cube, {}, 0}};
    pack(copies(1, 1), {0, 0});
    EXPECT_EQ(result_.trays.size(), 3u);
    EXPECT_TRUE(result_.trays[0].placed.empty());
    EXPECT_EQ(result_.trays[1].placed.size(), 1u);
}

TEST_F(ManyTrays, AStopLeavesTheRest) {
    stop_.request(StopReason::cancelled);
    pack(copies(1, 10), {0, 0});
    EXPECT_EQ(result_.trays.size(), 1u);
    EXPECT_FALSE(result_.stuck);
    EXPECT_TRUE(result_.left_over.empty());
}

TEST_F(ManyTrays, AStopBetweenTraysBeginsNoOther) {
    stop_after_ = 10;  // the first tray's last
    pack(copies(1, 10), {0, 0});
    EXPECT_EQ(result_.trays.size(), 1u);
    EXPECT_FALSE(result_.stuck);
    EXPECT_TRUE(result_.left_over.empty()) << "they would have had a tray of their own";
}

TEST_F(ManyTrays, AStopBeforeTheNextTraysFirstCopyLeavesNoEmptyTray) {
    TrayFiller filler(setup_, {search_, shapes_, Workers(1), stop_.token()}, {});
    std::size_t left_over = 99;
    fill_trays(
        copies(1, 10), {0, 0}, filler, nullptr, [](const GreedyResult&, std::size_t) {}, result_,
        [&] {
            left_over = result_.left_over.size();
            stop_.request(StopReason::cancelled);
        });
    EXPECT_EQ(left_over, 0u) << "they are tried again";
    EXPECT_EQ(result_.trays.size(), 1u);
    EXPECT_FALSE(result_.stuck);
    EXPECT_TRUE(result_.left_over.empty());
}

TEST_F(ManyTrays, AStopAtTheEndOfTheOnlyTrayChangesNothing) {
    stop_after_ = 10;
    pack(copies(1, 10), {1, 0});
    EXPECT_EQ(result_.trays.size(), 1u);
    EXPECT_EQ(result_.left_over.size(), 6u);
}

TEST_F(ManyTrays, EnoughEndsPlacingAlone) {
    StopSource enough;
    enough.request(StopReason::time_limit);
    setup_.enough = enough.token();
    pack(copies(1, 10), {0, 0});
    EXPECT_EQ(result_.trays.size(), 1u);
    EXPECT_TRUE(result_.trays[0].cut_short);
    EXPECT_EQ(result_.trays[0].untried.size(), 10u);
}

TEST(InterlockedTray, WhatStandsWhenItIsEnoughStillComesApart) {
    const test::MeshParts parts{{test::cube_mesh(8)}};
    ShapeStore shapes([&](int part, const Workers&) { return parts.shape(part); }, Workers(1));
    StopSource enough;
    FillOptions setup;
    setup.tray.size = setup.container.size = {32, 26, 26};
    setup.tray.voxel_size = 1;
    setup.interlock = Interlock::post;
    setup.left = setup.to_put_back = [](int, int) {};
    setup.enough = enough.token();
    const std::unique_ptr<PlacementSearch> search = make_cpu_search({}, Workers(1));
    TrayFiller filler(setup, {*search, shapes, Workers(1)}, [&](int part) { return parts.scaled(part); });
    TraysResult result;
    fill_trays(
        {{0, 0}, {0, 1}, {0, 2}, {0, 3}}, {1, 0}, filler, nullptr,
        [&](const FilledTray&, std::size_t done) {
            if (done == 2) enough.request(StopReason::time_limit);
        },
        result);
    ASSERT_EQ(result.trays.size(), 1u);
    EXPECT_TRUE(result.trays[0].cut_short);
    EXPECT_EQ(result.trays[0].placed.size(), 2u);
    ASSERT_TRUE(result.trays[0].plan);
    EXPECT_TRUE(result.trays[0].plan->complete);
    EXPECT_EQ(result.trays[0].plan->steps.size(), 2u);
}

TEST(InterlockedTray, WhatAStopKeepsFromBeingPutBackFoundNoLackOfRoom) {
    // Two cubes in a chest whose lid has a hole too small for them, and no room beside it.
    const test::MeshParts parts{
        {test::merged(test::chest_mesh(26, 2, true), test::placed(test::frame_mesh(26, 11, 2), {0, 0, 24})),
         test::cube_mesh(8)}};
    ShapeStore shapes([&](int part, const Workers&) { return parts.shape(part); }, Workers(1));
    StopSource stop;
    FillOptions setup;
    setup.tray.size = {32, 26, 26};
    setup.tray.voxel_size = 1;
    setup.container.size = {32, 26, 26};
    setup.interlock = Interlock::post;
    setup.links = Links::allow;
    setup.take_out = TakeOut::lightest;
    setup.left = [](int, int) {};
    int tried = 0;
    setup.to_put_back = [&](int, int) {
        // Both where they stood, then the first elsewhere.
        if (++tried == 3) stop.request(StopReason::cancelled);
    };
    const std::unique_ptr<PlacementSearch> search = make_cpu_search({}, Workers(1));
    TrayFiller filler(setup, {*search, shapes, Workers(1), stop.token()}, [&](int part) { return parts.scaled(part); });
    TraysResult result;
    fill_trays(
        {{0, 0}, {1, 0}, {1, 1}}, {1, 0}, filler, nullptr, [](const FilledTray&, std::size_t) {}, result);
    ASSERT_EQ(result.trays.size(), 1u);
    EXPECT_EQ(result.trays[0].report.counts.removed, 2);
    EXPECT_EQ(result.trays[0].interlocked, (std::vector<Copy>{{1, 0}}));
    EXPECT_TRUE(result.left_over.empty()) << "the second cube was not tried";
}

TEST_F(ManyTrays, WhatWasPlacedSurvivesAnException) {
    search_.fail_at = 7;
    EXPECT_THROW(pack(copies(1, 10), {0, 0}), std::runtime_error);
    EXPECT_EQ(result_.placed(), 5);  // four, one search in vain, one
}

}  // namespace
}  // namespace spectralpack
