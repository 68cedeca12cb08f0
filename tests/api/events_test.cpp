/// Events add up to the packing.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <spectralpack/spectralpack.hpp>

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using Copies = std::map<std::pair<int, int>, std::pair<int, Transform>>;  // part, copy -> orientation, transform

/// Applies the events as somebody would who follows a run from outside.
struct Follower : Listener {
    std::map<int, Copies> trays;
    std::map<int, bool> finished;
    std::map<EventKind, int> seen;
    bool sound = true;  ///< nothing stands twice, nothing leaves that does not stand

    void on_event(const Event& event) override {
        ++seen[event.kind];
        Copies& copies = trays[event.tray];
        const std::pair key(event.part, event.copy);
        switch (event.kind) {
            case EventKind::tray_begun:
                copies.clear();
                finished[event.tray] = false;
                break;
            case EventKind::copy_placed:
            case EventKind::copy_put_back:
                sound = sound && copies.emplace(key, std::pair(event.orientation, event.transform)).second;
                break;
            case EventKind::copy_moved:
                sound = sound && copies.contains(key);
                copies[key] = {event.orientation, event.transform};
                break;
            case EventKind::copy_taken_out:
                sound = sound && copies.erase(key) == 1;
                break;
            case EventKind::tray_finished:
                finished[event.tray] = true;
                break;
        }
    }
};

Job job_of(std::vector<Part> parts, const Vec3& tray) {
    Job job;
    job.parts = std::move(parts);
    job.options.tray = tray;
    job.options.voxel = 2;
    job.options.gap = 0.5;
    job.options.threads = 2;
    return job;
}

/// Hooks and rings lock; cubes do not.
std::vector<Part> parts(int count) {
    return {{.name = "ring", .mesh = test::torus_mesh(12, 2), .count = count},
            {.name = "bracket", .mesh = test::bracket(), .count = count, .scale = 2},
            {.name = "cube", .mesh = test::cube_mesh(9), .count = count}};
}

void expect_followed(const Job& job, bool some_left_over = false) {
    Follower follower;
    const PackResult result = pack(job, {&follower});
    ASSERT_FALSE(result.failure) << result.failure->what();
    EXPECT_TRUE(follower.sound);
    EXPECT_EQ(!result.packing.unplaced.empty(), some_left_over);
    EXPECT_GT(result.packing.metrics.placed, 0);
    for (std::size_t tray = 0; tray < result.packing.trays.size(); ++tray) {
        Copies copies;
        for (const Placement& placement : result.packing.trays[tray].placements) {
            if (placement.fixed) continue;
            copies[{placement.part, placement.copy}] = {placement.orientation, placement.transform};
        }
        const int number = static_cast<int>(tray);
        EXPECT_EQ(follower.trays[number], copies) << "tray " << tray;
        EXPECT_TRUE(follower.finished[number]) << "tray " << tray;
    }
}

TEST(Events, OfOneTray) { expect_followed(job_of(parts(6), {80, 60, 40})); }

TEST(Events, OfATrayThatOverflows) { expect_followed(job_of(parts(30), {60, 50, 30}), true); }

TEST(Events, OfSeveralTrays) {
    Job job = job_of(parts(12), {50, 40, 30});
    job.options.trays = 0;
    expect_followed(job);
}

TEST(Events, OnTheGrid) {
    Job job = job_of(parts(6), {80, 60, 40});
    job.options.refine = false;
    job.options.interlock = Interlock::off;
    expect_followed(job);
}

TEST(Events, WithoutACeiling) {
    Job job = job_of(parts(8), {50, 40, 0});
    job.options.open_height = true;
    expect_followed(job);
}

TEST(Events, OfTheLeastBox) {
    Job job = job_of(parts(3), {60, 60, 0});
    job.options.minimise = Minimise::box;
    expect_followed(job);
}

TEST(Events, OfAFilledTray) {
    Job job = job_of(parts(1), {50, 40, 30});
    job.options.fill = true;
    expect_followed(job);
}

TEST(Events, OfTheBestOrder) {
    Job job = job_of(parts(12), {50, 40, 30});
    job.options.restarts = 3;
    job.options.beam = 2;
    expect_followed(job, true);
}

TEST(Events, OnTopOfABuild) {
    Job job = job_of(parts(3), {80, 60, 40});
    const PackResult build = pack(job);
    job.onto = Scene{build.packing, build.meshes};
    expect_followed(job);
}

RC_GTEST_PROP(Events, AddUpToThePacking, ()) {
    std::vector<Part> random;
    for (int part = *rc::gen::inRange(1, 4); part > 0; --part) {
        const auto side = [] { return static_cast<double>(*rc::gen::inRange(4, 14)); };
        Part box{.name = "box", .mesh = test::box_mesh({0, 0, 0}, {side(), side(), side()})};
        box.count = *rc::gen::inRange(1, 8);
        random.push_back(box);
        random.push_back({.name = "ring", .mesh = test::torus_mesh(side() + 3, 1.5), .count = box.count});
    }
    Job job = job_of(std::move(random), {50, 40, 34});
    job.options.trays = *rc::gen::inRange(0, 3);
    Follower follower;
    const PackResult result = pack(job, {&follower});
    RC_ASSERT(follower.sound);
    for (std::size_t tray = 0; tray < result.packing.trays.size(); ++tray) {
        Copies copies;
        for (const Placement& placement : result.packing.trays[tray].placements) {
            copies[{placement.part, placement.copy}] = {placement.orientation, placement.transform};
        }
        RC_ASSERT(follower.trays[static_cast<int>(tray)] == copies);
    }
}

}  // namespace
}  // namespace spectralpack
