#include "packing/interlocking/untangle.hpp"

#include <gtest/gtest.h>

#include "disassembly/scenes.hpp"
#include "packing/interlocking/removable_packing.hpp"
#include "packing/mesh_parts.hpp"
#include "packing/tray/open_height.hpp"

namespace spectralpack {
namespace {

/// Parts by index, each standing where it is put.
class Interlocking : public testing::Test {
  protected:
    Interlocking() : tray_(TraySetup{{80, 60, 60}, 1, 1, {0}, Ceiling::closed, 0, {}, false}) {
        options_.voxel_size = 1;
        options_.surfaces = &surfaces_;
        options_.left = options_.to_put_back = [](int, int) {};
        search_ = make_cpu_search({}, Workers(1));
    }

    void put(Mesh mesh, int orientation, const VoxelIndex& position) {
        parts_.meshes.push_back(std::move(mesh));
        const int part = static_cast<int>(parts_.meshes.size()) - 1;
        const auto made = parts_.shape(part);
        BestPlacement best;
        best.position = position;
        for (std::size_t i = 0; i < made->orientations.size(); ++i) {
            if (made->orientations[i].orientation == orientation) best.index = static_cast<int>(i);
        }
        Settled settled = settle_on_grid(*made, best, 1, 1, 0);
        placed_.push_back({{part, 0}, orientation, position, settled.offset, tray_.add(std::move(settled.object)), {}});
    }

    TrayContext context(const StopToken& stop = {}) {
        return {{*search_, shapes_, Workers(1), stop, observer_}, 0, model_, {}, {}};
    }
    Untangled untangle_all(const StopToken& stop = {}) { return untangle(tray_, placed_, context(stop), options_); }

    /// Every copy has a step of its own.
    void expect_complete(const Untangled& result) const {
        EXPECT_TRUE(result.plan.complete);
        std::vector<int> out;
        for (const RemovalStep& step : result.plan.steps) {
            if (step.placements.size() == 1) out.push_back(step.placements.front());
        }
        std::sort(out.begin(), out.end());
        std::vector<int> all;
        for (int i = 0; i < static_cast<int>(placed_.size()); ++i) {
            all.push_back(i);
        }
        EXPECT_EQ(out, all);
    }

