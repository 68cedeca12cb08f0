/// What is packed beside the plain case: parts that keep to orientations of their own, packings without a ceiling,
/// least boxes, filled trays, capped ones.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "cli/program.hpp"
#include "formats/packing_file.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class PackModes : public testing::Test {
  protected:
    void stl(const std::string& name, const Mesh& mesh) { write_stl(mesh, folder_ / name); }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    /// Packs, checks, and returns the packing.
    json packed(const std::vector<std::string>& arguments, const std::string& name = "build.json") {
        const Ran ran =
            spectralpack(std::vector<std::string>{"pack"} + arguments + std::vector<std::string>{"-o", at(name)});
        EXPECT_EQ(ran.status, 0) << ran.err;
        out_ = ran.out;
        err_ = ran.err;
        const Ran checked = spectralpack({"check", at(name)});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
        const json packing = read_json(folder_ / name);
        expect_phases_apart(packing);
        return packing;
    }

    TemporaryFolder folder_;
    std::string out_, err_;
};

Vec3 row_z(const json& placement) {
    const json& row = placement["transform"][2];
    return {row[0], row[1], row[2]};
}

TEST_F(PackModes, PartsKeepToTheirOrientations) {
    stl("rod.stl", box_mesh({0, 0, 0}, {30, 6, 4}));
    const json words[] = {"fixed", "upright", json{{"axes", {"+x"}}}, json{{"axes", {"-y"}}, {"yaw", 180}},
                          json{{"matrices", {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}}}};
    json job = {{"format", "spectralpack/job"},
                {"version", 1},
                {"container", {{"size", {70, 50, 40}}}},
                {"gap", 0},
                {"parts", json::array()},
                {"options", {{"rotations", "45+box"}}}};
    for (const json& word : words) {
        job["parts"].push_back({{"mesh", "rod.stl"}, {"count", 3}, {"orientations", word}});
    }
    std::ofstream(at("job.json")) << job;
    const json packing = packed({at("job.json")});
    ASSERT_EQ(packing["metrics"]["placed"], 15);
    const Vec3 up[] = {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    const int most[] = {1, 8, 8, 2, 1};
    for (const json& placement : packing["trays"][0]["placements"]) {
        const std::size_t part = placement["part"];
        EXPECT_EQ(row_z(placement), up[part]) << placement;
        EXPECT_LT(placement["orientation"], most[part]);
        EXPECT_EQ(packing["parts"][part]["orientations"],
                  part == 2 ? (json{{"axes", {"+x"}}, {"yaw", nullptr}}) : words[part]);
        if (part == 4) {
            EXPECT_EQ(placement["transform"][0][1], -1);
        }
    }
}

TEST_F(PackModes, APartThatItsOrientationsKeepOutIsNamed) {
    stl("rod.stl", box_mesh({0, 0, 0}, {30, 6, 4}));
    stl("die.stl", cube_mesh(5));
    const json job = {{"format", "spectralpack/job"},
                      {"version", 1},
                      {"container", {{"size", {20, 20, 40}}}},
                      {"parts",
                       {{{"mesh", "rod.stl"}, {"orientations", "upright"}},
                        {{"mesh", "rod.stl"}, {"orientations", {{"axes", {"+x"}}}}},
                        {{"mesh", "die.stl"}}}}};
    std::ofstream(at("job.json")) << job;
    const json packing = packed({at("job.json")});
    EXPECT_EQ(packing["metrics"]["placed"], 2);
    EXPECT_EQ(packing["unplaced"][0]["part"], 0);
    EXPECT_EQ(packing["unplaced"][0]["reason"], "too_large");
    EXPECT_TRUE(names(err_, {"rod", 30, 20, "orientations"}));
}

TEST_F(PackModes, BoxFramesLetATurnedBoxLieDown) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    const Mat3 about_x{{Vec3{1, 0, 0}, Vec3{0, c, -s}, Vec3{0, s, c}}};
    const Mat3 about_z{{Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}}};
    stl("skew.stl", transformed(box_mesh({0, 0, 0}, {30, 20, 4}), {about_x * about_z, {}}));
    const std::vector<std::string> call{at("skew.stl:4"), "--tray", "64x44", "--open-height", "--gap", "0"};
    EXPECT_GT(packed(call)["trays"][0]["height"], 8);
    for (const char* rotations : {"90+box", "none+box"}) {
        const json packing = packed(call + std::vector<std::string>{"--rotations", rotations});
        EXPECT_NEAR(packing["trays"][0]["height"], 4, 1e-4) << rotations;
    }
}

