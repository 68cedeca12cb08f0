/// Orders, restarts and beam search, end to end.

#include <cmath>
#include <fstream>
#include <map>

#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

class Orders : public testing::Test {
  protected:
    json packed(std::vector<std::string> options, const std::string& tray = "80x70x50") {
        const Ran ran = spectralpack(
            std::vector<std::string>{"pack", kSamples, "--tray", tray, "--voxel", "4", "-o", at("build.json")} +
            options);
        EXPECT_EQ(ran.status, 0) << ran.err;
        out_ = ran.out;
        err_ = ran.err;
        const Ran checked = spectralpack({"check", at("build.json")});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
        const json packing = read_json(folder_ / "build.json");
        expect_phases_apart(packing);
        return packing;
    }

    json on_grid(std::vector<std::string> options, const std::string& tray = "80x70x50") {
        options.insert(options.end(), {"--detail", "1", "--no-refine", "--interlock", "off"});
        return packed(options, tray);
    }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    TemporaryFolder folder_;
    std::string out_, err_;
};

const json& placements(const json& packing) { return packing["trays"][0]["placements"]; }

TEST_F(Orders, ByVolumeAndByBothSizesTheLargestComesFirst) {
    std::map<std::string, double> box;  // by the part's name
    const json meshes = json::parse(spectralpack({"inspect", "--json", samples().string()}).out);
    for (const json& file : meshes["files"]) {
        const json& object = file["objects"][0];
        const std::vector<double> size = object["size"];
        box[object["name"]] = size[0] * size[1] * size[2];
    }
    for (const std::string order : {"volume", "mixed"}) {
        const json packing = on_grid({"--order", order}, "160x120x100");
        EXPECT_EQ(packing["options"]["order"], order);
        EXPECT_GT(placements(packing).size(), 5u);
        double last = 1e300;
        for (const json& placement : placements(packing)) {
            const json& part = packing["parts"][placement["part"].get<std::size_t>()];
            const double volume = part["volume"];
            const double size = order == "volume" ? volume : std::sqrt(volume * box.at(part["name"]));
            EXPECT_LE(size, last * (1 + 1e-9)) << part["name"];
            last = size;
        }
    }
}

TEST_F(Orders, TheBestOfSeveralIsNeverWorseThanGreedy) {
    const double greedy = on_grid({})["metrics"]["density"];
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--restarts", "6"}, {"--beam", "3"}, {"--beam", "3", "--restarts", "3"}}) {
        const json best = on_grid(more);
        EXPECT_GE(best["metrics"]["density"].get<double>(), greedy - 1e-12) << more[0];
        EXPECT_GT(best["metrics"]["orders"], 1);
        EXPECT_TRUE(names(out_, {best["metrics"]["orders"].get<int>()}));
        EXPECT_EQ(placements(on_grid(more + std::vector<std::string>{"--threads", "1"})), placements(best))
            << "threads change the answer";
    }
    EXPECT_EQ(placements(on_grid({"--restarts", "1", "--beam", "1"})), placements(on_grid({})));
}

TEST_F(Orders, WithoutACeilingTheLowestWins) {
    const double greedy = on_grid({"--open-height"}, "70x60")["trays"][0]["height"];
    for (const char* option : {"--restarts", "--beam"}) {
        const json best = on_grid({"--open-height", option, "5"}, "70x60");
        EXPECT_LE(best["trays"][0]["height"].get<double>(), greedy + 1e-9) << option;
        EXPECT_EQ(best["metrics"]["placed"], best["metrics"]["copies"]);
    }
}

TEST_F(Orders, TheWinnerIsRefinedAndTakenApart) {
    const json packing = packed({"--restarts", "3", "--beam", "2", "--gap", "1", "--progress", "json"});
    EXPECT_EQ(packing["trays"][0]["disassembly"]["complete"], true);
    EXPECT_EQ(packing["metrics"]["orders"], 4);
    EXPECT_NEAR(packing["metrics"]["min_gap"], 1, 0.05);
    EXPECT_TRUE(reported([](const json& line) { return line.value("orders", 0) == 4; })(err_)) << err_;
}

