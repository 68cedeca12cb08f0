#include "verify/replay.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "scenes.hpp"

namespace spectralpack::test {
namespace {

using Kind = FindingKind;
using Path = std::vector<Vec3>;

/// A tray with a plan, written by hand. Figures are not stated, so only findings of plans are looked at.
class ReplayTest : public testing::Test {
  protected:
    ReplayTest() {
        packing_.container.size = {100, 100, 100};
        packing_.trays.resize(1);
        tray().disassembly.emplace();
        plan().complete = true;
    }

    TrayPacking& tray() { return packing_.trays[0]; }
    Disassembly& plan() { return *tray().disassembly; }

    /// The placement's index.
    int place(const Mesh& mesh, const Vec3& at = {}, bool fixed = false) {
        PackedPart part;
        part.id = static_cast<int>(packing_.parts.size());
        part.name = "part" + std::to_string(part.id);
        packing_.parts.push_back(part);
        meshes_.push_back(std::make_shared<const Mesh>(mesh));
        tray().placements.push_back({part.id, 0, 0, fixed, {Mat3{}, at}});
        return part.id;
    }

    void step(const std::vector<int>& placements, const Path& path) { plan().steps.push_back({placements, path}); }

    CheckReport check(int threads = 1) {
        Listener quiet;
        return check_packing(packing_, meshes_, Workers(threads), quiet, StopToken());
    }

    std::vector<Finding> plan_findings(int threads = 1) {
        std::vector<Finding> findings;
        for (const Finding& finding : check(threads).findings) {
            if (finding.kind == Kind::plan) findings.push_back(finding);
        }
        return findings;
    }

    void expect_follows() {
        for (const Finding& finding : plan_findings()) {
            ADD_FAILURE() << finding.message;
        }
        EXPECT_TRUE(check().plans_complete());
    }

    void expect_fails(const std::vector<int>& placements, const std::string& text) {
        const std::vector<Finding> findings = plan_findings();
        ASSERT_FALSE(findings.empty()) << text;
        EXPECT_EQ(findings[0].placements, placements) << findings[0].message;
        EXPECT_NE(findings[0].message.find(text), std::string::npos) << findings[0].message;
        EXPECT_FALSE(check().plans_complete());
    }

