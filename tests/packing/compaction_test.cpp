#include "packing/tray/compaction.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh_distance.hpp"
#include "packing/mesh_parts.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

constexpr double kGap = 0.5;

class Compactions : public testing::Test {
  protected:
    Compactions() {
        parts_.meshes.push_back(box_mesh({0, 0, 0}, {10, 10, 10}));
        parts_.meshes.push_back(box_mesh({0, 0, 0}, {4, 4, 4}));
    }

    PlacedCopy copy(int part, int number, const Vec3& at) const {
        PlacedCopy placed;
        placed.copy = {part, number};
        placed.offset = at;
        return placed;
    }
    bool run(std::vector<PlacedCopy>& placed, const StopToken& stop = {}, int sideways = 2) {
        return compact({{{30, 30, 100}, 0, 4, 3}, {}, 3, sideways}, surfaces_, nullptr, placed, Workers(1), stop);
    }

    MeshParts parts_;
    PartSurfaces surfaces_{[this](int part) {
                               ScaledPart scaled = parts_.scaled(part);
                               scaled.gap = kGap;
                               return scaled;
                           },
                           Workers(1)};
};

TEST_F(Compactions, CopiesSinkOnWhatIsBelow) {
    std::vector<PlacedCopy> placed{copy(0, 0, {1, 1, 3}), copy(0, 1, {2, 2, 17}), copy(1, 0, {20, 20, 5})};
    EXPECT_TRUE(run(placed, {}, 0));
    EXPECT_NEAR(placed[0].offset.z, 0, 1e-6);
    EXPECT_NEAR(placed[1].offset.z, 10 + kGap, 1e-5);
    EXPECT_NEAR(placed[2].offset.z, 0, 1e-6);
    EXPECT_EQ(placed[0].offset.x, 1);
    EXPECT_NEAR(top_of(placed, surfaces_), 20 + kGap, 1e-5);
}

TEST_F(Compactions, CopiesGoSidewaysWhereThatLetsThemSink) {
    // The small one lies on the edge of the large one, and there is room beside it.
    std::vector<PlacedCopy> placed{copy(0, 0, {0, 0, 0}), copy(1, 0, {8, 3, 10 + kGap})};
    EXPECT_TRUE(run(placed));
    EXPECT_NEAR(placed[1].offset.z, 0, 1e-6);
    EXPECT_GE(placed[1].offset.x, 10 + kGap - 1e-6);
    EXPECT_NEAR(top_of(placed, surfaces_), 10, 1e-6);
}

TEST_F(Compactions, NothingMovesWhereNothingCanSink) {
    std::vector<PlacedCopy> placed{copy(0, 0, {0, 0, 0}), copy(0, 1, {10 + kGap, 0, 0})};
    const std::vector<PlacedCopy> before = placed;
    EXPECT_FALSE(run(placed));
    EXPECT_EQ(placed, before);
}

TEST_F(Compactions, ThatAreStoppedLeaveAllWhereItStands) {
    std::vector<PlacedCopy> placed{copy(0, 0, {1, 1, 3})};
    StopSource stop;
    stop.request(StopReason::cancelled);
    EXPECT_FALSE(run(placed, stop.token()));
    EXPECT_EQ(placed[0].offset.z, 3);
}

}  // namespace
}  // namespace spectralpack::test
