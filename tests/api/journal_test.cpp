/// A run that goes on from a journal ends as one that was not disturbed, wherever it was cut off.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <spectralpack/spectralpack.hpp>

#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "api/input_hash.hpp"
#include "api/journal/journal_file.hpp"
#include "api/journal/record_text.hpp"
#include "support/names.hpp"
#include "support/process.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

struct CutOff {};

/// Ends the run by an exception at one of the things it is told, as a kill would.
struct Cutter : Listener {
    explicit Cutter(int after) : left(after) {}
    int left;
    std::vector<std::string> warnings;

    void on_event(const Event&) override { count(); }
    void on_progress(const Progress&) override { count(); }
    void on_warning(const std::string& text) override { warnings.push_back(text); }
    void count() {
        if (left-- == 0) throw CutOff{};
    }
};

struct TellerOfAll : Listener {
    int told = 0;
    std::vector<std::string> warnings;
    void on_event(const Event&) override { ++told; }
    void on_progress(const Progress&) override { ++told; }
    void on_warning(const std::string& text) override { warnings.push_back(text); }
};

Job job_of(int count, const Vec3& tray) {
    Job job;
    job.parts = {{.name = "ring", .mesh = test::torus_mesh(12, 2), .count = count},
                 {.name = "bracket", .mesh = test::bracket(), .count = count, .scale = 2},
                 {.name = "cube", .mesh = test::cube_mesh(9), .count = count}};
    job.options.tray = tray;
    job.options.voxel = 2;
    job.options.gap = 0.5;
    job.options.threads = 2;
    return job;
}

void expect_same(const Packing& a, const Packing& b) {
    ASSERT_EQ(a.trays.size(), b.trays.size());
    for (std::size_t t = 0; t < a.trays.size(); ++t) {
        const TrayPacking &mine = a.trays[t], &other = b.trays[t];
        ASSERT_EQ(mine.placements.size(), other.placements.size()) << "tray " << t;
        for (std::size_t i = 0; i < mine.placements.size(); ++i) {
            EXPECT_EQ(mine.placements[i].part, other.placements[i].part);
            EXPECT_EQ(mine.placements[i].copy, other.placements[i].copy);
            EXPECT_EQ(mine.placements[i].transform, other.placements[i].transform);
        }
        ASSERT_EQ(mine.disassembly.has_value(), other.disassembly.has_value());
        if (!mine.disassembly) continue;
        EXPECT_EQ(mine.disassembly->steps, other.disassembly->steps);
        EXPECT_EQ(mine.disassembly->through_walls, other.disassembly->through_walls);
        EXPECT_EQ(mine.disassembly->complete, other.disassembly->complete);
    }
    ASSERT_EQ(a.unplaced.size(), b.unplaced.size());
    for (std::size_t i = 0; i < a.unplaced.size(); ++i) {
        EXPECT_EQ(std::pair(a.unplaced[i].part, a.unplaced[i].copy), std::pair(b.unplaced[i].part, b.unplaced[i].copy));
        EXPECT_EQ(a.unplaced[i].reason, b.unplaced[i].reason);
    }
    EXPECT_EQ(a.metrics.searches, b.metrics.searches);
}

/// Cuts the run off at `cuts` moments spread over it, each time twice, and lets it go on.
void expect_to_go_on(const Job& job, int cuts) {
    const test::TemporaryFolder folder;
    TellerOfAll teller;
    const PackResult undisturbed = pack(job, {&teller});
    ASSERT_FALSE(undisturbed.failure) << undisturbed.failure->what();
    for (int cut = 0; cut < cuts; ++cut) {
        const JournalOptions journal{folder / "a.journal", 0, Resume::if_it_fits};
        fs::remove(journal.file);
        for (const int part : {cut, cut + 1}) {
            Cutter cutter(teller.told * part / (cuts + 1));
            try {
                static_cast<void>(pack(job, {&cutter}, journal));
            } catch (const CutOff&) {  // one that goes on is told less, and may come to its end
            }
        }
        const PackResult result = pack(job, {}, journal);
        ASSERT_FALSE(result.failure) << result.failure->what();
        ASSERT_TRUE(result.journal);
        EXPECT_TRUE(result.journal->on_disk);
        EXPECT_TRUE(cut == 0 || result.journal->recalled > 0) << "cut " << cut;
        expect_same(result.packing, undisturbed.packing);
        if (testing::Test::HasFailure()) FAIL() << "cut off at part " << cut << " of " << cuts;
    }
}