    Packing packing_;
    std::vector<std::shared_ptr<const Mesh>> meshes_;
};

/// Two boxes on top of each other, a third beside them, all touching.
class Pile : public ReplayTest {
  protected:
    Pile() {
        place(cube_mesh(10));
        place(cube_mesh(10), {0, 0, 10});
        place(cube_mesh(10), {10, 0, 0});
    }
};

TEST_F(Pile, ComesApartFromTheTop) {
    step({1}, {{0, 0, 10}});
    step({0}, {{-10, 0, 0}});
    step({2}, {});
    expect_follows();
    const CheckReport report = check();
    ASSERT_TRUE(report.plans.at(0));
    EXPECT_EQ(report.plans[0]->steps, 3);
    EXPECT_EQ(report.plans[0]->message, "plan: 3 steps replayed, ok");
}

TEST_F(Pile, DoesNotComeApartFromTheBottom) {
    step({0}, {{0, 0, 30}, {0, 50, 0}});
    step({1}, {{0, 0, 10}});
    step({2}, {});
    expect_fails({0, 1}, "step 1 of 3: part0 #0 runs into part1 #0");
    EXPECT_GT(plan_findings()[0].amount, 1);
    EXPECT_EQ(check().plans[0]->failed_steps, std::vector<int>{0});
}

TEST_F(Pile, MustLeaveTheBoxOfWhatIsLeft) {
    step({0}, {{-9.5, 0, 0}});
    step({1}, {{0, 0, 10}});
    step({2}, {});
    expect_fails({0}, "ends inside the bounding box of what is left, 0.5 mm");
}

TEST_F(Pile, ACompletePlanMissesNobody) {
    step({1}, {{0, 0, 10}});
    step({0}, {{-10, 0, 0}});
    expect_fails({2}, "has no step for part2 #0");
    plan().complete = false;
    EXPECT_TRUE(plan_findings().empty());
    const CheckReport report = check();
    EXPECT_FALSE(report.plans_complete());
    EXPECT_EQ(report.plans[0]->without_step, std::vector<int>{2});
    EXPECT_EQ(report.plans[0]->message, "plan: 2 steps replayed, ok; INCOMPLETE: no way out for part2 #0");
}

TEST_F(Pile, FixedCopiesStayAndAreInTheWay) {
    tray().placements[1].fixed = true;
    step({2}, {{10, 0, 0}});
    step({0}, {{-10, 0, 0}, {0, 0, 20}, {10, 0, 0}});
    expect_follows();
    plan().steps[1].path = {{0, 0, 30}};
    expect_fails({0, 1}, "runs into");
    plan().steps[1] = {{1}, {{0, 0, 10}}};
    EXPECT_FALSE(plan_findings().empty());
}

TEST_F(Pile, APhysicalContainerIsInTheWayToo) {
    const auto steps = [&](const Path& first) {
        plan().steps = {{{1}, first}, {{0}, {{0, 0, 100}}}, {{2}, {{0, 0, 100}}}};
    };
    steps({{0, 0, 90}});
    expect_follows();
    packing_.container.physical = true;
    expect_follows();
    steps({{0, 0, 30}, {50, 0, 0}, {0, 0, 60}});  // round about, within
    expect_follows();
    steps({{0, 0, 80}});
    expect_fails({1}, "ends inside the bounding box of what is left and of the container, 10 mm");
    steps({{-20, 0, 0}});
    expect_fails({1}, "part1 #0 runs into the container");
    packing_.container.physical = false;
    expect_follows();
}

TEST_F(Pile, WhatLeavesLastLeavesAPhysicalContainer) {
    packing_.container.physical = true;
    plan().steps = {{{1}, {{0, 0, 90}}}, {{0}, {{0, 0, 100}}}, {{2}, {}}};
    expect_fails({2}, "of the container");
}

TEST_F(Pile, PhysicalKeepOutsAreInTheWay) {
    packing_.container.keep_out = {{Box{{0, 0, 50}, {40, 40, 52}}}};
    plan().steps = {{{1}, {{0, 0, 90}}}, {{0}, {{0, 0, 100}}}, {{2}, {{0, 0, 100}}}};
    expect_follows();
    packing_.container.physical = true;
    expect_fails({1}, "runs into the container");
    plan().steps = {
        {{1}, {{50, 0, 0}, {0, 0, 90}}}, {{2}, {{40, 0, 0}, {0, 0, 100}}}, {{0}, {{50, 0, 0}, {0, 0, 100}}}};
    expect_follows();
}

TEST_F(Pile, ImpossibleStepsAreFindingsNotCrashes) {
    const std::vector<RemovalStep> wrong{
        {{}, {}}, {{7}, {}}, {{-1}, {}}, {{0}, {{Box::kInfinity, 0, 0}}}, {{1}, {{0, 0, 10}}}, {{1}, {{0, 0, 10}}}};
    plan().steps = wrong;
    EXPECT_EQ(check().plans[0]->failed_steps, (std::vector<int>{0, 1, 2, 3, 5}));
}

TEST_F(ReplayTest, ALongMoveDoesNotTunnelThroughAThinWall) {
    const int box = place(cube_mesh(10));
    const int wall = place(box_mesh({50, -5, -5}, {50.02, 20, 20}));
    step({box}, {{2000, 0, 0}});
    step({wall}, {});
    expect_fails({box, wall}, "runs into");
    plan().steps[0].path = {{0, 0, 30}, {2000, 0, 0}};
    expect_follows();
}

TEST_F(ReplayTest, AHundredthOfAMillimetreIsTooDeep) {
    const int box = place(cube_mesh(10));
    const int floor = place(merged(box_mesh({0, 0, -1}, {20, 10, 0}), box_mesh({20, 0, -1}, {40, 10, 0.01})));
    step({box}, {{40, 0, 0}});
    step({floor}, {});
    expect_fails({box, floor}, "at least 0.01 mm deep");
    plan().steps[0].path = {{10, 0, 0}, {0, 0, 0.01}, {30, 0, 0}};
    expect_follows();
}

/// A box in a tub with a lid: an L-shaped way out once the lid is gone.
TEST_F(ReplayTest, WaysMayTurn) {
    Cells tub = box_cells({0, 0, 0}, {4, 4, 4});
    for (const Cell& cell : box_cells({1, 1, 1}, {4, 3, 4})) {
        if (cell[2] < 3 || cell[0] == 3) tub.erase(cell);
    }
    const int holder = place(block_mesh(tub));
    const int box = place(block_mesh(box_cells({0, 0, 0}, {1, 2, 2})), {1, 1, 1});
    step({box}, {{5, 0, 0}});
    step({holder}, {});
    expect_follows();
    plan().steps[0].path = {{0, 0, 10}};
    expect_fails({box, holder}, "runs into");
    plan().steps[0].path = {{2, 0, 0}, {0, 0, 10}};
    expect_follows();
}

/// A rail in its slot, in a well that is open above: they slide apart along y, which the well allows to neither.
class Rail : public ReplayTest {
  protected:
    Rail() {
        Cells rail = box_cells({1, 0, 1}, {4, 2, 2});
        rail.merge(box_cells({2, 0, 2}, {3, 2, 4}));
        Cells slot = box_cells({0, 0, 0}, {5, 2, 3});
        Cells well = box_cells({-1, -1, -1}, {6, 3, 4});
        for (const Cell& cell : rail) {
            slot.erase(cell);
        }
        for (const Cell& cell : box_cells({0, 0, 0}, {5, 2, 4})) {
            well.erase(cell);
        }
        for (const Cells& cells : {rail, slot, well}) {
            place(block_mesh(cells), {1, 1, 1});
        }
    }
};

TEST_F(Rail, LeavesWithItsSlotAndPartsOutside) {
    step({0, 1}, {{0, 0, 20}});
    step({2}, {});
    step({0}, {{0, 2, 0}});  // past where the well was
    step({1}, {});
    expect_follows();
}

TEST_F(Rail, MustComeOutOfItsSlotToo) {
    step({0, 1}, {{0, 0, 20}});
    step({2}, {});
    expect_fails({0, 1}, "has no step for part0 #0, part1 #0");
    step({0}, {{0, 0, 20}});
    step({1}, {});
    expect_fails({0, 1}, "step 3 of 4: part0 #0 runs into part1 #0");
}

TEST_F(Rail, DoesNotLeaveAlone) {
    step({0}, {{0, 0, 40}});
    step({1}, {{0, 0, 40}});
    step({2}, {});
    expect_fails({0, 1}, "runs into");
    plan().steps = {{{1}, {{0, 0, 40}}}, {{0}, {{0, 0, 40}}}, {{2}, {}}};
    expect_fails({1, 0}, "runs into");
    plan().steps = {{{0}, {{0, 40, 0}}}, {{1}, {{0, 0, 40}}}, {{2}, {}}};
    expect_fails({0, 2}, "runs into");
}

TEST_F(Rail, CannotGoWithTheWellOnceItLeft) {
    step({0, 1}, {{0, 0, 20}});
    step({1, 2}, {{0, 0, 40}});
    expect_fails({}, "no longer stand together");
}

/// Boxes strewn about, lifted in the order of their tops; in any other order some fail exactly where boxes lie above.
TEST_F(ReplayTest, StrewnBoxesComeOffFromTheTop) {
    RandomStream random(3);
    std::vector<Box> boxes;
    while (boxes.size() < 60) {
        const Vec3 size = random_point(random, 10) + Vec3{12, 12, 12}, at = random_point(random, 40) + Vec3{40, 40, 40};
        const Box box{at, at + size};
        if (std::any_of(boxes.begin(), boxes.end(), [&](const Box& other) { return distance(box, other) == 0; }))
            continue;
        boxes.push_back(box);
        place(box_mesh({}, size), at);
    }
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto box = [&](int i) -> const Box& { return boxes[static_cast<std::size_t>(i)]; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return box(a).min.z > box(b).min.z; });
    for (const int i : order) {
        step({i}, {{0, 0, 200}});
    }
    expect_follows();

