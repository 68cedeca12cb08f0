/// Packings that are changed by hand, and packed on around copies that stay.

#include <gtest/gtest.h>
#include <spectralpack/spectralpack.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using CopyName = std::pair<int, int>;

std::map<CopyName, Transform> stand(const Packing& packing) {
    std::map<CopyName, Transform> where;
    for (const TrayPacking& tray : packing.trays) {
        for (const Placement& placement : tray.placements) {
            where[{placement.part, placement.copy}] = placement.transform;
        }
    }
    return where;
}

Job job_of(int cubes, int brackets) {
    Job job;
    job.parts = {{.name = "cube", .mesh = test::cube_mesh(10), .count = cubes},
                 {.name = "bracket", .mesh = test::bracket(), .count = brackets}};
    job.options.tray = {60, 60, 40};
    job.options.voxel = 1;
    return job;
}

class ChangedPacking : public ::testing::Test {
  protected:
    void SetUp() override {
        PackResult result = pack(job_of(4, 6));
        scene_ = {std::move(result.packing), std::move(result.meshes)};
        ASSERT_EQ(scene_.packing.metrics.placed, 10);
    }
    CheckReport report(const Packing& packing) const { return check({packing, scene_.meshes}); }

    Scene scene_;
};

TEST_F(ChangedPacking, HasFiguresOfWhatStandsNow) {
    const Packing packing = changed(scene_, {{0, 1, 2, std::nullopt}, {0, 0, 1, std::nullopt}});
    EXPECT_EQ(packing.metrics.placed, 8);
    ASSERT_EQ(packing.unplaced.size(), 2u);
    EXPECT_EQ(packing.unplaced[0].reason, UnplacedReason::not_tried);
    EXPECT_EQ(packing.unplaced[0].detail, kTakenOutByHand);
    EXPECT_LT(packing.trays[0].density, scene_.packing.trays[0].density);
    EXPECT_FALSE(packing.trays[0].disassembly) << "whether it comes apart is not known any more";
    EXPECT_NE(packing.input_hash, scene_.packing.input_hash);
    EXPECT_TRUE(report(packing).ok()) << "stated figures are compared with measured ones";
    EXPECT_FALSE(stand(packing).contains({1, 2}));
}

TEST_F(ChangedPacking, IsTheOldOneWhenAllIsPutBack) {
    const auto before = stand(scene_.packing);
    Scene without{changed(scene_, {{0, 1, 2, std::nullopt}}), scene_.meshes};
    const Packing again = changed(without, {{0, 1, 2, before.at({1, 2})}});
    EXPECT_EQ(stand(again), before);
    EXPECT_TRUE(again.unplaced.empty());
    EXPECT_TRUE(report(again).ok());
    EXPECT_NEAR(again.trays[0].density, scene_.packing.trays[0].density, 1e-12);
}

TEST_F(ChangedPacking, MayOverlapWhichTheCheckSees) {
    Transform onto = stand(scene_.packing).at({0, 0});
    onto.translation.x += 3;
    const Packing packing = changed(scene_, {{0, 0, 1, onto}});
    EXPECT_EQ(stand(packing).at({0, 1}), onto);
    EXPECT_FALSE(report(packing).ok());
}

TEST_F(ChangedPacking, RefusesWhatIsNotThere) {
    const Transform there = stand(scene_.packing).at({0, 0});
    Transform larger = there;
    larger.linear = 2 * larger.linear;
    const std::vector<CopyChange> wrong{{1, 0, 0, there}, {0, 2, 0, there},  {0, 0, 4, there},
                                        {0, 0, -1, {}},   {0, 0, 0, larger}, {-1, 0, 0, {}}};
    for (const CopyChange& change : wrong) {
        EXPECT_THROW(changed(scene_, {change}), UsageError);
    }
    EXPECT_THROW(changed(scene_, {{0, 0, 0, std::nullopt}, {0, 0, 0, std::nullopt}}), UsageError);
}

TEST_F(ChangedPacking, TurnedCopiesKeepAnOrientationOfTheSet) {
    Transform turned = stand(scene_.packing).at({0, 0});
    const std::vector<Mat3> set = orientation_set("90");
    turned.linear = set[5];
    const Packing packing = changed(scene_, {{0, 0, 0, turned}});
    const std::vector<Placement>& placements = packing.trays[0].placements;
    const auto it =
        std::ranges::find_if(placements, [](const Placement& one) { return one.part == 0 && one.copy == 0; });
    ASSERT_NE(it, placements.end());
    EXPECT_EQ(set[static_cast<std::size_t>(it->orientation)], set[5]);
}

TEST_F(ChangedPacking, IsPackedOnAroundWhatStays) {
    Job job = job_of(5, 8);
    job.keep = Scene{changed(scene_, {{0, 1, 2, std::nullopt}, {0, 0, 1, std::nullopt}}), scene_.meshes};
    const auto stay = stand(job.keep->packing);
    const PackResult result = pack(job);
    ASSERT_FALSE(result.failure);
    EXPECT_EQ(result.packing.metrics.placed, 13);
    EXPECT_EQ(result.packing.metrics.copies, 13);
    const auto now = stand(result.packing);
    for (const auto& [copy, transform] : stay) {
        ASSERT_TRUE(now.contains(copy));
        EXPECT_EQ(now.at(copy), transform) << copy.first << " " << copy.second;
    }
    const CheckReport found = check({result.packing, result.meshes});
    EXPECT_TRUE(found.ok());
    EXPECT_TRUE(found.plans_complete()) << "what stays comes out like the others";
}

/// Parts may come in another order, under other names, and be fewer.
TEST_F(ChangedPacking, PartsAreKnownByTheirMeshes) {
    struct Heard : Listener {
        std::vector<std::string> warnings;
        void on_warning(const std::string& text) override { warnings.push_back(text); }
    } heard;
    Job job = job_of(4, 6);
    std::swap(job.parts[0], job.parts[1]);
    job.parts[1].name = "die";
    job.parts[1].count = 2;
    job.keep = scene_;
    const PackResult result = pack(job, {&heard, {}});
    EXPECT_EQ(result.packing.metrics.placed, 8);
    const auto before = stand(scene_.packing), now = stand(result.packing);
    for (int copy = 0; copy < 6; ++copy) {
        EXPECT_EQ(now.at({0, copy}), before.at({1, copy}));
    }
    EXPECT_TRUE(std::ranges::any_of(heard.warnings, [](const std::string& text) {
        return text == "2 copies of the build that is kept are no longer asked for, and left out";
    }));
}

TEST_F(ChangedPacking, KeepingHasItsLimits) {
    Job job = job_of(4, 6);
    job.keep = scene_;
    job.onto = scene_;
    EXPECT_THROW(pack(job), UsageError);
    job.onto.reset();
    job.options.fill = true;
    EXPECT_THROW(pack(job), UsageError);
}

}  // namespace
}  // namespace spectralpack
