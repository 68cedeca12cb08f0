/// Hostile and odd files (the table beside them says what each is) through the whole program.

#include <algorithm>

#include "cli/program.hpp"
#include "formats/csv.hpp"
#include "support/sanitized.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

// A gigabyte, and two threads for five seconds. With sanitizers more, and no bound on memory: theirs takes terabytes of
// address space.
constexpr Limits kLimits = kSanitized ? Limits{0, 40, 200} : Limits{rlim_t{1} << 30, 10, 100};

struct Row {
    std::string file, expect, what, volume;
};

/// The stored files by links, and the three that cannot be stored.
class Dirty : public testing::Test {
  protected:
    void SetUp() override {
        SPECTRALPACK_NEEDS_DATA();
        const fs::path stored = *benchmark_data() / "dirty";
        for (const CsvRow& row : parse_csv("expected.csv", read_text(stored / "expected.csv"))) {
            ASSERT_EQ(row.fields.size(), 5u);
            rows_.push_back({row.fields[0], row.fields[1], row.fields[2], row.fields[4]});
        }
        rows_.erase(rows_.begin());
        ASSERT_EQ(rows_.size(), 65u);
        fs::create_directory(files_);
        for (const Row& row : rows_) {
            const fs::path from = stored / row.file, to = files_ / row.file;
            if (row.file.find('\n') != std::string::npos) {
                fs::copy_file(stored / "-rf.stl", to);
            } else if (fs::exists(from)) {
                fs::copy(from, to, fs::copy_options::recursive);
            }
        }
        fs::create_symlink("loop-b.stl", files_ / "loop-a.stl");
        fs::create_symlink("loop-a.stl", files_ / "loop-b.stl");
    }

    Ran pack(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"pack", "--threads", "2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return spectralpack(arguments, {}, kLimits);
    }

