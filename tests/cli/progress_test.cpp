#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

TEST(Progress, EveryLineIsJsonAndPhasesComeInOrder) {
    const TemporaryFolder folder;
    const Ran ran =
        spectralpack(std::vector<std::string>{"pack", kSamples, (folder / "missing.stl").string(), "--progress", "json",
                                              "-o", (folder / "b.json").string(), "-o", (folder / "b.csv").string()} +
                     kSmall);
    EXPECT_EQ(ran.status, 3) << ran.err;
    const std::vector<std::string> order{"load", "search", "disassemble", "write"};
    std::vector<std::string> phases;
    json last;
    int errors = 0;
    std::istringstream lines(ran.err);
    for (std::string line; std::getline(lines, line);) {
        const json entry = json::parse(line, nullptr, false);
        ASSERT_TRUE(entry.is_object()) << line;
        if (entry.contains("error")) {
            EXPECT_TRUE(names(entry["error"], {"missing.stl"}));
            ++errors;
        }
        if (!entry.contains("phase")) continue;
        EXPECT_LE(entry["done"], entry["total"]) << line;
        EXPECT_GE(entry["density"], 0) << line;
        EXPECT_GE(entry["seconds"], 0) << line;
        EXPECT_TRUE(entry["left"].is_null() || entry["left"] >= 0) << line;
        if (phases.empty() || phases.back() != entry["phase"]) {
            if (!last.is_null()) {
                EXPECT_EQ(last["done"], last["total"]) << last;
            }
            phases.push_back(entry["phase"]);
        } else {
            EXPECT_GE(entry["done"], last["done"]) << line;
            EXPECT_GE(entry["density"], last["density"]) << line;
        }
        last = entry;
    }
    EXPECT_EQ(phases, order);
    EXPECT_EQ(last["done"], 2);
    EXPECT_EQ(last["total"], 2);
    EXPECT_EQ(errors, 1);
}

TEST(Progress, WithoutACeilingThereIsNoDensity) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& search : {std::vector<std::string>{}, {"--beam", "2"}}) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--tray", "100x100", "--voxel", "4",
                                                              "--open-height", "--progress", "json", "-o",
                                                              (folder / "b.json").string()} +
                                     search);
        EXPECT_EQ(ran.status, 0) << ran.err;
        int told = 0;
        for (const json& line : json_lines(ran.err)) {
            if (line.value("phase", "") != "search" || line["done"] == 0) continue;
            EXPECT_TRUE(line["density"].is_null()) << line;
            ++told;
        }
        EXPECT_GT(told, 0) << ran.err;
    }
}

TEST(Progress, TheSearchOfSeveralTraysIsOne) {
    const TemporaryFolder folder;
    // With --height-at auto a tray may be packed anew, and its search then begins anew.
    const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--trays", "all", "--height-at", "bottom",
                                                          "--progress", "json", "-o", (folder / "b.json").string()} +
                                 kSmall);
    EXPECT_EQ(ran.status, 0) << ran.err;
    int searches = 0;
    std::string phase;
    double seconds = 0;
    for (const json& entry : json_lines(ran.err)) {
        if (!entry.contains("phase")) continue;
        searches += entry["phase"] == "search" && phase != "search" ? 1 : 0;
        phase = entry["phase"];
        if (phase != "search") continue;
        EXPECT_GE(entry["seconds"], seconds) << entry;
        seconds = entry["seconds"];
    }
    EXPECT_GT(searches, 1) << ran.err;
}

TEST(Progress, NoneSaysNothing) {
    const Ran ran = spectralpack({"pack", kSamples, "--tray", "160x120x100", "--voxel", "4", "--progress", "none"});
    EXPECT_EQ(ran.status, 0);
    EXPECT_TRUE(ran.err.empty()) << ran.err;
}

TEST(Threads, MoreThanTheMachineHasAreNoReasonToWarn) {
    const TemporaryFolder folder;
    const std::string packing = (folder / "a.json").string();
    const Ran ran = spectralpack(
        {"pack", kSamples, "--voxel", "8", "--threads", "64", "-o", packing, "-o", (folder / "a.png").string()});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(read_json(packing)["metrics"]["threads"], 64);
    const Ran drawn = spectralpack({"render", packing, "--threads", "64", "-o", (folder / "b.png").string()});
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_EQ(ran.err + drawn.err, "");
}

}  // namespace
}  // namespace spectralpack::test