TEST_F(Orders, SeveralTraysAndFixedCopiesGoWithThem) {
    for (const char* option : {"--restarts", "--beam"}) {
        const json trays = on_grid({option, "3", "--trays", "all"});
        EXPECT_EQ(trays["metrics"]["placed"], trays["metrics"]["copies"]) << option;
        EXPECT_GT(trays["trays"].size(), 1u);
    }
    const Ran first = spectralpack({"pack", kSamples, "--tray", "80x70x50", "--voxel", "4", "--order", "random",
                                    "--max-density", "0.1", "-o", at("first.json")});
    ASSERT_EQ(first.status, 0) << first.err;
    for (const char* option : {"--restarts", "--beam"}) {
        const Ran ran = spectralpack({"pack", kSamples, "--onto", at("first.json"), "--voxel", "4", option, "3",
                                      "--interlock", "off", "-o", at("topped.json")});
        EXPECT_EQ(ran.status, 0) << ran.err;
        EXPECT_EQ(spectralpack({"check", at("topped.json")}).status, 0);
    }
}

TEST_F(Orders, ATimeLimitLeavesTheBestSoFarAndTimeToFinishIt) {
    const json packing = packed({"--restarts", "1000000", "--time-limit", "3"});
    EXPECT_GT(packing["metrics"]["orders"], 1);
    EXPECT_LT(packing["metrics"]["orders"], 1000000);
    EXPECT_EQ(packing["trays"][0]["disassembly"]["complete"], true) << "half of the time is for the last packing";
    EXPECT_EQ(spectralpack({"pack", kSamples, "--restarts", "9", "--time-limit", "0", "-o", at("none.json")}).status, 6)
        << "nothing is placed by then";
}

TEST_F(Orders, AnInterruptLeavesTheBestSoFar) {
    const Ran ran = spectralpack({"pack", kSamples, "--tray", "80x70x50", "--voxel", "4", "--restarts", "1000000",
                                  "--progress", "json", "-o", at("cut.json")},
                                 reported([](const json& line) { return line.value("order", 0) >= 4; }));
    EXPECT_EQ(ran.status, 130) << ran.err;
    EXPECT_GE(read_json(folder_ / "cut.json")["metrics"]["orders"], 3);
    EXPECT_FALSE(placements(read_json(folder_ / "cut.json")).empty());
    EXPECT_EQ(spectralpack({"check", at("cut.json")}).status, 0);
}

TEST_F(Orders, JobFilesTakeThem) {
    std::ofstream(folder_ / "job.json") << json{
        {"format", "spectralpack/job"},
        {"version", 1},
        {"container", {{"size", {60, 50, 40}}}},
        {"parts", {{{"mesh", (samples() / "bracket.stl").string()}, {"count", 3}}}},
        {"options", {{"order", "mixed"}, {"restarts", 2}, {"beam", 2}}}};
    const Ran ran = spectralpack({"pack", at("job.json"), "--voxel", "4", "-o", at("job-build.json")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json options = read_json(folder_ / "job-build.json")["options"];
    EXPECT_EQ(options["order"], "mixed");
    EXPECT_EQ(options["restarts"], 2);
    EXPECT_EQ(options["beam"], 2);
}

TEST_F(Orders, WhatMakesNoSenseIsWrongUsage) {
    const std::vector<std::vector<std::string>> wrong{{"--restarts", "0"},
                                                      {"--restarts", "2000000"},
                                                      {"--beam", "0"},
                                                      {"--beam", "101"},
                                                      {"--order", "weight"},
                                                      {"--restarts", "2", "--fill"},
                                                      {"--beam", "2", "--fill"},
                                                      {"--restarts", "2", "--minimise", "box"},
                                                      {"--beam", "2", "--max-density", "0.3"},
                                                      {"--beam", "2", "--max-layer-fill", "0.3"}};
    expect_refused(wrong, kSamples);
}

}  // namespace
}  // namespace spectralpack::test
