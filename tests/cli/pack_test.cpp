#include <algorithm>
#include <fstream>
#include <sstream>

#include "cli/program.hpp"
#include "support/sanitized.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const std::string kSamples = (samples() / "samples.csv").string();

/// A tray small and coarse enough for the reference engine.
const std::vector<std::string> kSmall{"--tray", "110x85x70", "--voxel", "4"};

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// What must not depend on threads, engine or machine.
json placements(const fs::path& packing) {
    json list = json::array();
    const json document = read_json(packing);
    for (const json& placement : document["trays"][0]["placements"]) {
        list.push_back({placement["part"], placement["copy"], placement["orientation"], placement["transform"]});
    }
    return list;
}

/// A part would be lost, or the last build, lying among the parts, packed as one.
TEST(Pack, WritesOverNoFileThatItReads) {
    const TemporaryFolder folder;
    for (const char* name : {"box.stl", "clip.stl", "nut.stl"}) {
        fs::copy_file(samples() / name, folder / name);
    }
    std::ofstream(folder / "set.csv") << "mesh,count,scale\nbox.stl,1,1\n";
    fs::create_symlink(folder / "box.stl", folder / "link.stl");
    const auto at = [&](const char* name) { return (folder / name).string(); };
    const std::vector<std::vector<std::string>> wrong{
        {at("box.stl"), "-o", at("box.stl")},
        {at("box.stl"), "-o", at("link.stl")},
        {at("box.stl") + ":2", "-o", at("./box.stl")},
        {folder.path().string(), "-o", at("nut.stl")},
        {at("set.csv"), "-o", at("box.stl")},
        {at("set.csv"), "-o", at("set.csv")},
        {at("set.csv"), "--report", at("set.csv")},
        {at("nut.stl"), "--container", at("clip.stl"), "-o", at("clip.stl")},
        {at("nut.stl"), "--keep-out", at("clip.stl"), "-o", at("clip.stl")},
    };
    for (const auto& options : wrong) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack"} + options);
        EXPECT_EQ(ran.status, 2) << ran.err;
        EXPECT_TRUE(contains(ran.err, options.back() + ": that file is read")) << ran.err;
    }
    for (const char* name : {"box.stl", "clip.stl", "nut.stl"}) {
        EXPECT_EQ(read_text(folder / name), read_text(samples() / name));
    }
    // A build that is topped up may take the old one's place.
    for (const auto& more : {std::vector<std::string>{}, {"--onto", at("build.json")}}) {
        EXPECT_EQ(spectralpack(std::vector<std::string>{"pack", at("nut.stl"), "-o", at("build.json")} + more).status,
                  0);
    }
    EXPECT_EQ(read_json(folder / "build.json")["trays"][0]["placements"].size(), 2U);
    EXPECT_EQ(spectralpack({"plan", at("build.json"), "-o", at("nut.stl")}).status, 2);
    EXPECT_EQ(read_text(folder / "nut.stl"), read_text(samples() / "nut.stl"));
}

TEST(Pack, TellsOfWhatCannotBeWrittenBeforeItPacks) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "build.json");
    const Ran ran = spectralpack({"pack", kSamples, "-o", (folder / "build.json").string()});
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(contains(ran.err, "is a folder")) << ran.err;
    EXPECT_TRUE(ran.out.empty()) << ran.out;
}

TEST(Pack, WritesEveryKindOfFileAndCheckAgrees) {
    const TemporaryFolder folder;
    std::vector<std::string> call{"pack", kSamples, "--tray", "160x120x100", "--gap", "1"};
    for (const char* name : {"b.json", "b.3mf", "b.stl", "b.csv", "b.png"}) {
        call = call + std::vector<std::string>{"-o", (folder / name).string()};
    }
    const Ran ran = spectralpack(call);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "comes apart in"));
    for (const char* name : {"b.json", "b.3mf", "b.stl", "b.csv", "b.png"}) {
        EXPECT_TRUE(fs::exists(folder / name)) << name;
        EXPECT_GT(fs::file_size(folder / name), 1000u) << name;
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 5)
        << "temporary files were left behind";
    const json packing = read_json(folder / "b.json");
    EXPECT_GT(packing["metrics"]["placed"], 20);
    EXPECT_EQ(packing["metrics"]["placed"].get<std::size_t>() + packing["unplaced"].size(),
              packing["metrics"]["copies"].get<std::size_t>());
    const Ran checked = spectralpack({"check", (folder / "b.json").string()});
    EXPECT_EQ(checked.status, 0) << checked.out;
    EXPECT_TRUE(packing["trays"][0]["disassembly"]["complete"].get<bool>());
}

