/// What ends a run early, and what is left of it then: signals, readers that go, files that may not grow, threads and
/// memory that are not there.

#include <fstream>

#include "cli/running_program.hpp"
#include "support/sanitized.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const std::string kHook = (samples() / "hook.stl").string();

/// Interrupted, with something written that is a packing.
void expect_best_so_far(RunningProgram& program, const fs::path& output) {
    EXPECT_EQ(program.wait(), 130) << program.err();
    ASSERT_TRUE(fs::exists(output)) << program.err();
    const json packing = read_json(output);
    EXPECT_GE(packing["metrics"]["placed"], 1);
    EXPECT_EQ(packing["unplaced"].back()["reason"], "not_tried");
}

TEST(RunLife, EachSignalToStopWritesTheBestSoFar) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        const TemporaryFolder folder;
        RunningProgram program(long_job(folder / "b.json"));
        ASSERT_TRUE(program.says(placed(2)));
        program.signal(number);
        expect_best_so_far(program, folder / "b.json");
    }
}

TEST(RunLife, ASecondSignalLosesNothing) {
    const TemporaryFolder folder;
    RunningProgram program(long_job(folder / "b.json"));
    ASSERT_TRUE(program.says(placed(2)));
    program.signal(SIGINT);
    program.signal(SIGTERM);
    expect_best_so_far(program, folder / "b.json");
}

TEST(RunLife, AThirdSignalWithinASecondEndsItAtOnceAndSaysSo) {
    const TemporaryFolder folder;
    RunningProgram program(long_job(folder / "b.json"));
    ASSERT_TRUE(program.says(placed(1)));
    program.signal(SIGINT);
    program.signal(SIGTERM);
    program.signal(SIGHUP);
    EXPECT_EQ(program.wait(), 130);
    if (!fs::exists(folder / "b.json")) {
        EXPECT_TRUE(contains(program.err(), "Nothing was written")) << program.err();
    }
}

TEST(RunLife, UnderNohupAHangUpDoesNotEndIt) {
    const TemporaryFolder folder;
    RunningProgram program(
        {"pack", kHook + ":3", "--tray", "90x90x60", "--progress", "json", "-o", (folder / "b.json").string()},
        [] { ::signal(SIGHUP, SIG_IGN); });
    ASSERT_TRUE(program.says(placed(0)));
    program.signal(SIGHUP);
    EXPECT_EQ(program.wait(), 0) << program.err();
}

TEST(RunLife, WhoReadsTheProgressMayGo) {
    const TemporaryFolder folder;
    RunningProgram program(
        {"pack", kHook + ":3", "--tray", "90x90x60", "--progress", "json", "-o", (folder / "b.json").string()}, [] {
            int ends[2];
            if (pipe(ends) != 0) _exit(125);
            dup2(ends[1], STDERR_FILENO);
            close(ends[0]);  // nobody reads
            close(ends[1]);
        });
    EXPECT_EQ(program.wait(), 0);
    EXPECT_EQ(read_json(folder / "b.json")["metrics"]["placed"], 3);
}

