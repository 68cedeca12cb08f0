/// --improve, --improve-steps and --goal, end to end.

#include <chrono>

#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

class ImproveRuns : public testing::Test {
  protected:
    Ran run(const std::vector<std::string>& options, const Moment& interrupt_when = {}) {
        Ran ran =
            spectralpack(std::vector<std::string>{"pack", kSamples, "--voxel", "4", "-o", at("build.json")} + options,
                         interrupt_when);
        if (std::filesystem::exists(folder_ / "build.json")) {
            EXPECT_EQ(spectralpack({"check", "--require-plan", at("build.json")}).status, 0);
        }
        return ran;
    }
    json result() const { return read_json(folder_ / "build.json"); }
    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    TemporaryFolder folder_;
};

const std::vector<std::string> kOpen{"--tray", "110x100", "--open-height"};

TEST_F(ImproveRuns, TheSummarySaysWhatWasGained) {
    const Ran ran = run(kOpen + std::vector<std::string>{"--improve-steps", "30"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json improvement = result()["metrics"]["improvement"];
    EXPECT_EQ(improvement["what"], "height");
    EXPECT_EQ(improvement["steps"], 30);
    EXPECT_LT(improvement["now"], improvement["before"]);
    EXPECT_TRUE(contains(ran.out, "Improved")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "mm lower than at first")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "30 orders tried")) << ran.out;
}

TEST_F(ImproveRuns, SecondsEndItAndItsStepsRepeatIt) {
    const Ran ran = run(kOpen + std::vector<std::string>{"--improve", "1", "--progress", "json"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json timed = result();
    const json improvement = timed["metrics"]["improvement"];
    EXPECT_GE(improvement["seconds"], 0.9);
    EXPECT_TRUE(reported([](const json& line) {
        return line.value("phase", "") == "improve" && line.value("what", "") == "height" && line.contains("now");
    })(ran.err));
    const Ran again =
        run(kOpen + std::vector<std::string>{"--improve-steps", std::to_string(improvement["steps"].get<int>())});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(result()["trays"][0]["placements"], timed["trays"][0]["placements"]);
}

TEST_F(ImproveRuns, TheRestOfTheTimeLimitIsUsed) {
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run(kOpen).status, 0);
    // What a slow machine needs for the whole run leaves it time to improve, too.
    const std::chrono::duration<double> once = std::chrono::steady_clock::now() - start;
    const int limit = static_cast<int>(4 + 3 * once.count());
    const Ran ran = run(kOpen + std::vector<std::string>{"--improve", "rest", "--time-limit", std::to_string(limit)});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = result();
    EXPECT_GE(packing["metrics"]["improvement"]["seconds"], 1);
    EXPECT_EQ(packing["options"]["improve"], "rest");
    EXPECT_EQ(packing["metrics"]["placed"], packing["metrics"]["copies"]);
}

TEST_F(ImproveRuns, GoesOnWithMoreSecondsWhereTheJournalIsKept) {
    const std::vector<std::string> kept{"--journal", at("j"), "--keep-journal"};
    ASSERT_EQ(run(kOpen + kept + std::vector<std::string>{"--improve", "1"}).status, 0);
    const json first = result();
    ASSERT_TRUE(std::filesystem::exists(folder_ / "j"));
    const Ran more = run(kOpen + kept + std::vector<std::string>{"--improve", "2"});
    ASSERT_EQ(more.status, 0) << more.err;
    const json second = result();
    EXPECT_GE(second["metrics"]["improvement"]["steps"], first["metrics"]["improvement"]["steps"]);
    EXPECT_LE(second["trays"][0]["height"], first["trays"][0]["height"]);
    EXPECT_GE(second["metrics"]["improvement"]["seconds"], 1.9);
    expect_refused({{"--improve", "1", "--keep-journal"}}, kSamples);
}

TEST_F(ImproveRuns, CtrlCWritesTheBestSoFar) {
    const Ran ran = run(kOpen + std::vector<std::string>{"--improve", "600", "--progress", "json"},
                        reported([](const json& line) { return line.value("phase", "") == "improve"; }));
    EXPECT_EQ(ran.status, 130) << ran.err;
    const json packing = result();
    EXPECT_EQ(packing["metrics"]["placed"], packing["metrics"]["copies"]);
    EXPECT_FALSE(packing["metrics"]["improvement"].is_null());
}

TEST_F(ImproveRuns, GoalsInJobFilesAndOnTheCommandLine) {
    const std::vector<std::string> small{"--tray", "110x85x50"};
    ASSERT_EQ(run(small).status, 0);
    const int fair = result()["metrics"]["placed"];
    ASSERT_EQ(run(small + std::vector<std::string>{"--goal", "copies", "--improve-steps", "4"}).status, 0);
    EXPECT_GT(result()["metrics"]["placed"], fair);
    EXPECT_EQ(result()["options"]["goal"], "copies");
    EXPECT_EQ(result()["options"]["improve-steps"], 4);
    expect_refused({{"--goal", "beauty"},
                    {"--improve", "-1"},
                    {"--improve", "soon"},
                    {"--improve-steps", "-3"},
                    {"--improve", "rest"},
                    {"--improve", "5", "--fill"},
                    {"--improve", "5", "--interlock", "place"}},
                   kSamples);
}

}  // namespace
}  // namespace spectralpack::test
