/// Where height counts by default: the built program on jobs that leave room, and on trays that overflow.

#include <algorithm>

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Heights : public WholeJob {
  protected:
    Heights() { stl("tall.stl", box_mesh({0, 0, 0}, {20, 30, 195.7})); }

    json packed(const std::vector<std::string>& arguments) {
        const Ran ran = pack(arguments);
        EXPECT_EQ(ran.status, 0) << ran.err;
        expect_sound();
        return build();
    }
};

const std::vector<std::string> kPapersRule{"--height-at", "bottom", "--height-penalty", "auto"};

TEST_F(Heights, OnePartLiesOnTheFloorInTheNearCorner) {
    const std::vector<std::string> job{at("tall.stl"), "--tray", "480x245x200"};
    const json packing = packed(job), tray = packing["trays"][0];
    EXPECT_NEAR(tray["height"], 20, 1e-4);
    EXPECT_EQ(tray["height_at"], "top");
    EXPECT_EQ(packing["options"]["height-at"], "auto");
    for (const json& coordinate : tray["bounding_box"][0]) {
        EXPECT_NEAR(coordinate, 0, 1e-4);
    }
    const json papers = packed(job + kPapersRule)["trays"][0];
    EXPECT_NEAR(papers["height"], 195.7, 1e-3) << "the paper's rule stands it against the ceiling";
    EXPECT_EQ(papers["height_at"], "bottom");
}

TEST_F(Heights, ASmallJobIsLowAndTakesLittleOfTheFloor) {
    const json tray = packed({at("cube.stl") + ":9", at("slab.stl"), "--tray", "300x300x300"})["trays"][0];
    ASSERT_EQ(tray["placements"].size(), 10u);
    EXPECT_NEAR(tray["height"], 10, 1e-4);
    EXPECT_LE(tray["bounding_box"][1][0], 70);
    EXPECT_LE(tray["bounding_box"][1][1], 70);
}

TEST_F(Heights, TheLastTrayIsLow) {
    const json packing = packed({at("tall.stl") + ":11", "--tray", "60x40x200", "--trays", "all"});
    const json& trays = packing["trays"];
    ASSERT_EQ(trays.size(), 3u);
    EXPECT_EQ(trays[0]["placements"].size(), 4u);
    EXPECT_EQ(trays[2]["placements"].size(), 3u);
    stl("rod.stl", box_mesh({0, 0, 0}, {20, 20, 60}));
    const json rods = packed({at("rod.stl") + ":12", "--tray", "60x60x60", "--trays", "all"})["trays"];
    ASSERT_EQ(rods.size(), 2u);
    EXPECT_EQ(rods[0]["placements"].size(), 9u);
    EXPECT_NEAR(rods[1]["height"], 20, 1e-4) << "three of them, lying";
    EXPECT_EQ(rods[1]["height_at"], "top");
}

TEST_F(Heights, ATrayThatOverflowsIsPackedAsThePaperDoes) {
    const std::vector<std::string> job = std::vector<std::string>{kSamples} + kSmall;
    const json here = packed(job);
    ASSERT_FALSE(here["unplaced"].empty());
    EXPECT_EQ(here["trays"][0]["height_at"], "bottom");
    EXPECT_EQ(packed(job + kPapersRule)["trays"][0]["placements"], here["trays"][0]["placements"]);
}

TEST_F(Heights, APenaltyAsksForTheBottom) {
    const std::vector<std::string> job{at("tall.stl"), "--tray", "480x245x200", "--height-penalty", "4"};
    const json packing = packed(job);
    EXPECT_EQ(packing["options"]["height-at"], "bottom");
    EXPECT_EQ(packed(job + std::vector<std::string>{"--height-at", "bottom"})["trays"], packing["trays"]);
}

TEST_F(Heights, SameWhateverTheThreads) {
    const std::vector<std::string> job{"pack", kSamples, "--tray", "200x200x200", "-o", at("build.json"), "--threads"};
    json placements;
    for (const char* threads : {"1", "3"}) {
        ASSERT_EQ(spectralpack(job + std::vector<std::string>{threads}).status, 0);
        const json tray = build()["trays"][0];
        EXPECT_EQ(tray["height_at"], "top");
        if (!placements.is_null()) {
            EXPECT_EQ(tray["placements"], placements);
        }
        placements = tray["placements"];
    }
}

TEST_F(Heights, GoesWithWhatElseThereIs) {
    stl("vessel.stl", box_mesh({0, 0, 0}, {90, 70, 60}));
    ASSERT_EQ(pack({at("slab.stl"), "--tray", "100x100x60"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    const std::string cubes = at("cube.stl") + ":7";
    const std::vector<std::string> tray{cubes, "--tray", "100x100x60"};
    const std::vector<std::vector<std::string>> low{
        {cubes, "--onto", at("old.json")},
        {cubes, "--container", at("vessel.stl")},
        tray + std::vector<std::string>{"--keep-out", "30,0,0,40,100,60"},
        tray + std::vector<std::string>{"--keep-out", "30,0,0,40,100,60", "--physical"},
        tray + std::vector<std::string>{"--max-density", "0.5"},
        tray + std::vector<std::string>{"--max-layer-fill", "0.5"},
        tray + std::vector<std::string>{"--restarts", "2"},
        tray + std::vector<std::string>{"--beam", "2"},
        tray + std::vector<std::string>{"--interlock", "place"},
        tray + std::vector<std::string>{"--interlock", "off", "--no-refine"},
        tray + std::vector<std::string>{"--wall-gap", "2"},
        tray + std::vector<std::string>{"--trays", "2"},
        tray + std::vector<std::string>{"--open-height"},
        tray + std::vector<std::string>{"--height-at", "auto"}};
    for (const auto& job : low) {
        SCOPED_TRACE(job.back());
        const json packing = packed(job);
        const json& done = packing["trays"][0];
        EXPECT_GE(done["placements"].size(), 7u);
        EXPECT_EQ(done["height_at"], "top");
        EXPECT_LE(done["height"], 14);
    }
    EXPECT_EQ(packed(tray + std::vector<std::string>{"--minimise", "box"})["trays"][0]["height_at"], "top");
    const json filled = packed({at("cube.stl"), "--tray", "40x40x20", "--fill"});
    EXPECT_EQ(filled["trays"][0]["height_at"], "bottom") << "never roomy";
    EXPECT_EQ(filled["metrics"]["placed"], 32);
    const json topped = packed({cubes, "--onto", at("old.json"), "--trays", "2"});
    EXPECT_EQ(topped["trays"].size(), 1u);
}

}  // namespace
}  // namespace spectralpack::test