TEST(Journal, OfOneTray) { expect_to_go_on(job_of(6, {80, 60, 40}), 12); }

TEST(Journal, OfATrayThatOverflows) { expect_to_go_on(job_of(30, {60, 50, 30}), 12); }

TEST(Journal, OfSeveralTrays) {
    Job job = job_of(12, {50, 40, 30});
    job.options.trays = 0;
    expect_to_go_on(job, 12);
}

TEST(Journal, OnTheGrid) {
    Job job = job_of(12, {50, 40, 30});
    job.options.refine = false;
    job.options.trays = 2;
    expect_to_go_on(job, 8);
}

TEST(Journal, WithoutACeiling) {
    Job job = job_of(8, {50, 40, 0});
    job.options.open_height = true;
    expect_to_go_on(job, 8);
}

TEST(Journal, OfTheLeastBox) {
    Job job = job_of(2, {60, 60, 0});
    job.options.minimise = Minimise::box;
    expect_to_go_on(job, 6);
}

TEST(Journal, OfTheBestOfSeveralOrders) {
    Job job = job_of(6, {50, 40, 30});
    job.options.restarts = 3;
    job.options.beam = 2;
    expect_to_go_on(job, 8);
}

TEST(Journal, OfAFill) {
    Job job = job_of(2, {60, 50, 30});
    job.options.fill = true;
    expect_to_go_on(job, 6);
}

TEST(Journal, UnderACapOnLayers) {
    Job job = job_of(8, {60, 50, 30});
    job.options.max_layer_fill = 0.3;
    expect_to_go_on(job, 6);
}

TEST(Journal, WherePlacesHaveToBeReachable) {
    Job job = job_of(8, {60, 50, 30});
    job.options.interlock = Interlock::place;
    expect_to_go_on(job, 6);
}

/// What was decided is not searched for again: the events come, the engine is not asked.
TEST(Journal, OfAFinishedRunIsReplayedWithoutAnyDecision) {
    const test::TemporaryFolder folder;
    const JournalOptions journal{folder / "a.journal", 0, Resume::if_it_fits};
    const Job job = job_of(6, {80, 60, 40});
    const PackResult first = pack(job, {}, journal);
    const std::string text = test::read_text(journal.file);
    const PackResult again = pack(job, {}, journal);
    EXPECT_GT(again.journal->recalled, 0);
    EXPECT_EQ(test::read_text(journal.file), text) << "nothing new was decided";
    expect_same(again.packing, first.packing);
}

class JournalOfAnother : public testing::Test {
  protected:
    void SetUp() override { static_cast<void>(pack(job_, {}, {file_, 0, Resume::never})); }

