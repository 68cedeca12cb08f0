#include "packing/job/tray_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "packing/first_fit.hpp"
#include "packing/job/trays_packer.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

/// First fit from the floor up with height at the top, from the ceiling down with height at the bottom.
class EitherFit : public test::FirstFit {
  public:
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        if (model.height_at == refused_at && shape.id == refused) {
            ++asked;
            return {};
        }
        SearchResult found = FirstFit::best_placement(tray, shape, model, stop);
        if (found.best && model.height_at == HeightAt::bottom) return first_free(tray, shape, true);
        return found;
    }

    HeightAt refused_at = HeightAt::top;
    std::uint64_t refused = 100;  // shape that then finds no place
};

/// Cubes of side part + 1 in trays of 8 x 8 x 8.
class TrayChoice : public testing::Test {
  protected:
    TrayChoice() : shapes_([](int part, const Workers&) { return shape_of(part); }, Workers(1), 1 << 20) {
        setup_.tray.size = setup_.container.size = {8, 8, 8};
        setup_.tray.voxel_size = 1;
        choice_.crowd = [this](const TrayCopies&) { return crowd_; };
        choice_.expects_to_fit = [this](const Crowd&) { return expected_; };
        choice_.measures = {[](int part) { return std::pow(part + 1.0, 3); },
                            [](const PlacedCopy& placed) { return placed.position.z + placed.copy.part + 1.0; }};
    }

    static std::shared_ptr<const Shape> shape_of(int part) {
        return test::box_shape(static_cast<std::uint64_t>(part), part + 1);
    }

    void pack(const std::vector<Copy>& copies, const TraysLimit& limit = {}) {
        TrayFiller filler(setup_, {search_, shapes_, Workers(1), stop_.token()}, {});
        fill_trays(
            copies, limit, filler, &choice_,
            [this](const FilledTray&, std::size_t) {
                if (search_.asked == stop_after_) stop_.request(StopReason::cancelled);
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

    static double top_of(const FilledTray& tray) {
        double top = 0;
        for (const PlacedCopy& placed : tray.placed) {
            top = std::max(top, placed.position.z + placed.copy.part + 1.0);
        }
        return top;
    }

    FillOptions setup_;
    EitherFit search_;
    ShapeStore shapes_;
    StopSource stop_;
    int stop_after_ = -1;
    bool expected_ = true;
    Crowd crowd_;
    HeightChoice choice_;
    TraysResult result_;
};

TEST_F(TrayChoice, ARightExpectationIsPackedOnce) {
    pack(copies(3, 4));
    EXPECT_EQ(search_.asked, 4);
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::top);
    EXPECT_EQ(top_of(result_.trays[0]), 4);
}

TEST_F(TrayChoice, ATrayThatOverflowsAsExpectedIsPackedOnce) {
    expected_ = false;
    search_.refused_at = HeightAt::bottom;
    search_.refused = 0;
    pack({{3, 0}, {0, 0}});
    EXPECT_EQ(search_.asked, 2);
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::bottom);
    EXPECT_EQ(result_.left_over.size(), 1u);
}

TEST_F(TrayChoice, WhatFitsAgainstExpectationIsPackedAnewAndLower) {
    expected_ = false;
    pack(copies(3, 3));
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::top);
    EXPECT_EQ(top_of(result_.trays[0]), 4);
    EXPECT_EQ(result_.searches(), 6) << "those of both packings";
}

TEST_F(TrayChoice, WhereTheTopPlacesFewerTheFirstStays) {
    expected_ = false;
    search_.refused = 0;
    pack({{3, 0}, {0, 0}});
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::bottom);
    EXPECT_EQ(result_.placed(), 2);
    EXPECT_TRUE(result_.left_over.empty());
}

TEST_F(TrayChoice, WhereTheTopIsNoLowerTheFirstStays) {
    expected_ = false;
    pack(copies(7, 1));
    EXPECT_EQ(search_.asked, 2);
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::bottom);
}

TEST_F(TrayChoice, WhatDoesNotFitAgainstExpectationIsPackedAsFullTraysAre) {
    search_.refused = 0;
    pack({{3, 0}, {0, 0}});
    EXPECT_EQ(search_.asked, 4);
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::bottom);
    EXPECT_TRUE(result_.left_over.empty());
}