TEST_F(PackModes, OpenHeightPlacesEverythingAndSaysHowHigh) {
    const json packing = packed({kSamples, "--tray", "90x80", "--open-height", "--gap", "1", "--wall-gap", "1.5"});
    const json& tray = packing["trays"][0];
    EXPECT_EQ(packing["metrics"]["placed"], packing["metrics"]["copies"]);
    EXPECT_TRUE(packing["unplaced"].empty());
    EXPECT_EQ(packing["container"]["open_height"], true);
    EXPECT_EQ(packing["container"]["size"], json({90, 80, tray["height"]}));
    EXPECT_EQ(packing["options"]["tray"], json({90, 80, 90})) << "the reference height: the longer side";
    EXPECT_EQ(packing["options"]["height-at"], "top");
    double volume = 0;
    for (const json& placement : tray["placements"]) {
        volume += packing["parts"][placement["part"].get<std::size_t>()]["volume"].get<double>();
    }
    EXPECT_NEAR(tray["density"], volume / (90.0 * 80 * tray["height"].get<double>()), 1e-12);
    // The same, higher than a box that would just hold it: the ceiling pulls at copies below it, but not here.
    EXPECT_EQ(packed({kSamples, "--tray", "90x80x300", "--open-height", "--gap", "1", "--wall-gap", "1.5"},
                     "other.json")["trays"][0]["placements"],
              tray["placements"]);
    EXPECT_TRUE(names(out_, {tray["height"].get<double>(), "mm"}));
}

TEST_F(PackModes, OpenHeightIsTheSameForEveryEngine) {
#ifndef SPECTRALPACK_HAS_REFERENCE
    GTEST_SKIP() << "this build has no reference engine";
#else
    const json packing = packed(
        {kSamples, "--tray", "100x90", "--open-height", "--voxel", "4", "--verify-with", "reference", "--refine"});
    EXPECT_GE(packing["metrics"]["verified"], packing["metrics"]["copies"]) << "copies put back are searched for again";
#endif
}

TEST_F(PackModes, TheLeastBoxIsSmallerThanThatOfASquareTray) {
    const double open =
        packed({kSamples, "--tray", "160x160", "--open-height", "--voxel", "4"})["trays"][0]["density_bounding_box"];
    const json packing = packed({kSamples, "--tray", "160x160", "--minimise", "box", "--voxel", "4"});
    EXPECT_EQ(packing["metrics"]["placed"], packing["metrics"]["copies"]);
    EXPECT_GT(packing["trays"][0]["density_bounding_box"], open);
    EXPECT_LE(packing["container"]["size"][0], 160);
    // What is cut short is the best so far, and whole; before anything is placed it is nothing.
    const auto cut = [&](const char* seconds) {
        return spectralpack({"pack", kSamples, "--tray", "160x160", "--minimise", "box", "--voxel", "4", "--time-limit",
                             seconds, "-o", at("cut.json")});
    };
    EXPECT_EQ(cut("0").status, 6);
    EXPECT_FALSE(std::filesystem::exists(at("cut.json")));
    const Ran ran = cut("1");
    if (ran.status == 6) GTEST_SKIP() << "this machine places nothing in a second";
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(spectralpack({"check", at("cut.json")}).status, 0);
}

