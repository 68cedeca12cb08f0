/// Container meshes that hold something: what they hold is filled.

#include <algorithm>

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Vessels : public WholeJob {
  protected:
    Vessels() { stl("die.stl", cube_mesh(8)); }

    const std::string mug_ = (samples() / "mug.stl").string();
};

TEST_F(Vessels, ACupIsFilledInside) {
    const Ran ran = pack({at("die.stl") + ":12", "--container", mug_});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {"mug.stl", "vessel", "33.55 cm3", "42 mm", "--container-is solid", "11.5 cm3"}));
    const json packing = build();
    EXPECT_EQ(packing["metrics"]["placed"], 12);
    EXPECT_EQ(packing["container"]["is"], "vessel");
    EXPECT_EQ(packing["container"]["physical"], true);
    EXPECT_NEAR(packing["trays"][0]["density"], 12 * 512 / 33550.0, 1e-3) << "of what it holds";
    expect_sound();
    // In a picture the cup is seen.
    EXPECT_EQ(spectralpack({"render", at("build.json"), "-o", at("build.png")}).status, 0);
    // And more on top of what is in it, in the same cup.
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    const Ran more = pack({at("die.stl") + ":3", "--onto", at("old.json")});
    ASSERT_EQ(more.status, 0) << more.err;
    EXPECT_EQ(build()["metrics"]["placed"], 15);
    EXPECT_EQ(build()["container"], packing["container"]);
    expect_sound();
}

TEST_F(Vessels, ACopyInTheWallIsFound) {
    ASSERT_EQ(pack({at("die.stl"), "--container", mug_}).status, 0);
    json packing = build();
    json& transform = packing["trays"][0]["placements"][0]["transform"];
    transform[0][3] = 0;  // out of the cup's room
    std::ofstream(at("build.json")) << packing;
    const json findings = check_report(at("build.json"), 1)["findings"];
    EXPECT_TRUE(std::ranges::any_of(findings, [](const json& finding) { return finding["kind"] == "outside"; }))
        << findings;
}

TEST_F(Vessels, WhatIsSaidDecides) {
    // In its wall is no room for a die: nothing is placed, and only --json says more.
    const Ran solid = pack({at("die.stl"), "--container", mug_, "--container-is", "solid", "--json"});
    const json container = json::parse(solid.out)["container"];
    EXPECT_TRUE(names(solid.err, {"mug.stl", "11.5 cm3", "--container-is vessel", "33.55 cm3"}));
    EXPECT_EQ(container["is"], "solid");
    EXPECT_EQ(container["physical"], false);
    const Ran told = pack({at("die.stl"), "--container", mug_, "--container-is", "solid"});
    EXPECT_EQ(told.status, 6);
    EXPECT_TRUE(names(told.out, {"does not fit into the container's walls"}));
    EXPECT_FALSE(contains(told.out, "--trays")) << "another tray is no larger";
    EXPECT_FALSE(contains(told.out, in_words(UnplacedReason::no_place)));
    // A block with a dimple is a block, unless something else is said.
    Mesh block = cube_mesh(40);
    stl("block.stl", block);
    EXPECT_EQ(pack({at("die.stl"), "--container", at("block.stl")}).status, 0);
    EXPECT_EQ(build()["container"]["is"], "solid");
    const Ran none = pack({at("die.stl"), "--container", at("block.stl"), "--container-is", "vessel"});
    EXPECT_EQ(none.status, 3);
    EXPECT_TRUE(names(none.err, {"block.stl", "holds nothing"}));
    EXPECT_EQ(pack({at("die.stl"), "--container-is", "vessel"}).status, 2) << "without a mesh";
    EXPECT_EQ(pack({at("die.stl"), "--container", mug_, "--container-is", "cup"}).status, 2);
}

TEST_F(Vessels, AJobFileSaysItToo) {
    const auto packed_as = [&](const char* is) {
        std::ofstream(at("job.json")) << json{{"format", "spectralpack/job"},
                                              {"version", 1},
                                              {"container", {{"mesh", mug_}, {"is", is}}},
                                              {"parts", {{{"mesh", "die.stl"}}}}};
        const Ran ran = pack({at("job.json"), "--json"});
        EXPECT_EQ(ran.status, is == std::string("vessel") ? 0 : 6) << ran.err;  // a wall is too thin for a die
        return json::parse(ran.out)["container"]["is"];
    };
    EXPECT_EQ(packed_as("vessel"), "vessel");
    EXPECT_EQ(packed_as("solid"), "solid");
}

}  // namespace
}  // namespace spectralpack::test