TEST(Pack, SaysLoudlyThatInterlockingIsNotCheckedWhenItIsOff) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--interlock", "off", "-o", file} + kSmall);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "INTERLOCKING IS NOT CHECKED"));
    EXPECT_TRUE(read_json(file)["trays"][0]["disassembly"].is_null());
    EXPECT_TRUE(contains(spectralpack({"check", file}).out, "interlocking: not checked"));
}

TEST(Pack, PlacementsDoNotDependOnThreadsMemoryOrEngine) {
    const TemporaryFolder folder;
    const std::vector<std::vector<std::string>> ways{{"--threads", "1"},
                                                     {"--threads", "3"},
                                                     {"--memory", "60M"},
#ifdef SPECTRALPACK_HAS_REFERENCE
                                                     {"--engine", "reference"}
#endif
    };
    json first;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const fs::path file = folder / (std::to_string(i) + ".json");
        const Ran ran =
            spectralpack(std::vector<std::string>{"pack", kSamples, "-o", file.string()} + kSmall + ways[i]);
        ASSERT_EQ(ran.status, 0) << ran.err;
        if (i == 0) {
            first = placements(file);
            EXPECT_GT(first.size(), 3u);
        }
        EXPECT_EQ(placements(file), first) << ways[i][0] << ' ' << ways[i][1];
    }
}

TEST(Pack, SeedDecidesTheRandomOrder) {
    const TemporaryFolder folder;
    const auto pack = [&](const char* name, const char* seed) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--order", "random", "--seed", seed,
                                                              "-o", (folder / name).string()} +
                                     kSmall);
        EXPECT_EQ(ran.status, 0) << ran.err;
        return placements(folder / name);
    };
    const json one = pack("1.json", "1");
    EXPECT_EQ(one, pack("1b.json", "1"));
    EXPECT_NE(one, pack("2.json", "2"));
}

#ifdef SPECTRALPACK_HAS_REFERENCE
TEST(Pack, VerifyWithReferenceFindsNoDifference) {
    const TemporaryFolder folder;
    const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--verify-with", "reference", "--progress",
                                                          "json", "-o", (folder / "b.json").string()} +
                                 kSmall);
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json metrics = read_json(folder / "b.json")["metrics"];
    EXPECT_EQ(metrics["verified"], metrics["searches"]);
    EXPECT_TRUE(contains(ran.err, "\"verified\": " + metrics["verified"].dump())) << ran.err;
}
#endif

TEST(Pack, RefinedCopiesLeaveTheGridAndKeepTheGapExactly) {
    const TemporaryFolder folder;
    for (const std::string gap : {"0", "0.3"}) {
        const auto pack = [&](const char* name, const char* refine) {
            const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, refine, "--gap", gap, "--wall-gap",
                                                                  "0.5", "-o", (folder / name).string()} +
                                         kSmall);
            EXPECT_EQ(ran.status, 0) << ran.err;
            const Ran checked = spectralpack({"check", (folder / name).string()});
            EXPECT_EQ(checked.status, 0) << checked.out;
            return checked.out;
        };
        pack("grid.json", "--no-refine");
        const std::string refined = pack("refined.json", "--refine");
        EXPECT_NEAR(read_json(folder / "refined.json")["metrics"]["min_gap"].get<double>(), std::stod(gap), 1e-3);
        EXPECT_NE(placements(folder / "grid.json"), placements(folder / "refined.json"));
        EXPECT_TRUE(contains(refined, "least gap: " + gap + " mm")) << refined;
    }
}

