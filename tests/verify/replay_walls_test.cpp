/// Plans where the container and its keep-outs are really there.

#include "plans_by_hand.hpp"

namespace spectralpack::test {
namespace {

class ReplayWalls : public Pile {};

TEST_F(ReplayWalls, APhysicalContainerIsInTheWayToo) {
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
    expect_fails({1}, {"container", 10, "mm"});
    steps({{-20, 0, 0}});
    expect_fails({1}, {"container"});
    packing_.container.physical = false;
    expect_follows();
}

TEST_F(ReplayWalls, WhatLeavesLastLeavesAPhysicalContainer) {
    packing_.container.physical = true;
    plan().steps = {{{1}, {{0, 0, 90}}}, {{0}, {{0, 0, 100}}}, {{2}, {}}};
    expect_fails({2}, {"container"});
}

TEST_F(ReplayWalls, PhysicalKeepOutsAreInTheWay) {
    packing_.container.keep_out = {{Box{{0, 0, 50}, {40, 40, 52}}}};
    plan().steps = {{{1}, {{0, 0, 90}}}, {{0}, {{0, 0, 100}}}, {{2}, {{0, 0, 100}}}};
    expect_follows();
    packing_.container.physical = true;
    expect_fails({1}, {"container"});
    plan().steps = {
        {{1}, {{50, 0, 0}, {0, 0, 90}}}, {{2}, {{40, 0, 0}, {0, 0, 100}}}, {{0}, {{50, 0, 0}, {0, 0, 100}}}};
    expect_follows();
}

/// Of a plan that goes from the top, those steps that it does not name keep clear of walls that are not physical.
TEST_F(ReplayWalls, APlanFromTheTopGoesBetweenTheWalls) {
    const auto steps = [&](const Path& first) {
        plan().steps = {{{1}, first}, {{0}, {{0, 0, 100}}}, {{2}, {{0, 0, 100}}}};
    };
    plan().unpack = Unpack::top;
    steps({{0, 0, 90}});
    expect_follows();
    EXPECT_EQ(check().plans[0]->unpack, Unpack::top);
    EXPECT_EQ(check().plans[0]->through_walls, 0);
    steps({{-100, 0, 0}});
    expect_fails({1}, {"container"});
    plan().through_walls = {0};
    expect_follows();
    EXPECT_EQ(check().plans[0]->through_walls, 1);
    EXPECT_TRUE(names(check().plans[0]->message, {3, 1, "through the walls"}));
    plan().through_walls = {1};
    expect_fails({1}, {"container"});
    plan().unpack = Unpack::any;
    plan().through_walls = {};
    expect_follows();
    plan().unpack = Unpack::top;
    packing_.container.physical = true;
    plan().through_walls = {0};  // these never give way
    expect_fails({1}, {"container"});
}

}  // namespace
}  // namespace spectralpack::test
