/// A killed program goes on where it was.

#include <signal.h>

#include <optional>

#include "cli/running_program.hpp"

namespace spectralpack::test {
namespace {

namespace fs = std::filesystem;

class KilledRun : public testing::Test {
  protected:
    /// The job, into outputs of that name.
    std::vector<std::string> job(const std::string& name, const std::vector<std::string>& more = {}) const {
        return std::vector<std::string>{"pack", kSamples,    "--tray", "130x100x80", "--voxel", "1",          "--gap",
                                        "1",    "--threads", "2",      "-o",         at(name),  "--progress", "json"} +
               more;
    }
    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    std::string journal() const { return at("a.journal"); }

    /// What does not depend on how often a run was killed.
    nlohmann::json result(const std::string& name) const {
        const nlohmann::json packing = read_json(at(name));
        nlohmann::json result{packing["unplaced"], packing["input_hash"]};
        for (const nlohmann::json& tray : packing["trays"]) {
            result.push_back({tray["placements"], tray["disassembly"]});
        }
        return result;
    }

    /// Starts it and sends the signal once so many copies stand. The exit status.
    int end_by(int signal, int copies, const std::vector<std::string>& arguments) const {
        RunningProgram program(arguments);
        EXPECT_TRUE(program.says(placed(copies))) << program.err();
        program.signal(signal);
        return program.wait();
    }

    TemporaryFolder folder_;
};

TEST_F(KilledRun, GoesOnAndEndsAsIfNothingHadHappened) {
    ASSERT_EQ(spectralpack(job("whole.json")).status, 0);
    const std::vector<std::string> command = job("killed.json", {"--journal", journal()});
    ASSERT_EQ(end_by(SIGKILL, 15, command), 128 + SIGKILL);
    ASSERT_TRUE(fs::exists(journal()));
    ASSERT_FALSE(fs::exists(at("killed.json")));
    ASSERT_EQ(end_by(SIGKILL, 30, command), 128 + SIGKILL) << "once more";
    const Ran ran = spectralpack(command);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {journal(), "goes on", "--no-resume"}));
    EXPECT_EQ(result("killed.json"), result("whole.json"));
    EXPECT_FALSE(fs::exists(journal())) << "the outputs are written";
    EXPECT_EQ(spectralpack({"check", "--require-plan", at("killed.json")}).status, 0);
}

TEST_F(KilledRun, OfAnotherJobIsRefusedWithTheDifference) {
    ASSERT_EQ(end_by(SIGKILL, 15, job("a.json", {"--journal", journal()})), 128 + SIGKILL);
    const std::string before = read_text(journal());
    const Ran other = spectralpack(job("a.json", {"--resume", journal(), "--seed", "3", "--order", "random"}));
    EXPECT_EQ(other.status, 3);
    EXPECT_TRUE(names(other.err, {journal(), "order"}));
    EXPECT_EQ(read_text(journal()), before);
    EXPECT_EQ(spectralpack(job("a.json", {"--resume", at("none.journal")})).status, 3);
    expect_refused({{"--resume", journal(), "--no-resume"}, {"--resume", journal(), "--journal", journal()}}, kSamples);
}

TEST_F(KilledRun, BeginsAnewWhereThatIsAsked) {
    ASSERT_EQ(end_by(SIGKILL, 15, job("a.json", {"--journal", journal()})), 128 + SIGKILL);
    const Ran ran = spectralpack(job("a.json", {"--journal", journal(), "--no-resume"}));
    EXPECT_EQ(ran.status, 0);
    EXPECT_FALSE(names(ran.err, {"goes on"}));
}

/// What Ctrl-C ended has its best packing written, and goes on all the same.
TEST_F(KilledRun, ThatWasAskedToEndGoesOn) {
    ASSERT_EQ(spectralpack(job("whole.json")).status, 0);
    const std::vector<std::string> command = job("a.json", {"--journal", journal()});
    ASSERT_EQ(end_by(SIGINT, 15, command), 130);
    EXPECT_TRUE(fs::exists(at("a.json")));
    ASSERT_TRUE(fs::exists(journal()));
    ASSERT_EQ(spectralpack(command).status, 0);
    EXPECT_EQ(result("a.json"), result("whole.json"));
    EXPECT_FALSE(fs::exists(journal()));
}

TEST_F(KilledRun, LeavesTheFilesOfFinishedTrays) {
    const std::vector<std::string> command = job("a.json", {"--trays", "all", "-o", at("a.3mf")});
    {
        RunningProgram program(command);
        const bool second = program.says(reported(
            [](const nlohmann::json& line) { return line.value("event", "") == "tray_begun" && line["tray"] == 2; }));
        ASSERT_TRUE(second) << program.err();
        program.signal(SIGKILL);
        ASSERT_EQ(program.wait(), 128 + SIGKILL);
    }
    EXPECT_TRUE(fs::exists(at("a-1.3mf")));
    EXPECT_EQ(read_json(at("a.json"))["trays"].size(), 1u);
    EXPECT_EQ(spectralpack({"check", "--require-plan", at("a.json")}).status, 0);
}

/// An output is no journal, and a journal no output.
TEST_F(KilledRun, KeepsItsJournalApart) {
    EXPECT_EQ(spectralpack(job("a.json", {"--journal", at("a.json")})).status, 2);
    std::ofstream(journal()) << "notes\n";
    EXPECT_EQ(spectralpack(job("a.json", {"--journal", journal()})).status, 3);
    EXPECT_EQ(read_text(journal()), "notes\n");
}

}  // namespace
}  // namespace spectralpack::test
