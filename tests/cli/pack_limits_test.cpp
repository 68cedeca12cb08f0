/// What pack does at its limits: memory that is planned, dry runs, time limits, interrupts.

#include <algorithm>
#include <map>

#include "cli/running_program.hpp"
#include "formats/packing_file.hpp"
#include "support/sanitized.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

/// The amounts in `text` that are in one of `units`, each by its value.
std::vector<double> amounts_in(const std::string& text, const std::map<std::string, double>& units) {
    std::vector<double> found;
    for (const Quantity& quantity : quantities_in(text)) {
        const auto unit = units.find(quantity.unit);
        if (unit != units.end()) found.push_back(quantity.value * unit->second);
    }
    return found;
}

std::vector<double> bytes_in(const std::string& text) {
    return amounts_in(text, {{"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}});
}

std::vector<double> seconds_in(const std::string& text) {
    return amounts_in(text, {{"s", 1}, {"min", 60}, {"h", 3600}});
}

TEST(PackLimits, TooLittleMemoryIsRefusedWithTheVoxelSizeThatFits) {
    const Ran ran = spectralpack({"pack", kSamples, "--voxel", "0.25", "--memory", "100M"});
    EXPECT_EQ(ran.status, 4) << ran.err;
    EXPECT_TRUE(names(ran.err, {0.25, 100, "MB"}));
    const auto at = ran.err.rfind("--voxel ");
    ASSERT_NE(at, std::string::npos) << ran.err;
    const std::string voxel = ran.err.substr(at + 8, ran.err.find_first_not_of("0123456789.", at + 8) - at - 8);
    EXPECT_GT(std::stod(voxel), 0.25);
    EXPECT_EQ(spectralpack({"pack", kSamples, "--voxel", voxel, "--memory", "100M", "--dry-run"}).status, 0);
}

TEST(PackLimits, DryRunTellsAndWritesNothing) {
    const TemporaryFolder folder;
    const Ran ran = spectralpack({"pack", kSamples, "--dry-run", "-o", (folder / "b.json").string()});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {74, 480, 245, 200})) << "copies and container";
    EXPECT_TRUE(names(ran.out, {240, 123, 100, 2})) << "the grid";
    EXPECT_FALSE(bytes_in(ran.out).empty()) << ran.out;
    EXPECT_FALSE(seconds_in(ran.out).empty()) << ran.out;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(PackLimits, DryRunCountsWhatWouldBePacked) {
    const TemporaryFolder folder;
    const auto at = [&](const char* name) { return (folder / name).string(); };
    write_stl(cube_mesh(10), at("cube.stl"));
    write_stl(cube_mesh(500), at("large.stl"));
    const std::vector<std::string> tray{"--tray", "50x50x50", "--threads", "1"};
    const std::vector<std::string> parts{"pack", at("cube.stl") + ":3", at("large.stl") + ":5",
                                         at("nothing.stl") + ":7"};
    const Ran told = spectralpack(parts + tray + std::vector<std::string>{"--dry-run"});
    EXPECT_EQ(told.status, 3) << told.err;
    EXPECT_TRUE(told.out.starts_with("3 copies of 1 part would be packed")) << told.out;
    EXPECT_TRUE(names(told.out, {"left over", 12}));
    const Ran as_json = spectralpack(parts + tray + std::vector<std::string>{"--dry-run", "--json", "--skip-unusable"});
    EXPECT_EQ(as_json.status, 0);
    const nlohmann::json estimate = nlohmann::json::parse(as_json.out);
    EXPECT_EQ(estimate["copies"], 3);
    EXPECT_EQ(estimate["parts"], 1);
    EXPECT_EQ(estimate["left_over"], 12);
    EXPECT_EQ(estimate["container"], nlohmann::json({50, 50, 50}));
    EXPECT_EQ(estimate["unusable"].size(), 1u);
    EXPECT_GT(estimate["memory"], 0);
    // Copies that stand there already are not packed.
    ASSERT_EQ(spectralpack({"pack", at("cube.stl") + ":4", "--threads", "1", "--tray", "50x50x50", "-o", at("b.json")})
                  .status,
              0);
    const Ran more =
        spectralpack({"pack", at("cube.stl") + ":2", "--onto", at("b.json"), "--threads", "1", "--dry-run"});
    EXPECT_TRUE(more.out.starts_with("2 copies of 1 part would")) << more.out;
}

TEST(PackLimits, PlansTheMemoryThatWaysOutTake) {
    /// What is needed is more than what is allowed, or it would not be refused.
    const auto needed = [](const std::vector<std::string>& options) {
        const Ran ran = spectralpack(
            std::vector<std::string>{"pack", kSamples, "--voxel", "1", "--wall-gap", "2", "--memory", "1M"} + options);
        EXPECT_EQ(ran.status, 4) << ran.err;
        const std::vector<double> bytes = bytes_in(ran.err);
        EXPECT_EQ(bytes.size(), 2u) << ran.err;
        return bytes.empty() ? 0 : *std::max_element(bytes.begin(), bytes.end());
    };
    const double off = needed({"--interlock", "off"}), place = needed({"--interlock", "place", "--unpack", "any"});
    EXPECT_GT(off, 1e6);
    EXPECT_GT(place, off);
    EXPECT_GT(needed({"--interlock", "post", "--unpack", "any"}), place) << "what links keep";
    EXPECT_GT(needed({"--interlock", "place", "--unpack", "any", "--physical"}), place) << "walls all round";
    EXPECT_GT(needed({"--interlock", "place"}), place) << "the same, for the order from the top";
}

TEST(PackLimits, PlansAboutTheMemoryThatARunTakes) {
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
        const std::vector<double> bytes = bytes_in(plan.out);  // planned, and free
        ASSERT_FALSE(bytes.empty()) << plan.out;
        const double planned = *std::min_element(bytes.begin(), bytes.end());
        const Ran ran = spectralpack(call + std::vector<std::string>{"-o", (folder / "b.json").string()});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const double taken = read_json(folder / "b.json")["metrics"]["peak_memory"];
        EXPECT_GT(planned, 0.8 * taken) << testing::PrintToString(options);
        EXPECT_LT(planned, 3 * taken) << testing::PrintToString(options);
    }
}

TEST(PackLimits, DryRunOfALongJobEndsSoonAndSaysHowLongItTakes) {
    const Ran ran = spectralpack(
        {"pack", kSamples + ":20", "--tray", "400x300x200", "--voxel", "1", "--rotations", "45", "--dry-run"}, {},
        {0, 0, 300});
    EXPECT_EQ(ran.status, 0) << ran.err;
    const std::vector<double> seconds = seconds_in(ran.out);
    ASSERT_FALSE(seconds.empty()) << ran.out;
    EXPECT_GE(*std::max_element(seconds.begin(), seconds.end()), 3) << "more than it tried";
}

TEST(PackLimits, CtrlCWritesTheBestSoFarAndExitsWith130) {
    const TemporaryFolder folder;
    const Moment three_placed =
        reported([](const json& line) { return line.value("phase", "") == "search" && line["done"] >= 3; });
    const Ran ran = spectralpack(long_job(folder / "b.json"), three_placed);
    EXPECT_EQ(ran.status, 130) << ran.err;
    const json packing = read_json(folder / "b.json");
    EXPECT_GE(packing["metrics"]["placed"], 1);
    EXPECT_EQ(packing["unplaced"].back()["reason"], "not_tried");
    EXPECT_TRUE(check_report((folder / "b.json").string(), 0)["ok"]);
}

TEST(PackLimits, ATimeLimitEndsWithStatusZeroAndIsTold) {
    const TemporaryFolder folder;
    // One that has its first copies placed at once, and many to come.
    const Ran ran = spectralpack({"pack", kSamples + ":300", "--voxel", "1", "--trays", "all", "--time-limit", "5",
                                  "-o", (folder / "b.json").string()});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {"time limit"}));
    EXPECT_EQ(read_json(folder / "b.json")["unplaced"].back()["reason"], "not_tried");
}

}  // namespace
}  // namespace spectralpack::test