    /// Packs one file of the table, in the tray that the table is about.
    Ran pack_one(const std::string& name, const std::vector<std::string>& more = {}) {
        fs::remove(build_);
        std::vector<std::string> arguments{(files_ / name).string(), "--tray", "480x245x200", "-o", build_.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return pack(arguments);
    }

    const TemporaryFolder folder_;
    const fs::path files_ = folder_ / "files", build_ = folder_ / "build.json";
    std::vector<Row> rows_;
};

/// How a run ended, in the words of the table.
struct Outcome {
    bool placed = false, unplaced = false, rejected = false, told = false;
    double volume = 0;
};

Outcome outcome_of(const Ran& ran, const std::string& shown_name, const fs::path& build) {
    Outcome outcome;
    outcome.told = contains(ran.err, shown_name);
    outcome.rejected = ran.status == 3 && !fs::exists(build) && contains(ran.err, shown_name);
    if (ran.status != 0 && ran.status != 6) return outcome;
    if (fs::exists(build) != (ran.status == 0)) return outcome;  // where nothing is placed nothing is written
    const json packing = json::parse(ran.out);
    for (const json& part : packing["parts"]) {
        outcome.volume += part["volume"].get<double>() * part["count"].get<int>();
    }
    const json& unplaced = packing["unplaced"];
    outcome.placed = unplaced.empty() && packing["metrics"]["placed"] > 0;
    outcome.unplaced = !unplaced.empty() && std::all_of(unplaced.begin(), unplaced.end(),
                                                        [](const json& copy) { return copy["reason"] == "too_large"; });
    return outcome;
}

/// None for a word the table does not explain.
std::optional<bool> as_expected(const std::string& expect, const Outcome& o) {
    if (expect == "accept") return o.placed;
    if (expect == "accept-with-warning") return o.placed && o.told;
    if (expect == "repair-or-reject" || expect == "reject-or-warn") return (o.placed && o.told) || o.rejected;
    if (expect == "reject") return o.rejected;
    if (expect == "unplaced") return o.unplaced;
    if (expect == "reject-or-unplaced") return o.rejected || o.unplaced;
    if (expect == "accept-or-reject") return o.placed || o.rejected;
    return std::nullopt;
}

TEST_F(Dirty, EveryRowBehavesAsTheTableSays) {
    for (const Row& row : rows_) {
        SCOPED_TRACE(row.file + " (" + row.what + ")");
        const Ran ran = pack_one(row.file, {"--json"});
        std::string shown = fs::path(row.file).stem().string();  // remarks have no ending
        std::replace(shown.begin(), shown.end(), '\n', '?');
        const Outcome outcome = outcome_of(ran, shown, build_);
        const auto verdict = as_expected(row.expect, outcome);
        ASSERT_TRUE(verdict.has_value()) << row.expect;
        EXPECT_TRUE(*verdict) << row.expect << ", but status " << ran.status << "\n" << ran.err << ran.out;
        if (!row.volume.empty() && (outcome.placed || outcome.unplaced)) {
            const double volume = std::stod(row.volume);
            EXPECT_NEAR(outcome.volume, volume, 1e-5 * volume);
        }
    }
}

TEST_F(Dirty, EveryRowCanBeInspected) {
    for (const Row& row : rows_) {
        SCOPED_TRACE(row.file);
        const Ran ran =
            spectralpack({"inspect", "--json", "--threads", "2", (files_ / row.file).string()}, {}, kLimits);
        const json report = json::parse(ran.out, nullptr, false);
        ASSERT_TRUE(report.is_object()) << ran.out << ran.err;
        EXPECT_EQ(ran.status, report["unusable"] > 0 ? 3 : 0) << ran.err;
        if (row.expect.starts_with("accept") && row.expect != "accept-or-reject") {
            EXPECT_EQ(report["usable"], 1);
        }
        if (row.expect == "reject") {
            EXPECT_EQ(report["unusable"], 1);
        }
    }
}

TEST_F(Dirty, FitsOnlyTurnedIsLeftOverWithoutTurns) {
    const Ran ran = pack_one("fits-only-turned.stl", {"--rotations", "none", "--json"});
    EXPECT_EQ(ran.status, 6) << ran.err;
    EXPECT_EQ(json::parse(ran.out)["unplaced"][0]["reason"], "too_large");
}

TEST_F(Dirty, OutputsStayReadableWhateverTheNames) {
    for (const Row& row : rows_) {
        if (row.what.find("file name") == std::string::npos) continue;
        SCOPED_TRACE(row.file);
        const fs::path csv = folder_ / "build.csv", report = folder_ / "report.csv";
        const Ran ran = pack_one(row.file, {"-o", csv.string(), "--report", report.string(), "--json"});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const std::string stem = fs::path(row.file).stem().string();
        EXPECT_EQ(json::parse(ran.out)["parts"][0]["name"], stem);
        const json packing = read_json(build_);
        EXPECT_EQ(packing["parts"][0]["name"], stem);
        EXPECT_EQ(packing["parts"][0]["mesh"], "files/" + row.file);
        for (const fs::path& table : {csv, report}) {
            const auto rows = parse_csv(table.string(), read_text(table));
            ASSERT_EQ(rows.size(), 2u);
            EXPECT_EQ(rows[1].fields.size(), rows[0].fields.size());
            EXPECT_EQ(std::count(rows[1].fields.begin(), rows[1].fields.end(), stem), 1);
        }
        EXPECT_EQ(spectralpack({"check", build_.string()}).status, 0);
    }
}

TEST_F(Dirty, AWholeFolderPacksWhatIsGoodAndListsWhatIsNot) {
    // Large enough for all but the two that are meant to be too large.
    const Ran ran = pack({files_.string(), "--tray", "560x500x420", "--voxel", "5", "-o", build_.string()});
    EXPECT_EQ(ran.status, 3) << ran.err;
    const json packing = read_json(build_);
    std::map<std::string, std::string> reason;  // by file; empty: placed
    for (const json& placement : packing["trays"][0]["placements"]) {
        reason.emplace(fs::path(placement["mesh"].get<std::string>()).filename(), "");
    }
    for (const json& copy : packing["unplaced"]) {
        const json& part = packing["parts"][copy["part"].get<std::size_t>()];
        reason[fs::path(part["mesh"].get<std::string>()).filename()] = copy["reason"];
    }
    for (const Row& row : rows_) {
        SCOPED_TRACE(row.file);
        if (row.file == "missing.stl") continue;
        if (row.expect == "accept" || row.expect == "accept-with-warning") {
            ASSERT_TRUE(reason.contains(row.file));
            EXPECT_EQ(reason[row.file], "");
        }
        if (row.expect == "reject") {
            EXPECT_TRUE(names(ran.err, {row.file}));
            EXPECT_TRUE(!reason.contains(row.file) || reason[row.file] == "bad_file");
        }
    }
    EXPECT_EQ(reason["larger-than-tray.stl"], "too_large");
    EXPECT_EQ(packing["metrics"]["placed"].get<std::size_t>() + packing["unplaced"].size(),
              packing["metrics"]["copies"].get<std::size_t>());
}

}  // namespace
}  // namespace spectralpack::test