TEST(Pack, UnusableInputIsNamedAndTheRestIsPacked) {
    const TemporaryFolder folder;
    std::ofstream(folder / "broken.stl") << "not a mesh";
    const std::string json_file = (folder / "b.json").string();
    const std::vector<std::string> call =
        std::vector<std::string>{"pack", kSamples, (folder / "broken.stl").string(), (folder / "missing.stl").string(),
                                 "-o",   json_file} +
        kSmall;
    const Ran ran = spectralpack(call);
    EXPECT_EQ(ran.status, 3) << ran.err;
    EXPECT_TRUE(contains(ran.err, "broken.stl")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "missing.stl: no such file")) << ran.err;
    const json packing = read_json(json_file);
    EXPECT_GT(packing["metrics"]["placed"], 0);
    EXPECT_TRUE(std::any_of(packing["unplaced"].begin(), packing["unplaced"].end(),
                            [](const json& entry) { return entry["reason"] == "unusable"; }));
    EXPECT_EQ(spectralpack(call + std::vector<std::string>{"--skip-unusable"}).status, 0);
    EXPECT_EQ(spectralpack({"check", json_file}).status, 0);
}

TEST(Pack, NothingUsableExitsWithThree) {
    const TemporaryFolder folder;
    std::ofstream(folder / "broken.stl") << "not a mesh";
    const Ran ran = spectralpack({"pack", (folder / "broken.stl").string(), "-o", (folder / "b.json").string()});
    EXPECT_EQ(ran.status, 3);
    EXPECT_FALSE(fs::exists(folder / "b.json"));
}

TEST(Pack, LeftOverCopiesFailOnlyWhereAllAreRequired) {
    const std::vector<std::string> call = std::vector<std::string>{"pack", kSamples} + kSmall;
    const Ran ran = spectralpack(call);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "left over")) << ran.out;
    EXPECT_EQ(spectralpack(call + std::vector<std::string>{"--require-all"}).status, 5);
}

TEST(Pack, APartTooLargeForTheTrayIsNamedAndListed) {
    const TemporaryFolder folder;
    const Ran ran = spectralpack({"pack", kSamples, "--tray", "60x40x30", "-o", (folder / "b.json").string()});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "in none of the 24 orientations")) << ran.err;
    const json unplaced = read_json(folder / "b.json")["unplaced"];
    EXPECT_TRUE(std::any_of(unplaced.begin(), unplaced.end(),
                            [](const json& entry) { return entry["reason"] == "too_large"; }));
}

TEST(Pack, TooLittleMemoryIsRefusedWithTheVoxelSizeThatFits) {
    const Ran ran = spectralpack({"pack", kSamples, "--voxel", "0.25", "--memory", "100M"});
    EXPECT_EQ(ran.status, 4) << ran.err;
    const auto at = ran.err.find("--voxel ", ran.err.find("allowed"));
    ASSERT_NE(at, std::string::npos) << ran.err;
    const std::string voxel = ran.err.substr(at + 8, ran.err.find(' ', at + 8) - at - 8);
    EXPECT_EQ(spectralpack({"pack", kSamples, "--voxel", voxel, "--memory", "100M", "--dry-run"}).status, 0);
    EXPECT_GT(std::stod(voxel), 0.25);
}

TEST(Pack, DryRunTellsAndWritesNothing) {
    const TemporaryFolder folder;
    const Ran ran = spectralpack({"pack", kSamples, "--dry-run", "-o", (folder / "b.json").string()});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "240 x 123 x 100 voxels")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "searches"));
    EXPECT_TRUE(contains(ran.out, "memory"));
    EXPECT_TRUE(contains(ran.out, "time       about ")) << ran.out;
    EXPECT_FALSE(fs::exists(folder / "b.json"));
}

