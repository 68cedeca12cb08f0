/// Plans that are followed, and plans that are not.

#include "plans_by_hand.hpp"

namespace spectralpack::test {
namespace {

class Replay : public Pile {};
class ReplayOfOne : public PlansByHand {};

TEST_F(Replay, ComesApartFromTheTop) {
    step({1}, {{0, 0, 10}});
    step({0}, {{-10, 0, 0}});
    step({2}, {});
    expect_follows();
    const CheckReport report = check();
    ASSERT_TRUE(report.plans.at(0));
    EXPECT_EQ(report.plans[0]->steps, 3);
    EXPECT_TRUE(report.plans[0]->ok());
    EXPECT_TRUE(names(report.plans[0]->message, {"plan", 3}));
}

TEST_F(Replay, DoesNotComeApartFromTheBottom) {
    step({0}, {{0, 0, 30}, {0, 50, 0}});
    step({1}, {{0, 0, 10}});
    step({2}, {});
    expect_fails({0, 1}, {"step 1"});
    EXPECT_GT(plan_findings()[0].amount, 1);
    EXPECT_EQ(check().plans[0]->failed_steps, std::vector<int>{0});
}

TEST_F(Replay, MustLeaveTheBoxOfWhatIsLeft) {
    step({0}, {{-9.5, 0, 0}});
    step({1}, {{0, 0, 10}});
    step({2}, {});
    expect_fails({0}, {0.5, "mm"});
}

TEST_F(Replay, ACompletePlanMissesNobody) {
    step({1}, {{0, 0, 10}});
    step({0}, {{-10, 0, 0}});
    expect_fails({2});
    plan().complete = false;
    EXPECT_TRUE(plan_findings().empty());
    const CheckReport report = check();
    EXPECT_FALSE(report.plans_complete());
    EXPECT_EQ(report.plans[0]->without_step, std::vector<int>{2});
    EXPECT_TRUE(report.plans[0]->ok()) << "as far as it goes";
    EXPECT_TRUE(names(report.plans[0]->message, {2, "INCOMPLETE", "part2"}));
}

TEST_F(Replay, FixedCopiesStayAndAreInTheWay) {
    tray().placements[1].fixed = true;
    step({2}, {{10, 0, 0}});
    step({0}, {{-10, 0, 0}, {0, 0, 20}, {10, 0, 0}});
    expect_follows();
    plan().steps[1].path = {{0, 0, 30}};
    expect_fails({0, 1});
    plan().steps[1] = {{1}, {{0, 0, 10}}};
    EXPECT_FALSE(plan_findings().empty());
}

TEST_F(Replay, ImpossibleStepsAreFindingsNotCrashes) {
    const std::vector<RemovalStep> wrong{
        {{}, {}}, {{7}, {}}, {{-1}, {}}, {{0}, {{Box::kInfinity, 0, 0}}}, {{1}, {{0, 0, 10}}}, {{1}, {{0, 0, 10}}}};
    plan().steps = wrong;
    EXPECT_EQ(check().plans[0]->failed_steps, (std::vector<int>{0, 1, 2, 3, 5}));
}

TEST_F(ReplayOfOne, WithoutAPlanNothingIsSaid) {
    place(cube_mesh(10));
    tray().disassembly.reset();
    const CheckReport report = check();
    ASSERT_EQ(report.plans.size(), 1u);
    EXPECT_FALSE(report.plans[0]);
    EXPECT_FALSE(report.plans_complete());
}

}  // namespace
}  // namespace spectralpack::test
