/// Jobs of many trays, and the trays of known printers.

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Trays : public WholeJob {};

TEST_F(Trays, FillsAsManyTraysAsItTakes) {
    const std::string model = at("build.3mf");
    const Ran ran = pack({at("cube.stl") + ":20", "--tray", "20x20x20", "--trays", "all", "-o", model, "-o",
                          at("build.csv"), "--report", at("r.html")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {20, 3, 100, 50})) << "copies, trays and how full they are";
    const json packing = build();
    ASSERT_EQ(packing["trays"].size(), 3u);
    EXPECT_EQ(packing["trays"][0]["placements"].size(), 8u);
    EXPECT_EQ(packing["trays"][2]["placements"].size(), 4u);
    EXPECT_NEAR(packing["trays"][2]["density"], 0.5, 1e-9);
    EXPECT_NEAR(packing["metrics"]["density"], 2.5 / 3, 1e-9);
    EXPECT_EQ(packing["metrics"]["placed"], 20);
    EXPECT_EQ(packing["options"]["trays"], "all");
    expect_sound();
    for (const char* name : {"build-1.3mf", "build-2.3mf", "build-3.3mf", "build.3mf", "build-3.csv"}) {
        EXPECT_TRUE(fs::exists(folder_ / name)) << name;
        EXPECT_TRUE(names(ran.out, {at(name)}));
    }
    EXPECT_FALSE(fs::exists(folder_ / "build-4.3mf"));
    EXPECT_TRUE(names(read_text(folder_ / "r.html"), {"20 of 20 asked", "filled, by volume"}));
}

TEST_F(Trays, LeavesOverWhatTheTraysDoNotHold) {
    const Ran ran = pack({at("cube.stl") + ":20", "--tray", "20x20x20", "--trays", "2"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(build()["trays"].size(), 2u);
    EXPECT_EQ(build()["unplaced"].size(), 4u);
    expect_sound();
}

TEST_F(Trays, PriorityAndDueDateDecideWhoGoesFirst) {
    std::ofstream(at("job.json")) << json{{"format", "spectralpack/job"},
                                          {"version", 1},
                                          {"container", {{"size", {40, 40, 10}}}},
                                          {"trays", "all"},
                                          {"gap", 0},
                                          {"parts",
                                           {{{"name", "late"}, {"mesh", "slab.stl"}},
                                            {{"name", "soon"}, {"mesh", "slab.stl"}, {"due", "2026-11-30"}},
                                            {{"name", "small"}, {"mesh", "cube.stl"}, {"priority", 1}}}}};
    ASSERT_EQ(spectralpack({"pack", at("job.json"), "-o", at("build.json")}).status, 0);
    const json packing = build();
    ASSERT_EQ(packing["trays"].size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto part = packing["trays"][i]["placements"][0]["part"].get<std::size_t>();
        EXPECT_EQ(packing["parts"][part]["name"], (std::vector{"small", "soon", "late"}[i]));
    }
}

TEST_F(Trays, OneThatStaysEmptyIsToldAndTheOthersAreKept) {
    stl("angle.stl", angle_mesh());
    // The slab fits the container's box, not the container.
    const Ran ran = pack({at("slab.stl"), at("cube.stl"), "--container", at("angle.stl"), "--trays", "all"});
    EXPECT_EQ(ran.status, 0) << "no file is bad";
    EXPECT_TRUE(names(ran.err, {"tray", 2, "slab"}));
    EXPECT_EQ(build()["trays"].size(), 1u);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 1u);
    EXPECT_EQ(build()["unplaced"].size(), 1u);
}

TEST_F(Trays, PrintersAreListedAndUsed) {
    const Ran list = spectralpack({"pack", "--printer", "list"});
    EXPECT_EQ(list.status, 0);
    EXPECT_TRUE(names(list.out, {"hp-mjf-5200", "unverified"}));
    ASSERT_EQ(
        spectralpack({"pack", at("cube.stl"), "--printer", "formlabs-fuse1", "--gap", "1", "-o", at("build.json")})
            .status,
        0);
    EXPECT_EQ(build()["container"]["size"], json({165, 165, 300}));
    EXPECT_EQ(build()["options"]["printer"], "formlabs-fuse1");
    EXPECT_EQ(build()["options"]["gap"], 1);
    EXPECT_EQ(build()["options"]["wall-gap"], 3);
    EXPECT_EQ(spectralpack({"pack"}).status, 2);
}

}  // namespace
}  // namespace spectralpack::test
