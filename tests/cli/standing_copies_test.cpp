/// Fixed copies, and builds that are topped up.

#include <algorithm>
#include <map>
#include <set>

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class StandingCopies : public WholeJob {};

TEST_F(StandingCopies, TopsUpABuildWithoutTouchingIt) {
    ASSERT_EQ(pack({at("slab.stl") + ":2", "--tray", "40x40x30"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    const json old = read_json(folder_ / "old.json");
    const Ran ran = pack({at("cube.stl") + ":20", "--onto", at("old.json")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = build();
    EXPECT_EQ(packing["container"]["size"], json({40, 40, 30}));
    EXPECT_EQ(packing["parts"].size(), 2u);
    EXPECT_EQ(packing["parts"][0]["name"], "slab");
    const json& placements = packing["trays"][0]["placements"];
    ASSERT_EQ(placements.size(), 18u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(placements[i]["fixed"]);
        EXPECT_EQ(placements[i]["transform"], old["trays"][0]["placements"][i]["transform"]);
    }
    EXPECT_FALSE(placements[2]["fixed"]);
    EXPECT_NEAR(packing["trays"][0]["density"], 1, 1e-9);
    EXPECT_EQ(packing["metrics"]["placed"], 18);
    EXPECT_EQ(packing["unplaced"].size(), 4u);
    expect_sound();
    // And once more, in two trays now.
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    ASSERT_EQ(pack({at("cube.stl") + ":4", "--onto", at("old.json"), "--trays", "all"}).status, 0);
    EXPECT_EQ(build()["trays"].size(), 2u);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 18u);
    expect_sound();
}

TEST_F(StandingCopies, ComeOutLikeTheOthers) {
    ASSERT_EQ(pack({at("slab.stl") + ":2", "--tray", "40x40x40"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    const Ran ran = pack({at("cube.stl") + ":16", "--onto", at("old.json"), "--report", at("r.html")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {"comes apart in 18 steps"}));
    EXPECT_TRUE(names(read_text(folder_ / "r.html"), {"Comes apart in 18", "Dotted outlines: stood there before"}));
    const json tray = build()["trays"][0];
    EXPECT_TRUE(tray["placements"][0]["before"]);
    std::set<int> out;
    for (const json& step : tray["disassembly"]["steps"]) {
        if (step["placements"].size() == 1) out.insert(step["placements"][0].get<int>());
    }
    EXPECT_EQ(out.size(), 18u);
    EXPECT_EQ(tray["disassembly"]["through_walls"], json::array())
        << "from the top down, past nothing that still stands";
    expect_sound();
    EXPECT_TRUE(names(spectralpack({"check", at("build.json"), "--require-plan"}).out, {"comes apart in 18 steps"}));
    EXPECT_TRUE(names(spectralpack({"plan", at("build.json")}).out, {"comes apart in 18 steps"}));
    // Once more: those of both builds.
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    ASSERT_EQ(pack({at("cube.stl") + ":16", "--onto", at("old.json")}).status, 0);
    EXPECT_EQ(build()["trays"][0]["disassembly"]["steps"].size(), 34u);
    expect_sound();
}

TEST_F(StandingCopies, ThatCannotComeOutAreSaidToStay) {
    stl("ring.stl", torus_mesh(10, 2));
    Packing linked;
    linked.container.size = linked.options.tray = {60, 80, 60};
    linked.options.gap = 0;
    PackedPart ring;
    ring.name = "ring";
    ring.mesh = at("ring.stl");
    ring.count = 2;
    linked.parts = {ring};
    linked.trays.resize(1);
    linked.trays[0].placements = {{0, 0, 0, false, {Mat3{}, {20, 40, 30}}},
                                  {0, 1, 0, false, {{Vec3{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {30, 40, 30}}}};
    write_packing(linked, folder_ / "old.json");
    const Ran ran = pack({at("cube.stl") + ":4", "--onto", at("old.json"), "--report", at("r.html")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const std::vector<Fact> facts{"4 new copies come apart", "copies that stood there before stay"};
    EXPECT_TRUE(names(ran.out, facts));
    EXPECT_TRUE(names(read_text(folder_ / "r.html"), {"2 copies that stood there before stay", "new copies alone"}));
    EXPECT_EQ(build()["trays"][0]["disassembly"]["steps"].size(), 4u);
    const Ran checked = spectralpack({"check", at("build.json")});
    EXPECT_TRUE(names(checked.out, {"new copies come apart in 4 steps", "2 copies that stood there before stay"}));
    const Ran planned = spectralpack({"plan", at("build.json")});
    EXPECT_EQ(planned.status, 0);
    EXPECT_TRUE(names(planned.out, {"new copies come apart in 4 steps", "2 copies that stood there before stay"}));
}

TEST_F(StandingCopies, KeepTheirNumbers) {
    stl("plate.stl", box_mesh({0, 0, 0}, {40, 40, 4}));
    ASSERT_EQ(pack({at("cube.stl") + ":3", at("slab.stl") + ":3", at("plate.stl"), "--tray", "40x40x34"}).status, 0);
    const auto stands = [&] {  // by number
        std::map<int, std::string> found;
        const json packing = build();
        const CopyNumbers numbers(read_packing(folder_ / "build.json").parts);
        for (const json& tray : packing["trays"]) {
            for (const json& placement : tray["placements"]) {
                const int number = numbers.of(placement["part"], placement["copy"]);
                EXPECT_TRUE(found.emplace(number, placement["transform"].dump()).second) << number << " is there twice";
            }
        }
        return found;
    };
    std::map<int, std::string> before = stands();
    ASSERT_LT(before.size(), 7u) << "one is left over, so that there is a number that nobody has";
    for (int again = 0; again < 2; ++again) {
        fs::rename(folder_ / "build.json", folder_ / "old.json");
        ASSERT_EQ(pack({at("cube.stl") + ":2", "--onto", at("old.json"), "--trays", "all"}).status, 0);
        const std::map<int, std::string> after = stands();
        EXPECT_EQ(after.size(), before.size() + 2);
        for (const auto& [number, transform] : before) {
            EXPECT_EQ(after.at(number), transform);
        }
        before = after;
    }
}

TEST_F(StandingCopies, TheGapsAreThoseOfTheBuild) {
    const auto run = [&](const std::vector<std::string>& arguments) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack"} + arguments +
                                     std::vector<std::string>{"--threads", "1", "-o", at("build.json")});
        EXPECT_EQ(ran.status, 0) << ran.err;
        return ran;
    };
    run({at("cube.stl") + ":4", "--tray", "60x60x40", "--gap", "2", "--wall-gap", "3"});
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    const std::vector<std::string> more{at("cube.stl") + ":2", "--onto", at("old.json")};
    const Ran same = run(more);
    EXPECT_TRUE(names(same.out, {"60 x 60 x 40 mm", "as in old.json", "2.0 mm between", "3.0 mm to the walls"}))
        << same.out;
    EXPECT_EQ(same.err, "");
    EXPECT_EQ(build()["options"]["gap"], 2);
    EXPECT_EQ(build()["options"]["wall-gap"], 3);
    EXPECT_GE(build()["metrics"]["min_gap"], 2 - 1e-6);
    expect_sound();
    // What is said counts, and that it differs is said.
    const Ran other = run(more + std::vector<std::string>{"--gap", "1", "--wall-gap", "3"});
    EXPECT_TRUE(names(other.err, {"gap", "1 mm", "old.json", "2 mm"})) << other.err;
    EXPECT_FALSE(contains(other.err, "wall gap"));
    EXPECT_EQ(build()["options"]["gap"], 1);
    expect_sound();
    const Ran larger = run(more + std::vector<std::string>{"--tray", "60x60x50"});
    EXPECT_TRUE(names(larger.err, {"60 x 60 x 50 mm", "60 x 60 x 40 mm"})) << larger.err;
    // A job file says it as well.
    std::ofstream(at("job.json")) << json{{"format", "spectralpack/job"},
                                          {"version", 1},
                                          {"gap", 4},
                                          {"options", {{"onto", "old.json"}}},
                                          {"parts", {{{"mesh", "cube.stl"}}}}};
    const Ran job = run({at("job.json")});
    EXPECT_TRUE(names(job.err, {"gap", "4 mm", "2 mm"})) << job.err;
    EXPECT_EQ(build()["options"]["wall-gap"], 3);
}

TEST_F(StandingCopies, FixedCopiesAreObstacles) {
    json job{
        {"format", "spectralpack/job"},
        {"version", 1},
        {"container", {{"size", {40, 40, 10}}}},
        {"gap", 0},
        {"fixed", {{{"mesh", "cube.stl"}, {"transform", {{0, -1, 0, 25}, {1, 0, 0, 15}, {0, 0, 1, 0}, {0, 0, 0, 1}}}}}},
        {"parts", {{{"mesh", "cube.stl"}, {"count", 16}}}},
        {"options", {{"output", "build.json"}, {"refine", true}}}};
    std::ofstream(at("job.json")) << job;
    const Ran ran = spectralpack({"pack", at("job.json")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = build();
    EXPECT_TRUE(packing["trays"][0]["placements"][0]["fixed"]);
    EXPECT_EQ(packing["trays"][0]["placements"][0]["transform"], job["fixed"][0]["transform"]);
    EXPECT_EQ(packing["trays"][0]["placements"].size(), 13u);  // 5 mm off the grid of cubes
    expect_sound();

    job["fixed"].push_back(
        {{"mesh", "cube.stl"}, {"transform", {{1, 0, 0, 20}, {0, 1, 0, 15}, {0, 0, 1, 0}, {0, 0, 0, 1}}}});
    std::ofstream(at("job.json")) << job;
    const Ran overlap = spectralpack({"pack", at("job.json")});
    EXPECT_EQ(overlap.status, 3);
    EXPECT_TRUE(names(overlap.err, {"1 cube", "2 cube"})) << "both that overlap";

    job["fixed"][1]["transform"][0][3] = 35;
    std::ofstream(at("job.json")) << job;
    const Ran outside = spectralpack({"pack", at("job.json")});
    EXPECT_EQ(outside.status, 3);
    EXPECT_TRUE(names(outside.err, {"2 cube", 5, "x"})) << "which, how far, and where";

    job["fixed"][1]["transform"][0] = {-1, 0, 0, 40};
    std::ofstream(at("job.json")) << job;
    const Ran mirror = spectralpack({"pack", at("job.json")});
    EXPECT_EQ(mirror.status, 3);
    EXPECT_TRUE(names(mirror.err, {"job.json", "fixed[1]", "mirror"}));
}

TEST_F(StandingCopies, CapsCountFixedCopies) {
    ASSERT_EQ(pack({at("slab.stl"), "--tray", "40x40x40"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");  // a quarter of it
    ASSERT_EQ(pack({at("cube.stl") + ":30", "--onto", at("old.json"), "--max-density", "0.35"}).status, 0);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 1 + 6u);
    EXPECT_NEAR(build()["metrics"]["density"], 0.25 + 6 / 64.0, 1e-9);
    ASSERT_EQ(pack({at("cube.stl") + ":60", "--onto", at("old.json"), "--max-layer-fill", "0.5", "--no-refine"}).status,
              0);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 1 + 3 * 8u) << "the layers of the slab are full";
    expect_sound();
}

TEST_F(StandingCopies, WithoutACeilingOnTopOfWhatStands) {
    stl("pole.stl", box_mesh({0, 0, 0}, {10, 10, 90}));
    ASSERT_EQ(pack({at("pole.stl"), at("slab.stl"), "--tray", "50x40x100", "--rotations", "none"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    for (const char* at_top : {"top", "bottom"}) {
        const Ran ran = pack({at("cube.stl") + ":40", "--onto", at("old.json"), "--tray", "50x40", "--open-height",
                              "--height-at", at_top, "--verify-with", "reference:5"});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const json packing = build();
        EXPECT_EQ(packing["trays"][0]["placements"].size(), 42u);
        EXPECT_TRUE(packing["trays"][0]["placements"][0]["fixed"]);
        EXPECT_EQ(packing["container"]["size"], json({50, 40, 90})) << "as high as the pole";
        double top = 0;
        for (std::size_t i = 2; i < 42; ++i) {
            top = std::max(top, packing["trays"][0]["placements"][i]["transform"][2][3].get<double>());
        }
        EXPECT_LE(top, 30) << "beside the pole and on the slab";
        expect_sound();
    }
    EXPECT_EQ(pack({at("cube.stl"), "--onto", at("old.json"), "--tray", "50x40", "--minimise", "box"}).status, 2);
}

}  // namespace
}  // namespace spectralpack::test