    /// What the refusal says of `other`.
    std::string refusal(const Job& other) const {
        try {
            static_cast<void>(pack(other, {}, {file_, 0, Resume::must}));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    test::TemporaryFolder folder_;
    fs::path file_ = folder_ / "a.journal";
    Job job_ = job_of(2, {50, 40, 30});
};

TEST_F(JournalOfAnother, JobIsRefusedWithTheDifference) {
    Job other = job_;
    other.options.gap = 0.75;
    EXPECT_TRUE(test::names(refusal(other), {"gap", "0.5", "0.75", file_.string()}));
    other = job_;
    other.parts[1].count = 3;
    EXPECT_TRUE(test::names(refusal(other), {"bracket", "count", "2", "3"}));
    other = job_;
    other.parts[2].mesh = test::cube_mesh(9.5);
    EXPECT_TRUE(test::names(refusal(other), {"cube", "mesh"}));
    other = job_;
    other.parts.pop_back();
    EXPECT_TRUE(test::names(refusal(other), {"cube"}));
    other = job_;
    other.options.unpack = Unpack::any;
    EXPECT_TRUE(test::names(refusal(other), {"unpack", "any"}));
}

TEST_F(JournalOfAnother, NumberOfThreadsIsNone) {
    Job other = job_;
    other.options.threads = 1;
    other.options.memory = std::int64_t{1} << 33;
    EXPECT_EQ(refusal(other), "");
}

TEST_F(JournalOfAnother, JobIsBegunAnewWhereNobodyInsists) {
    Job other = job_;
    other.options.gap = 0.75;
    TellerOfAll teller;
    const PackResult result = pack(other, {&teller}, {file_, 0, Resume::if_it_fits});
    EXPECT_EQ(result.journal->recalled, 0);
    EXPECT_TRUE(test::any_names(teller.warnings, {"gap", "anew"}));
    EXPECT_EQ(refusal(other), "") << "the journal is of that job now";
}

TEST_F(JournalOfAnother, VersionIsRefused) {
    const std::string text = test::read_text(file_);
    const std::size_t at = text.find(SPECTRALPACK_VERSION);
    ASSERT_NE(at, std::string::npos);
    // Whoever changes the first record changes its checksum as well; a file without any record is no journal.
    std::ofstream(file_) << text.substr(0, at) << "9" << text.substr(at + 1);
    EXPECT_TRUE(test::names(refusal(job_), {"not a journal"}));
}

TEST(Journal, ThatIsNotThereIsRefusedWhereItMustBe) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(pack(job_of(1, {50, 40, 30}), {}, {folder / "none.journal", 0, Resume::must}), InputError);
}

/// Whatever byte is lost or changed: what stands before it is used, the rest is decided again.
TEST(Journal, ThatIsDamagedAnywhere) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "a.journal";
    const Job job = job_of(6, {60, 50, 30});
    const PackResult undisturbed = pack(job, {}, {file, 0, Resume::never});
    const std::string whole = test::read_text(file);
    const std::size_t begun = whole.find(" begun\n");
    ASSERT_NE(begun, std::string::npos);
    for (int i = 0; i < 12; ++i) {
        const std::size_t at = begun + 7 + (whole.size() - begun - 8) * static_cast<std::size_t>(i) / 11;
        for (const bool torn : {true, false}) {
            std::string damaged = whole.substr(0, at);
            if (!torn) damaged += static_cast<char>(whole[at] ^ 1) + whole.substr(at + 1);
            std::ofstream(file, std::ios::binary) << damaged;
            const PackResult result = pack(job, {}, {file, 0, Resume::must});
            ASSERT_FALSE(result.failure) << result.failure->what();
            expect_same(result.packing, undisturbed.packing);
            EXPECT_EQ(read_journal(file).damaged, false) << "what was damaged is gone";
        }
    }
}

TEST(Journal, WritesOverNoOtherFile) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "build.3mf";
    std::ofstream(file) << "something else";
    for (const Resume resume : {Resume::if_it_fits, Resume::must, Resume::never}) {
        EXPECT_THROW(pack(job_of(1, {50, 40, 30}), {}, {file, 0, resume}), InputError);
    }
    EXPECT_EQ(test::read_text(file), "something else");
}

/// Writes a journal with sound checksums.
void write_journal(const fs::path& file, const std::vector<std::string>& records) {
    std::ofstream out(file, std::ios::binary);
    std::string hash;
    for (const std::string& record : records) {
        hash = chained_hash(hash, record);
        out << hash << ' ' << record << '\n';
    }
}

/// Checksums are no secret: whoever writes a journal may write anything. It ends the run, with a message.
TEST(Journal, ThatSaysWhatNoRunDecidedIsRefused) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "a.journal";
    Job job = job_of(6, {60, 50, 30});
    static_cast<void>(pack(job, {}, {file, 0, Resume::never}));
    const std::vector<std::string> whole = read_journal(file).records;
    struct Change {
        std::string word;  // of the record that is changed; those after it are left out
        std::size_t token;
        std::string to;
    };
    const std::vector<Change> changes{
        {"place", 4, "1000000"},                            // layers
        {"place", 6, "99"},                                 // orientation
        {"place", 6, "-1"},      {"place", 7, "1000"},      // position
        {"place", 9, "-1"},      {"packed", 2, "1000000"},  // layers
        {"packed", 4, "99"},                                // part
        {"packed", 6, "99"},                                // orientation
        {"apart", 6, "99"},                                 // of a step
        {"filled", 3, "99"},                                // part
        {"filled", 5, "-1"},                                // orientation
    };
    for (const auto& [word, token, to] : changes) {
        std::vector<std::string> records;
        for (const std::string& record : whole) {
            records.push_back(record);
            if (record.starts_with(word + ' ')) break;
        }
        std::istringstream words(records.back());
        std::vector<std::string> tokens{std::istream_iterator<std::string>(words), {}};
        ASSERT_LT(token, tokens.size()) << word;
        tokens[token] = to;
        records.back().clear();
        for (const std::string& each : tokens) {
            records.back() += (records.back().empty() ? "" : " ") + each;
        }
        // Places come before what the tray came to, and are not asked for then.
        write_journal(file, records);
        try {
            const PackResult result = pack(job, {}, {file, 0, Resume::must});
            ASSERT_TRUE(result.failure) << word << ' ' << token;
            EXPECT_TRUE(test::names(result.failure->what(), {"journal", "--no-resume"})) << result.failure->what();
        } catch (const Error& error) {
            EXPECT_TRUE(test::names(error.what(), {"journal", "--no-resume"})) << error.what();
        }
    }
}