TEST_F(PackModes, FillingTakesAsManyAsFitInTheirShares) {
    stl("die.stl", cube_mesh(10));
    stl("rod.stl", box_mesh({0, 0, 0}, {20, 10, 10}));
    const json dice = packed({at("die.stl"), "--tray", "50x40x30", "--gap", "0", "--fill"});
    EXPECT_EQ(dice["metrics"]["placed"], 60);
    EXPECT_EQ(dice["parts"][0]["count"], 60);
    EXPECT_EQ(dice["parts"][0]["share"], 1);
    EXPECT_TRUE(dice["unplaced"].empty());
    const json both = packed({at("die.stl:2"), at("rod.stl:1"), "--tray", "80x60x40", "--gap", "0", "--fill"});
    const int n_dice = both["parts"][0]["count"], rods = both["parts"][1]["count"];
    EXPECT_EQ(n_dice + 2 * rods, 192) << "dice fill every hole";
    EXPECT_NEAR(static_cast<double>(n_dice) / rods, 2, 0.2);
    EXPECT_TRUE(names(out_, {"die", n_dice, 2, "rod", rods, 1})) << "counts and shares";
}

TEST_F(PackModes, FillingGivesLargePartsTheirShare) {
    stl("die.stl", cube_mesh(10));
    stl("crate.stl", cube_mesh(60));
    const std::vector<std::string> tray{"--tray", "200x200x200", "--fill"};
    const int alone = packed(tray + std::vector<std::string>{at("crate.stl")})["metrics"]["placed"];
    EXPECT_EQ(alone, 27);
    const json both = packed(tray + std::vector<std::string>{at("crate.stl"), at("die.stl:3")});
    const int crates = both["parts"][0]["count"], dice = both["parts"][1]["count"];
    EXPECT_EQ(crates, alone) << "dice stand in the way of crates";
    EXPECT_GT(dice, 3 * crates);
    EXPECT_TRUE(names(out_, {"1 : ", "for the 1 : 3 asked", "crate found a free place"})) << out_;
}

TEST_F(PackModes, CapsAreKeptAndSaid) {
    const std::vector<std::string> call{kSamples, "--tray", "110x90x100", "--voxel", "4"};
    const json thin = packed(call + std::vector<std::string>{"--max-density", "0.1"});
    EXPECT_LE(thin["trays"][0]["density"], 0.1);
    EXPECT_GT(thin["trays"][0]["density"], 0.08);
    EXPECT_TRUE(names(thin["unplaced"][0]["detail"], {10, "%"}));
    EXPECT_TRUE(names(out_, {10, "%"}));
    for (const char* refine : {"--no-refine", "--refine"}) {
        const json flat = packed(call + std::vector<std::string>{"--max-layer-fill", "0.2", refine});
        const std::vector<double> area = flat["trays"][0]["layers"]["area"];
        const double fullest = *std::max_element(area.begin(), area.end()) / (110 * 90);
        EXPECT_LE(fullest, 0.2 + 1e-9) << refine;
        EXPECT_GT(fullest, 0.15) << refine;
        EXPECT_TRUE(names(out_, {20, 100 * fullest, "%"}));
    }
}

TEST_F(PackModes, WhatDoesNotGoTogetherIsWrongUsage) {
    const std::vector<std::vector<std::string>> wrong{
        {"--tray", "100x90"},
        {"--fill", "--open-height"},
        {"--fill", "--trays", "2"},
        {"--open-height", "--trays", "all"},
        {"--open-height", "--keep-out", "0,0,0,5,5,5"},
        {"--max-density", "0.3", "--open-height"},
        {"--max-density", "30"},
        {"--max-layer-fill", "0"},
        {"--minimise", "height"},
        {"--rotations", "50"},
        {"--rotations", "icosahedron:9"},
        {"--rotations", "+box"},
        {"--open-height", "--height-at", "bottom", "--height-penalty", "0"}};
    expect_refused(wrong, kSamples);
}

}  // namespace
}  // namespace spectralpack::test
