/// The tables without the program: what is told and what is written. tests/cli/bench_test.cpp runs it.

#include "spectralpack/tools/bench.hpp"

#include <gtest/gtest.h>

#include "formats/packing_file.hpp"
#include "spectralpack/error.hpp"
#include "support/process.hpp"
#include "support/shapes.hpp"
#include "tools/bench/pack_progress.hpp"

namespace spectralpack::test {
namespace {

using namespace tools;
namespace fs = std::filesystem;

/// Writes down what it is told.
class Told : public BenchListener {
  public:
    void on_run(const BenchRun& run) override { runs.push_back(run); }
    void on_done(const BenchDone& done) override { ended.push_back(done); }
    void on_failure(const std::string& why) override { failures.push_back(why); }
    void on_table(const std::string& markdown) override { tables.push_back(markdown); }

    std::vector<BenchRun> runs;
    std::vector<BenchDone> ended;
    std::vector<std::string> failures, tables;
};

class BenchLibrary : public testing::Test {
  protected:
    /// Quick tables of a program that gives up at once.
    BenchOptions options(const std::string& table) const {
        BenchOptions options;
        options.program = fs::canonical("/bin/false");
        options.folder = folder_ / "out";
        options.tables = {table};
        options.scale = BenchScale::quick;
        return options;
    }

    TemporaryFolder folder_;
    Told told_;
};

TEST_F(BenchLibrary, TellsOfRunsThatFail) {
    BenchOptions wanted = options("tori");
    wanted.rows = {"5 mm"};  // alone, the best of several, a beam, and the least box, which is a fixed set only
    const BenchSummary summary = bench(wanted, told_, {});
    EXPECT_EQ(summary.failed, 7);
    EXPECT_EQ(summary.stopped, StopReason::none);
    ASSERT_EQ(told_.runs.size(), 7u);
    for (int i = 0; i < 7; ++i) {
        EXPECT_EQ(told_.runs[static_cast<std::size_t>(i)].number, i + 1);
        EXPECT_EQ(told_.runs[static_cast<std::size_t>(i)].runs, 7);
    }
    EXPECT_EQ(told_.runs.front().what, "tori, 5 mm, tray");
    EXPECT_EQ(told_.runs.back().what, "tori, least box, 5 mm, fixed set");
    ASSERT_EQ(told_.failures.size(), 7u);
    EXPECT_TRUE(told_.failures.front().starts_with("exit status 1: spectralpack pack ")) << told_.failures.front();
    EXPECT_TRUE(told_.ended.empty());
    ASSERT_EQ(told_.tables.size(), 1u);
    EXPECT_EQ(told_.tables.front(), read_text(folder_ / "out" / "table-tori.md"));
}

TEST_F(BenchLibrary, APeerNeedsNothingOfTheProgram) {
    const fs::path cube = folder_ / "cube.stl";
    write_stl(cube_mesh(20), cube);
    BenchOptions wanted = options("4");
    wanted.rows = {"locks"};
    wanted.peers = {{"one", "cp " + cube.string() + " {out}"}};
    const BenchSummary summary = bench(wanted, told_, {});
    EXPECT_EQ(summary.failed, 2) << "of the program, not of the peer";
    ASSERT_EQ(told_.ended.size(), 2u);
    EXPECT_EQ(told_.ended.front().command, wanted.peers.front().command);
    // Kept, so not run again; a run that failed is.
    EXPECT_EQ(bench(wanted, told_, {}).failed, 2);
    EXPECT_EQ(told_.ended.size(), 2u);
    ASSERT_EQ(told_.runs.size(), 6u);
    EXPECT_EQ(told_.runs.back().number, 2);
}

TEST_F(BenchLibrary, NothingRunsOnceItIsStopped) {
    StopSource source;
    source.request(StopReason::cancelled);
    const BenchSummary summary = bench(options("4"), told_, source.token());
    EXPECT_EQ(summary.stopped, StopReason::cancelled);
    EXPECT_EQ(summary.failed, 0);
    EXPECT_TRUE(told_.runs.empty());
}

TEST_F(BenchLibrary, RefusesTablesAndRowsThatDoNotExist) {
    EXPECT_THROW(bench(options("7"), told_, {}), UsageError);
    BenchOptions gold = options("all");
    gold.rows = {"gold"};
    EXPECT_THROW(bench(gold, told_, {}), UsageError);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST(BenchProgressLine, IsReadFromWhatPackSays) {
    const auto progress = parse_progress(
        R"({"phase": "search", "done": 12, "total": 40, "density": 0.21, "seconds": 1.250, "left": 3.5})");
    ASSERT_TRUE(progress);
    EXPECT_EQ(progress->phase, "search");
    EXPECT_EQ(progress->done, 12);
    EXPECT_EQ(progress->total, 40);
    EXPECT_EQ(progress->seconds, 1.25);
    EXPECT_EQ(progress->left, 3.5);
    const auto early =
        parse_progress(R"({"phase": "load", "done": 1, "total": 40, "density": null, "seconds": 0.5, "left": null})");
    ASSERT_TRUE(early);
    EXPECT_FALSE(early->left);
    EXPECT_FALSE(parse_progress(R"({"warning": "a.stl: something"})"));
    EXPECT_FALSE(parse_progress("terminate called"));
}

}  // namespace
}  // namespace spectralpack::test
