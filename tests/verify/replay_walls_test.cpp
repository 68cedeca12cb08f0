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

}  // namespace
}  // namespace spectralpack::test