TEST(RunLife, AFileThatMayNotGrowIsAnErrorAndLeavesNothing) {
    const TemporaryFolder folder;
    RunningProgram program({"pack", kHook + ":3", "--tray", "90x90x60", "-o", (folder / "b.stl").string()},
                           [] { limit(RLIMIT_FSIZE, 4096); });
    EXPECT_EQ(program.wait(), 4);
    EXPECT_TRUE(names(program.err(), {(folder / "b.stl").string()})) << program.err();
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(RunLife, LeftoversOfKilledRunsGoOnceTheirOutputIsWrittenAgain) {
    const TemporaryFolder folder;
    const pid_t gone = fork();
    if (gone == 0) _exit(0);
    int status = 0;
    waitpid(gone, &status, 0);
    const fs::path leftover = folder / (".b.part" + std::to_string(gone) + ".json");
    std::ofstream(leftover) << "half";
    const Ran ran = spectralpack({"pack", kHook, "--tray", "90x90x60", "-o", (folder / "b.json").string()});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_FALSE(fs::exists(leftover));
}

TEST(RunLife, NumbersOfThreadsThatMakeNoSenseAreRefused) {
    expect_refused({{"--threads", "-1"}, {"--threads", "1025"}, {"--threads", "30000"}}, kHook);
    EXPECT_EQ(spectralpack({"check", "x.json", "--threads", "-1"}).status, 2);
}

TEST(RunLife, GoesOnWithTheThreadsThatStart) {
    if (kSanitized) GTEST_SKIP() << "sanitizers take addresses of their own";
    const TemporaryFolder folder;
    // Stacks of a gigabyte: no more than a few fit.
    RunningProgram program({"pack", kHook + ":3", "--tray", "90x90x60", "--voxel", "3", "--threads", "64", "-o",
                            (folder / "b.json").string()},
                           [] {
                               limit(RLIMIT_STACK, rlim_t{1} << 30);
                               limit(RLIMIT_AS, rlim_t{3} << 30);
                           });
    EXPECT_EQ(program.wait(), 0) << program.err();
    EXPECT_TRUE(names(program.err(), {64})) << program.err();
    const json packing = read_json(folder / "b.json");
    EXPECT_LT(packing["metrics"]["threads"], 64);
    EXPECT_EQ(packing["metrics"]["placed"], 3);
}

TEST(RunLife, WithLittleRoomItIsRefusedOrWritesWhatItHas) {
    if (kSanitized) GTEST_SKIP() << "sanitizers take addresses of their own";
    for (const rlim_t megabytes : {120, 160, 250, 400}) {
        for (const char* memory : {"100M", "4G"}) {
            const TemporaryFolder folder;
            const Ran ran = spectralpack({"pack", kHook + ":300000", "--tray", "80x80x80", "--voxel", "3", "--memory",
                                          memory, "-o", (folder / "b.json").string()},
                                         {}, {megabytes << 20, 0, 300});
            EXPECT_TRUE(ran.status == 4 || ran.status == 0) << megabytes << ' ' << ran.status << ' ' << ran.err;
            EXPECT_FALSE(contains(ran.err, "terminate")) << ran.err;
            if (ran.status == 4) {
                EXPECT_TRUE(contains(ran.err, "memory")) << ran.err;
            } else {
                EXPECT_TRUE(fs::exists(folder / "b.json"));
            }
        }
    }
}

/// What the program does with amounts of memory from too little to begin with up to a little more than enough.
class ShortOfMemory : public testing::TestWithParam<const char*> {};

TEST_P(ShortOfMemory, SaysSo) {
    if (kSanitized) GTEST_SKIP() << "sanitizers take addresses of their own";
    const TemporaryFolder folder;
    const std::string command = GetParam(), packing = (folder / "b.json").string();
    std::vector<std::string> arguments = {"pack", kHook + ":20", "--tray", "80x80x80", "--voxel", "3", "-o", packing};
    if (command != "pack") {
        ASSERT_EQ(spectralpack(arguments).status, 0);
        arguments = {command, packing};
        if (command == "render") arguments.insert(arguments.end(), {"-o", (folder / "b.png").string()});
    }
    constexpr rlim_t kLeast = 48 << 20, kMost = 128 << 20, kStep = 1 << 19;
    int refused = 0;
    for (rlim_t bytes = kLeast; bytes <= kMost; bytes += kStep) {
        const Ran ran = spectralpack(arguments, {}, {bytes, 0, 300});
        // Where the libraries themselves find no room, the program has not begun.
        if (ran.status == 127 && contains(ran.err, "error while loading shared libraries")) continue;
        if (ran.status == 0) break;
        ASSERT_EQ(ran.status, 4) << bytes << ' ' << ran.err;
        EXPECT_TRUE(contains(ran.err, "spectralpack: ") && contains(ran.err, "memory")) << bytes << ' ' << ran.err;
        ++refused;
    }
    EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Commands, ShortOfMemory, testing::Values("pack", "check", "plan", "render"),
                         [](const auto& test) { return std::string(test.param); });

/// A gap that no two copies in the tray can keep.
class WideGap : public testing::TestWithParam<std::string> {};

TEST_P(WideGap, LeavesOneCopyForEachTrayAtOnce) {
    const TemporaryFolder folder;
    for (const bool all : {false, true}) {
        const Ran ran = spectralpack({"pack", kHook + ":2@0.5", "--tray", "60x60x40", "--voxel", "4", "--gap",
                                      GetParam(), "--trays", all ? "all" : "1", "-o", (folder / "b.json").string()},
                                     {}, {0, 60, 200});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const json packing = read_json(folder / "b.json");
        EXPECT_EQ(packing["metrics"]["placed"], all ? 2 : 1);
        EXPECT_EQ(packing["trays"].size(), all ? 2u : 1u);
        if (!all) {
            ASSERT_EQ(packing["unplaced"].size(), 1u);
            EXPECT_EQ(packing["unplaced"][0]["reason"], "no_place");
        }
        EXPECT_TRUE(check_report((folder / "b.json").string(), 0)["ok"]);
    }
}

INSTANTIATE_TEST_SUITE_P(Gaps, WideGap, testing::Values("95", "250", "1e6", "1e20"));

TEST(WideGapOfOnePart, IsKeptFromTheOthers) {
    const TemporaryFolder folder;
    const json part{{"mesh", kHook}, {"count", 2}};
    json wide = part;
    wide["gap"] = 300;
    wide["name"] = "wide";
    const json job{{"format", "spectralpack/job"},
                   {"version", 1},
                   {"container", {{"size", {90, 90, 60}}}},
                   {"parts", {part, wide}},
                   {"options", {{"voxel", 2}, {"trays", "all"}}}};
    std::ofstream(folder / "job.json") << job;
    const std::string file = (folder / "job.json").string();
    EXPECT_EQ(spectralpack({"pack", file, "--dry-run"}, {}, {0, 60, 200}).status, 0);
    const Ran ran = spectralpack({"pack", file, "-o", (folder / "b.json").string()}, {}, {0, 60, 200});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = read_json(folder / "b.json");
    EXPECT_EQ(packing["metrics"]["placed"], 4);
    EXPECT_EQ(packing["trays"].size(), 3u) << "two alone, the others together";
    EXPECT_TRUE(check_report((folder / "b.json").string(), 0)["ok"]);
}

TEST(RunLife, StopsWhileVoxelsAreWidened) {
    const TemporaryFolder folder;
    // Takes minutes.
    RunningProgram program({"pack", kHook + ":2", "--tray", "400x400x400", "--voxel", "1", "--gap", "300", "--memory",
                            "100G", "--progress", "json", "-o", (folder / "b.json").string()});
    ASSERT_TRUE(program.says(reported([](const json& line) { return line.value("phase", "") == "search"; })));
    program.signal(SIGTERM);
    EXPECT_EQ(program.wait(), 130) << program.err();
}

}  // namespace
}  // namespace spectralpack::test