TEST_F(TrayChoice, TheLastOfSeveralIsLow) {
    expected_ = false;
    pack(copies(3, 19), {0, 0});  // eight to a tray
    ASSERT_EQ(result_.trays.size(), 3u);
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::bottom);
    EXPECT_EQ(result_.trays[1].height_at, HeightAt::bottom);
    EXPECT_EQ(result_.trays[2].height_at, HeightAt::top);
    EXPECT_EQ(top_of(result_.trays[2]), 4);
    EXPECT_EQ(result_.placed(), 19);
}

TEST_F(TrayChoice, AStopKeepsWhatWasWhole) {
    expected_ = false;
    stop_after_ = 5;  // in the second packing
    pack(copies(3, 3));
    EXPECT_EQ(result_.placed(), 3);
    EXPECT_EQ(result_.trays[0].height_at, HeightAt::bottom);
    EXPECT_TRUE(result_.trays[0].untried.empty());
}

TEST_F(TrayChoice, AnExceptionKeepsWhatWasWhole) {
    expected_ = false;
    search_.fail_at = 5;
    EXPECT_THROW(pack(copies(3, 3)), std::runtime_error);
    EXPECT_EQ(result_.placed(), 3);
}

TEST_F(TrayChoice, ARoomyTrayIsGatheredOnItsBase) {
    setup_.tray.size = setup_.container.size = {32, 32, 8};
    crowd_ = {32 * 32 * 8, 4 * 64, 4 * 64, setup_.tray.size};
    pack(copies(3, 4));
    ASSERT_EQ(result_.placed(), 4);
    for (const PlacedCopy& placed : result_.trays[0].placed) {
        EXPECT_LE(placed.position.x, 4) << "a row along x takes twice as much of the base";
        EXPECT_LE(placed.position.y, 4);
        EXPECT_EQ(placed.position.z, 0);
    }
}

TEST_F(TrayChoice, ACrowdedTrayIsNotPackedAnew) {
    crowd_ = {512, 3 * 64, 3 * 64, setup_.tray.size};  // three quarters of the lower half
    pack(copies(3, 3));
    EXPECT_EQ(search_.asked, 3);
}

TEST(ExpectsToFit, ByBoxesAndMaterial) {
    EXPECT_TRUE(expects_to_fit({100, 110, 30, {}}));
    EXPECT_FALSE(expects_to_fit({100, 130, 30, {}})) << "boxes";
    EXPECT_FALSE(expects_to_fit({100, 110, 50, {}})) << "material";
    EXPECT_TRUE(expects_to_fit({100, 60, 60, {}})) << "solid boxes";
}

TEST(ExpectsToFit, CountsGapsWhatStandsAndWhatIsKeptFree) {
    const auto cube = std::make_shared<const Mesh>(test::cube_mesh(4));
    PackingJob job;
    job.parts = {{cube, 2, 1, nullptr, 512, 512, 3}};
    FillOptions& fill = job.fill;
    fill.container.size = fill.tray.size = {20, 20, 20};
    fill.tray.voxel_size = 2;
    const TrayCopies wanted{0, {{0, 0}, {0, 1}}, false, 0, {}, {}};
    Crowd crowd = choose_heights(job, fill).crowd(wanted);
    EXPECT_EQ(crowd.room, 8000);
    EXPECT_EQ(crowd.boxes, 2 * 9 * 9 * 9);
    EXPECT_EQ(crowd.material, 2 * 512);
    EXPECT_EQ(crowd.size, fill.tray.size);

    fill.tray.blocked = BitGrid({10, 10, 10});
    for (int x = 0; x < 10; ++x) {
        fill.tray.blocked.set(x, 0, 0);
    }
    fill.fixed = {{0, cube, {}, 0}, {1, cube, {}, 0}};
    crowd = choose_heights(job, fill).crowd(wanted);
    EXPECT_EQ(crowd.room, 8000 - 80);
    EXPECT_EQ(crowd.boxes, 2 * 729 + 64);
    EXPECT_EQ(crowd.material, 2 * 512 + 64);
    EXPECT_FALSE(crowd.size) << "nothing of the base may be left out";
}

}  // namespace
}  // namespace spectralpack
