/// Containers whose walls are there when the packing comes apart.

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

class PhysicalContainers : public WholeJob {};

double top_of(const json& packing, const json& step) {
    double z = packing["trays"][0]["placements"][step["placements"][0].get<std::size_t>()]["transform"][2][3];
    for (const json& move : step["path"]) {
        z += move[2].get<double>();
    }
    return z;
}

TEST_F(PhysicalContainers, WhatLeavesABottleLeavesThroughItsNeck) {
    stl("bottle.stl", bottle_mesh());
    const std::vector<std::string> options{at("cube.stl") + ":6", "--container", at("bottle.stl"), "--no-refine"};
    ASSERT_EQ(pack(options).status, 0);
    json packing = build();
    EXPECT_EQ(packing["metrics"]["placed"], 6);
    expect_sound();
    // That plan goes through the walls.
    packing["container"]["physical"] = true;
    std::ofstream(at("through.json")) << packing;
    const json through = check_report(at("through.json"), 1)["findings"];
    ASSERT_FALSE(through.empty());
    for (const json& finding : through) {
        EXPECT_EQ(finding["kind"], "plan");
        EXPECT_TRUE(names(finding["message"], {"cube", "container"}));
    }

    for (const char* interlock : {"post", "place"}) {
        const Ran ran = pack(options + std::vector<std::string>{"--physical", "--interlock", interlock});
        ASSERT_EQ(ran.status, 0) << ran.err;
        packing = build();
        EXPECT_EQ(packing["metrics"]["placed"], 6);
        EXPECT_TRUE(packing["container"]["physical"]);
        ASSERT_EQ(packing["trays"][0]["disassembly"]["steps"].size(), 6u);
        bool corners = false;
        for (const json& step : packing["trays"][0]["disassembly"]["steps"]) {
            EXPECT_GE(top_of(packing, step), 40);
            corners = corners || step["path"].size() > 1;
        }
        EXPECT_TRUE(corners) << "from beside the neck";
        const Ran checked = spectralpack({"check", at("build.json"), "--require-plan"});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
        EXPECT_EQ(spectralpack({"plan", at("build.json"), "--voxel", "1", "-o", at("planned.json")}).status, 0);
        EXPECT_EQ(spectralpack({"check", at("planned.json"), "--require-plan"}).status, 0);
    }
}

TEST_F(PhysicalContainers, WhatIsTooWideForTheNeckStaysOut) {
    stl("bottle.stl", bottle_mesh());
    stl("wide.stl", cube_mesh(18));
    const std::vector<std::string> options{at("wide.stl"), at("cube.stl") + ":2", "--container", at("bottle.stl")};
    const auto with = [&](const std::vector<std::string>& more) { return pack(options + more); };
    ASSERT_EQ(with({}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 3);
    ASSERT_EQ(with({"--physical", "--interlock", "off"}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 3);
    const Ran planned = spectralpack({"plan", at("build.json")});
    EXPECT_EQ(planned.status, 1);
    EXPECT_TRUE(names(planned.out, {1, "wide"}));
    EXPECT_FALSE(names(planned.out, {"cube"}));
    const char* reasons[] = {"cannot_leave", "no_place"};
    for (const char* interlock : {"post", "place"}) {
        ASSERT_EQ(with({"--physical", "--interlock", interlock}).status, 0);
        EXPECT_EQ(build()["metrics"]["placed"], 2);
        ASSERT_EQ(build()["unplaced"].size(), 1u);
        EXPECT_EQ(build()["unplaced"][0]["reason"], reasons[interlock == std::string("place")]);
        EXPECT_EQ(spectralpack({"check", at("build.json"), "--require-plan"}).status, 0);
    }
}

TEST_F(PhysicalContainers, ACrateIsLeftUpwardsAndRoundItsKeepOuts) {
    for (const char* gap : {"0", "1.5"}) {
        const Ran ran = pack({at("cube.stl") + ":12", "--tray", "44x44x44", "--physical", "--keep-out",
                              "14,0,22,44,44,26", "--wall-gap", gap});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const json packing = build();
        EXPECT_EQ(packing["metrics"]["placed"], 12);
        for (const json& step : packing["trays"][0]["disassembly"]["steps"]) {
            EXPECT_GE(top_of(packing, step), 44);
        }
        const Ran checked = spectralpack({"check", at("build.json"), "--require-plan"});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    }
}

TEST_F(PhysicalContainers, AContainerThatNothingCanLeaveIsNamed) {
    stl("tube.stl", torus_mesh(40, 18, 48, 24));
    const Ran closed = pack({at("cube.stl"), "--container", at("tube.stl"), "--physical"});
    EXPECT_EQ(closed.status, 3);
    EXPECT_TRUE(names(closed.err, {"tube.stl", "top", "--interlock off"}));
    EXPECT_EQ(pack({at("cube.stl"), "--container", at("tube.stl"), "--physical", "--interlock", "off"}).status, 0);
    EXPECT_EQ(pack({at("cube.stl"), "--tray", "40x40", "--open-height", "--physical"}).status, 2);
}

}  // namespace
}  // namespace spectralpack::test