TEST(Pack, PlansTheMemoryThatWaysOutTake) {
    const auto megabytes = [](std::vector<std::string> options) {
        std::vector<std::string> arguments{"pack", kSamples, "--voxel", "1", "--wall-gap", "2", "--memory", "1M"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ran ran = spectralpack(arguments);
        EXPECT_EQ(ran.status, 4) << ran.err;
        const std::string before = "needs about ";
        const std::size_t at = ran.err.find(before);
        return at == std::string::npos ? 0 : std::stoi(ran.err.substr(at + before.size()));
    };
    const int off = megabytes({"--interlock", "off"}), place = megabytes({"--interlock", "place"});
    EXPECT_GT(off, 0);
    EXPECT_GT(place, off);
    EXPECT_GT(megabytes({"--interlock", "post"}), place) << "what links keep";
    EXPECT_GT(megabytes({"--interlock", "place", "--physical"}), place) << "walls all round";
}

TEST(Pack, PlansAboutTheMemoryThatARunTakes) {
    if (kSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
    const TemporaryFolder folder;
    for (const std::vector<std::string>& options : std::initializer_list<std::vector<std::string>>{
             {}, {"--detail", "4"}, {"--rotations", "45"}, {"--rotations", "45", "--detail", "1"}}) {
        const std::vector<std::string> call =
            std::vector<std::string>{"pack", kSamples,      "--tray",      "160x120x100", "--voxel",   "1", "--gap",
                                     "1",    "--no-refine", "--interlock", "off",         "--threads", "2"} +
            options;
        const Ran plan = spectralpack(call + std::vector<std::string>{"--dry-run"});
        ASSERT_EQ(plan.status, 0) << plan.err;
        const std::string before = "memory     about ";
        const std::size_t at = plan.out.find(before);
        ASSERT_NE(at, std::string::npos) << plan.out;
        std::istringstream text(plan.out.substr(at + before.size()));
        double planned = 0;
        std::string unit;
        text >> planned >> unit;
        planned *= unit == "GB," ? 1e9 : 1e6;
        const Ran ran = spectralpack(call + std::vector<std::string>{"-o", (folder / "b.json").string()});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const double taken = read_json(folder / "b.json")["metrics"]["peak_memory"];
        EXPECT_GT(planned, 0.8 * taken) << testing::PrintToString(options);
        EXPECT_LT(planned, 3 * taken) << testing::PrintToString(options);
    }
}

TEST(Pack, DryRunOfALongJobSaysHowMuchOfItItTried) {
    const Ran ran = spectralpack(
        {"pack", kSamples + ":20", "--tray", "400x300x200", "--voxel", "1", "--rotations", "45", "--dry-run"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "of the copies were tried to see") || contains(ran.out, "more than")) << ran.out;
}

/// A job that runs for many seconds.
std::vector<std::string> long_job(const fs::path& output) {
    return {"pack", kSamples + ":20", "--tray", "400x300x200", "--voxel",      "1", "--rotations",
            "45",   "--progress",     "json",   "-o",          output.string()};
}

TEST(Pack, CtrlCWritesTheBestSoFarAndExitsWith130) {
    const TemporaryFolder folder;
    const Ran ran = spectralpack(long_job(folder / "b.json"), "\"phase\": \"search\", \"done\": 3");
    EXPECT_EQ(ran.status, 130) << ran.err;
    const json packing = read_json(folder / "b.json");
    EXPECT_GE(packing["metrics"]["placed"], 1);
    EXPECT_EQ(packing["unplaced"].back()["reason"], "stopped");
    EXPECT_EQ(spectralpack({"check", (folder / "b.json").string()}).status, 0);
}

TEST(Pack, ATimeLimitEndsWithStatusZero) {
    const TemporaryFolder folder;
    std::vector<std::string> call = long_job(folder / "b.json");
    call.insert(call.end(), {"--time-limit", "1.5"});
    const Ran ran = spectralpack(call);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "Time limit"));
    EXPECT_EQ(read_json(folder / "b.json")["unplaced"].back()["reason"], "stopped");
}

TEST(Pack, AFailingOutputDoesNotKeepTheOthersFromBeingWritten) {
    const TemporaryFolder folder;
    const std::string too_long = (folder / (std::string(300, 'x') + ".json")).string();
    const Ran ran = spectralpack(
        std::vector<std::string>{"pack", kSamples, "-o", too_long, "-o", (folder / "b.csv").string()} + kSmall);
    EXPECT_EQ(ran.status, 4) << ran.err;
    EXPECT_TRUE(contains(ran.err, too_long)) << ran.err;
    EXPECT_TRUE(fs::exists(folder / "b.csv"));
}

TEST(Pack, JsonOnStandardOutputIsThePacking) {
    const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--json"} + kSmall);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(json::parse(ran.out)["format"], "spectralpack/packing");
}

}  // namespace
}  // namespace spectralpack::test