    std::reverse(plan().steps.begin(), plan().steps.end());
    std::vector<int> blocked;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Box& leaving = box(plan().steps[k].placements[0]);
        for (std::size_t later = k + 1; later < order.size(); ++later) {
            const Box& other = box(plan().steps[later].placements[0]);
            if (other.min.z > leaving.min.z && leaving.max.x > other.min.x && other.max.x > leaving.min.x &&
                leaving.max.y > other.min.y && other.max.y > leaving.min.y) {
                blocked.push_back(static_cast<int>(k));
                break;
            }
        }
    }
    EXPECT_FALSE(blocked.empty());
    const CheckReport one = check(1), two = check(3);
    EXPECT_EQ(one.plans[0]->failed_steps, blocked);
    ASSERT_EQ(one.findings.size(), two.findings.size());
    for (std::size_t i = 0; i < one.findings.size(); ++i) {
        EXPECT_EQ(one.findings[i].message, two.findings[i].message);
    }
}

TEST_F(ReplayTest, WithoutAPlanNothingIsSaid) {
    place(cube_mesh(10));
    tray().disassembly.reset();
    const CheckReport report = check();
    ASSERT_EQ(report.plans.size(), 1u);
    EXPECT_FALSE(report.plans[0]);
    EXPECT_FALSE(report.plans_complete());
}

}  // namespace
}  // namespace spectralpack::test