    Tray tray_;
    test::MeshParts parts_{{}, {Mat3{}, Mat3{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}}};
    ShapeStore shapes_{[this](int part, const Workers&) { return parts_.shape(part); }, Workers(1)};
    std::vector<PlacedCopy> placed_;
    PartSurfaces surfaces_{[this](int part) { return parts_.scaled(part); }, Workers(1)};
    UntangleOptions options_;
    CostModel model_;
    TrayObserver* observer_ = nullptr;
    std::unique_ptr<PlacementSearch> search_;
};

// A ring of 22 x 22 x 4 around z; turned by orientation 1 around x.
Mesh ring() { return test::torus_mesh(9, 2, 24, 12); }

TEST_F(Interlocking, PutsBackWhatItTookOutAndTakesItOutFirst) {
    put(ring(), 0, {10, 10, 20});
    put(ring(), 1, {19, 19, 11});
    put(test::cube_mesh(6), 0, {60, 40, 0});
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.removed, 1);
    EXPECT_EQ(result.report.counts.reinserted, 1);
    EXPECT_TRUE(result.interlocked.empty());
    ASSERT_EQ(placed_.size(), 3u);
    expect_complete(result);
    EXPECT_EQ(result.plan.steps.front().placements, std::vector<int>{2}) << "put back last";
    EXPECT_EQ(placed_[2].copy.part, 0) << "of two of one size the first is taken";
    EXPECT_TRUE(tray_.find(placed_[2].object));
}

TEST_F(Interlocking, LeavesOutWhatFindsNoPlaceThatItCanLeave) {
    tray_ = Tray(TraySetup{{32, 26, 26}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
    put(test::chest_mesh(26, 2, false), 0, {0, 0, 0});
    put(test::cube_mesh(8), 0, {10, 10, 10});
    options_.take_out = TakeOut::smallest;
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.removed, 1) << "the cube is less than a tenth, but the chest may stay without it";
    EXPECT_EQ(result.report.counts.reinserted, 0);
    ASSERT_EQ(result.interlocked.size(), 1u);
    EXPECT_EQ(result.interlocked.front().part, 1);
    ASSERT_EQ(placed_.size(), 1u);
    expect_complete(result);
}

TEST_F(Interlocking, TakesOutWhatHasTheLeastMaterial) {
    tray_ = Tray(TraySetup{{32, 26, 26}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
    put(test::chest_mesh(26, 2, false), 0, {0, 0, 0});
    put(test::cube_mesh(8), 0, {10, 10, 10});
    options_.take_out = TakeOut::lightest;
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.removed, 1);
    ASSERT_EQ(placed_.size(), 1u);
    EXPECT_EQ(placed_.front().copy.part, 0);
    expect_complete(result);
}

TEST_F(Interlocking, TakesOutWhatHasTheLeastMaterialForItsBoxAndPutsInWhatHadWaited) {
    tray_ = Tray(TraySetup{{36, 34, 17}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
    put(test::frame_mesh(26, 2, 2), 0, {0, 0, 7});
    put(test::lying(test::frame_mesh(16, 5, 6), 0), 0, {10, 17, 0});
    parts_.meshes.push_back(test::cube_mesh(12));
    options_.take_out = TakeOut::thinnest;
    options_.order = {{0, 0}, {2, 0}, {2, 1}, {1, 0}};
    options_.waiting = {{2, 0}, {2, 1}};
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.removed, 1);
    EXPECT_EQ(result.report.counts.reinserted, 0);
    EXPECT_EQ(result.report.counts.added, 2);
    ASSERT_EQ(result.interlocked.size(), 1u);
    EXPECT_EQ(result.interlocked.front().part, 0) << "the thin frame; what waited is not called interlocked";
    ASSERT_EQ(placed_.size(), 3u);
    EXPECT_EQ(placed_[1].copy.part, 2);
    expect_complete(result);
}

TEST_F(Interlocking, LetsAHeavyCopyStayAndALighterOneGoInstead) {
    tray_ = Tray(TraySetup{{32, 26, 26}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
    put(test::chest_mesh(26, 2, false), 0, {0, 0, 0});
    put(test::cube_mesh(8), 0, {10, 10, 10});
    options_.take_out = TakeOut::thinnest;  // the chest, which has more material than the cube
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.removed, 1);
    ASSERT_EQ(result.interlocked.size(), 1u);
    EXPECT_EQ(result.interlocked.front().part, 1);
    ASSERT_EQ(placed_.size(), 1u);
    expect_complete(result);
}

TEST_F(Interlocking, PutsACopyWhereItsWayOpensLater) {
    // A chest without a lid, and a plate over it: the best place for the cube is inside.
    tray_ = Tray(TraySetup{{39, 28, 40}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
    put(test::chest_mesh(26, 2, true), 0, {0, 0, 0});
    put(test::box_mesh({0, 0, 0}, {28, 28, 2}), 0, {0, 0, 28});
    put(test::chest_mesh(10, 1, false), 0, {29, 0, 0});  // something to take out
    put(test::cube_mesh(3), 0, {32, 3, 3});
    put(test::box_mesh({0, 0, 0}, {10, 17, 38}), 0, {29, 11, 0});
    model_ = {1e8, HeightAt::bottom};
    parts_.meshes.push_back(test::cube_mesh(8));
    options_.order = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
    options_.waiting = {{5, 0}};
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.added, 1);
    expect_complete(result);
    const auto cube = std::ranges::find(placed_, 5, [](const PlacedCopy& placed) { return placed.copy.part; });
    ASSERT_NE(cube, placed_.end());
    EXPECT_LT(cube->position.x, 26) << "in the chest";
    EXPECT_LT(cube->position.z, 26);
}

TEST_F(Interlocking, TriesTheNextBestPlaceWhereACopyDoesNotComeOutOfTheBest) {
    // The best place for a cube is the hollow of a chest with a slit in its lid, the next best a chest under a plate,
    // from where it comes out once that has left; all that can be reached now is higher up.
    tray_ = Tray(TraySetup{{41, 28, 40}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
    put(test::chest_mesh(26, 2, true), 0, {0, 0, 0});
    put(test::box_mesh({0, 0, 0}, {28, 28, 2}), 0, {0, 0, 28});
    put(test::merged(test::chest_mesh(12, 2, true), test::box_mesh({0, 0, 10}, {12, 8, 12})), 0, {29, 0, 0});
    put(test::box_mesh({0, 0, 0}, {12, 16, 40}), 0, {29, 12, 0});
    put(test::chest_mesh(6, 1, false), 0, {29, 0, 12});  // something to take out
    put(test::cube_mesh(2), 0, {31, 2, 14});
    model_ = {1e8, HeightAt::bottom};
    parts_.meshes.push_back(test::cube_mesh(8));
    options_.order = {{6, 0}, {6, 1}, {0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
    options_.waiting = {{6, 0}, {6, 1}};
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.added, 2);
    expect_complete(result);
    for (const PlacedCopy& placed : placed_) {
        if (placed.copy.part != 6) continue;
        EXPECT_LT(placed.position.x, 26) << "in the open chest, the second copy as well";
        EXPECT_LT(placed.position.z, 26);
    }
}

/// Which copies stand where, as told.
struct Told final : TrayObserver {
    void tray_begun(int) override {
        ++begun;
        at.clear();
    }
    void copy_placed(const PlacedCopy& placed) override { at[placed.copy] = placed.position; }
    void copy_moved(const PlacedCopy& placed) override { at[placed.copy] = placed.position; }
    void copy_taken_out(const PlacedCopy& placed) override { at.erase(placed.copy); }
    void copy_put_back(const PlacedCopy& placed) override { at[placed.copy] = placed.position; }
    void tray_finished() override {}

    std::map<Copy, VoxelIndex> at;
    int begun = 0;
};

TEST_F(Interlocking, WithoutACeilingPacksAnewRatherThanOnTop) {
    // Two linked frames, and a plate on the rest of the base: what is taken out finds a place only on top of them.
    tray_ = Tray(TraySetup{{36, 34, 20}, 1, 1, {0}, Ceiling::open, 0, {}, false});
    put(test::frame_mesh(26, 2, 2), 0, {0, 0, 7});
    put(test::lying(test::frame_mesh(16, 5, 6), 0), 0, {10, 17, 0});
    put(test::box_mesh({0, 0, 0}, {10, 34, 16}), 0, {26, 0, 0});
    model_ = {1e8, HeightAt::top};
    options_.order = {{0, 0}, {2, 0}, {1, 0}};
    Told told;
    observer_ = &told;
    const Untangled result = untangle_all();
    EXPECT_EQ(told.begun, 1);
    ASSERT_EQ(told.at.size(), placed_.size());
    for (const PlacedCopy& placed : placed_) {
        EXPECT_EQ(told.at[placed.copy], placed.position);
    }
    EXPECT_EQ(result.report.counts.removed, 0);
    ASSERT_EQ(placed_.size(), 3u);
    expect_complete(result);
    for (const PlacedCopy& placed : placed_) {
        ASSERT_TRUE(tray_.find(placed.object));
        const TrayObject& object = tray_.object(placed.object);
        EXPECT_LE(object.box().hi.z, 16);
        EXPECT_EQ(object.position, placed.position);
    }
}

TEST_F(Interlocking, LeavesWhatIsFreeAsItIs) {
    put(ring(), 0, {10, 10, 20});
    put(ring(), 1, {50, 19, 11});
    const std::vector<PlacedCopy> before = placed_;
    const Untangled result = untangle_all();
    EXPECT_EQ(result.report.counts.removed, 0);
    ASSERT_EQ(placed_.size(), 2u);
    EXPECT_EQ(placed_[1].position, before[1].position);
    expect_complete(result);
}

TEST_F(Interlocking, TheLastCopyToLeaveStillHasFixedOnesToPass) {
    // A cube between two that stay.
    for (const int x : {0, 40}) {
        const auto surface = std::make_shared<const Bvh>(test::cube_mesh(10));
        TrayObject object{std::make_shared<const BitGrid>(voxelize(test::cube_mesh(10), 1, Workers(1))), {x, 0, 0}};
        object.fixed = true;
        tray_.add(object);
        options_.fixed.push_back({surface, {static_cast<double>(x), 0, 0}, object});
    }
    put(test::cube_mesh(8), 0, {20, 0, 0});
    const Untangled result = untangle_all();
    expect_complete(result);
    ASSERT_EQ(result.plan.steps.size(), 1u);
    EXPECT_FALSE(result.plan.steps.front().path.empty());
}

TEST_F(Interlocking, WaysOutAreLookedForInTheTrayAsHighAsItHasGrown) {
    tray_ = Tray(TraySetup{{40, 40, 10}, 1, 1, {0}, Ceiling::open, 0, {}, false});
    PlacedBodies bodies(options_, tray_, placed_, context());
    RemovablePacking packing(bodies, {});
    tray_ = grown(tray_, 50);
    // Above the grid as it was: a chest with a hole in a corner of its lid, and a cube in the opposite corner.
    const Mesh lid = test::merged(test::box_mesh({0, 0, 24}, {26, 14, 26}), test::box_mesh({0, 14, 24}, {14, 26, 26}));
    put(test::merged(test::chest_mesh(26, 2, true), lid), 0, {5, 5, 12});
    EXPECT_TRUE(packing.admit(placed_.back(), tray_.object(placed_.back().object)));
    put(test::cube_mesh(8), 0, {8, 8, 16});
    EXPECT_TRUE(packing.admit(placed_.back(), tray_.object(placed_.back().object)));
    const std::vector<RemovalStep> steps = packing.steps();
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps.front().placements, std::vector<int>{1});
    EXPECT_GT(steps.front().path.size(), 1u) << "not straight out";
}

TEST_F(Interlocking, AStopLeavesAnIncompletePlan) {
    put(ring(), 0, {10, 10, 20});
    StopSource stop;
    stop.request(StopReason::time_limit);
    const Untangled result = untangle_all(stop.token());
    EXPECT_FALSE(result.plan.complete);
    EXPECT_TRUE(result.plan.steps.empty());
    EXPECT_EQ(placed_.size(), 1u);
}

TEST_F(Interlocking, AStopAfterTheLastRemovalLeavesAWholePlan) {
    put(ring(), 0, {10, 10, 20});
    put(test::cube_mesh(8), 0, {40, 40, 0});
    StopSource stop;
    options_.left = [&](int left, int) {
        if (left == 0) stop.request(StopReason::time_limit);
    };
    expect_complete(untangle_all(stop.token()));
}

}  // namespace
}  // namespace spectralpack