TEST(Journal, ThatCannotBeWrittenEndsNoRun) {
    TellerOfAll teller;
    const PackResult result = pack(job_of(2, {50, 40, 30}), {&teller}, {"/dev/full", 0, Resume::never});
    EXPECT_FALSE(result.failure);
    EXPECT_TRUE(test::any_names(teller.warnings, {"/dev/full", "anew"}));
}

TEST(Journal, OfAShortRunIsNeverThere) {
    const test::TemporaryFolder folder;
    const JournalOptions journal{folder / "a.journal", 1000, Resume::if_it_fits};
    const PackResult result = pack(job_of(1, {50, 40, 30}), {}, journal);
    EXPECT_FALSE(result.journal->on_disk);
    EXPECT_FALSE(fs::exists(journal.file));
}

TEST(JournalFile, IsThereInItsTimeWithAllThatCameBefore) {
    const test::TemporaryFolder folder;
    const fs::path path = folder / "a.journal";
    JournalFile file(path, 0.05, nullptr);
    file.add("one");
    file.add("two");
    while (!file.on_disk()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    file.add("three");
    EXPECT_EQ(read_journal(path).records, (std::vector<std::string>{"one", "two", "three"}));
}

TEST(JournalFile, OfTwoRunsAtOnceIsWrittenByOne) {
    const test::TemporaryFolder folder;
    const fs::path path = folder / "a.journal";
    JournalFile first(path, 0, nullptr), second(path, 0, nullptr);
    first.add("one");
    second.add("two");
    EXPECT_FALSE(first.failure());
    EXPECT_TRUE(second.failure());
    EXPECT_FALSE(second.on_disk());
    EXPECT_EQ(read_journal(path).records, std::vector<std::string>{"one"});
}

struct Values {
    int whole = 0;
    std::uint64_t natural = 0;
    double real = 0;
    bool flag = false;
    std::string text;
    std::vector<double> list;
    std::optional<std::string> maybe;
    std::map<int, std::string> map;

    bool operator==(const Values&) const = default;
};

template <class Archive>
void record_values(Archive& archive, ConstOrNot<Values> auto& v) {
    archive(v.whole, v.natural, v.real, v.flag, v.text, v.list, v.maybe, v.map);
}

RC_GTEST_PROP(JournalRecord, ReadsBackAsItWasWritten, ()) {
    const auto any_text = rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    Values values;
    values.whole = *rc::gen::arbitrary<int>();
    values.natural = *rc::gen::arbitrary<std::uint64_t>();
    values.real = *rc::gen::arbitrary<double>();
    values.flag = *rc::gen::arbitrary<bool>();
    values.text = *any_text;
    values.list = *rc::gen::arbitrary<std::vector<double>>();
    if (*rc::gen::arbitrary<bool>()) values.maybe = *any_text;
    values.map = *rc::gen::container<std::map<int, std::string>>(rc::gen::arbitrary<int>(), any_text);
    RecordWriter writer("word");
    writer(values);
    RC_ASSERT(writer.text().find('\n') == std::string::npos);
    Values read;
    RecordReader reader(writer.text());
    reader(read);
    RC_ASSERT(reader.ok());
    RC_ASSERT(reader.word() == "word");
    RC_ASSERT(read == values);
    // One token less, or one more, is found out.
    const std::string shorter = writer.text().substr(0, writer.text().rfind(' '));
    RecordReader incomplete(shorter);
    Values part;
    incomplete(part);
    RC_ASSERT(!incomplete.ok());
}

}  // namespace
}  // namespace spectralpack
