/// Ways that are long, turn, or are taken together.

#include <algorithm>
#include <numeric>

#include "plans_by_hand.hpp"

namespace spectralpack::test {
namespace {

class ReplayWays : public PlansByHand {};

TEST_F(ReplayWays, ALongMoveDoesNotTunnelThroughAThinWall) {
    const int box = place(cube_mesh(10));
    const int wall = place(box_mesh({50, -5, -5}, {50.02, 20, 20}));
    step({box}, {{2000, 0, 0}});
    step({wall}, {});
    expect_fails({box, wall});
    plan().steps[0].path = {{0, 0, 30}, {2000, 0, 0}};
    expect_follows();
}

TEST_F(ReplayWays, AHundredthOfAMillimetreIsTooDeep) {
    const int box = place(cube_mesh(10));
    const int floor = place(merged(box_mesh({0, 0, -1}, {20, 10, 0}), box_mesh({20, 0, -1}, {40, 10, 0.01})));
    step({box}, {{40, 0, 0}});
    step({floor}, {});
    expect_fails({box, floor}, {0.01, "mm"});
    plan().steps[0].path = {{10, 0, 0}, {0, 0, 0.01}, {30, 0, 0}};
    expect_follows();
}

/// A box in a tub with a lid: an L-shaped way out once the lid is gone.
TEST_F(ReplayWays, WaysMayTurn) {
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
    expect_fails({box, holder});
    plan().steps[0].path = {{2, 0, 0}, {0, 0, 10}};
    expect_follows();
}

/// Boxes strewn about, lifted in the order of their tops; in any other order some fail exactly where boxes lie above.
TEST_F(ReplayWays, StrewnBoxesComeOffFromTheTop) {
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

/// A rail in its slot, in a well that is open above: they slide apart along y, which the well allows to neither.
class Rail : public PlansByHand {
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
    expect_fails({0, 1});
    step({0}, {{0, 0, 20}});
    step({1}, {});
    expect_fails({0, 1}, {"step 3"});
}

TEST_F(Rail, DoesNotLeaveAlone) {
    step({0}, {{0, 0, 40}});
    step({1}, {{0, 0, 40}});
    step({2}, {});
    expect_fails({0, 1});
    plan().steps = {{{1}, {{0, 0, 40}}}, {{0}, {{0, 0, 40}}}, {{2}, {}}};
    expect_fails({1, 0});
    plan().steps = {{{0}, {{0, 40, 0}}}, {{1}, {{0, 0, 40}}}, {{2}, {}}};
    expect_fails({0, 2});
}

TEST_F(Rail, CannotGoWithTheWellOnceItLeft) {
    step({0, 1}, {{0, 0, 20}});
    step({1, 2}, {{0, 0, 40}});
    expect_fails({}, {"step 2"});
    EXPECT_EQ(check().plans[0]->failed_steps, std::vector<int>{1});
}

}  // namespace
}  // namespace spectralpack::test
