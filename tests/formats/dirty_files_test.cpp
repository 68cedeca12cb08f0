/// Every row of the table of hostile and odd files, as far as reading goes (the rows about packing
/// are the packer's).

#include <algorithm>
#include <cmath>
#include <optional>

#include "files.hpp"
#include "formats/csv.hpp"
#include "support/data.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    bool refused = false;
    std::string cause;
    std::vector<std::string> repairs, warnings;
    double volume = 0;  ///< mm^3

    bool told() const { return !repairs.empty() || !warnings.empty(); }
};

Outcome read(const fs::path& file) {
    Outcome outcome;
    try {
        for (const LoadedMesh& loaded : read_meshes(file)) {
            const double unit = loaded.unit.value_or(1);
            outcome.volume += loaded.instances * signed_volume(loaded.mesh) * unit * unit * unit;
            outcome.repairs.insert(outcome.repairs.end(), loaded.repairs.begin(), loaded.repairs.end());
            for (const Remark& warning : loaded.warnings) {
                outcome.warnings.push_back(warning.one);
            }
        }
    } catch (const InputError& error) {
        outcome.refused = true;
        outcome.cause = error.cause();
        EXPECT_EQ(error.file(), file.string());
        EXPECT_FALSE(error.cause().empty());
    }
    return outcome;
}

/// What each word of the table means for a reader; none for an unknown word.
std::optional<bool> as_expected(const std::string& expect, const Outcome& outcome) {
    if (expect == "accept") return !outcome.refused && outcome.repairs.empty();
    if (expect == "accept-with-warning") return !outcome.refused && !outcome.warnings.empty();
    if (expect == "repair-or-reject" || expect == "reject-or-warn") return outcome.refused || outcome.told();
    if (expect == "reject") return outcome.refused;
    if (expect == "unplaced") return !outcome.refused;
    if (expect == "reject-or-unplaced" || expect == "accept-or-reject") return true;
    return std::nullopt;
}

TEST(DirtyFiles, EveryRowBehavesAsTheTableSays) {
    SPECTRALPACK_NEEDS_DATA();
    const fs::path stored = *test::benchmark_data() / "dirty";
    const test::TemporaryFolder made;  // what does not survive being stored
    fs::create_symlink("loop-b.stl", made / "loop-a.stl");
    fs::create_symlink("loop-a.stl", made / "loop-b.stl");
    const auto rows = parse_csv("expected.csv", test::read_text(stored / "expected.csv"));
    ASSERT_EQ(rows.size(), 66u);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::vector<std::string>& row = rows[i].fields;
        ASSERT_EQ(row.size(), 5u);
        SCOPED_TRACE(row[0] + " (" + row[2] + ")");
        const bool is_loop = row[0] == "loop-a.stl", has_line_feed = row[0].find('\n') != std::string::npos;
        if (has_line_feed) fs::copy_file(stored / "-rf.stl", made / row[0]);
        const Outcome outcome = read(is_loop || has_line_feed ? made / row[0] : stored / row[0]);
        const auto verdict = as_expected(row[1], outcome);
        ASSERT_TRUE(verdict.has_value()) << row[1];
        EXPECT_TRUE(*verdict) << row[1] << (outcome.refused ? ", refused: " + outcome.cause : ", read");
        if (!row[4].empty() && !outcome.refused) {
            const double volume = std::stod(row[4]);
            EXPECT_NEAR(outcome.volume, volume, 1e-5 * volume);
        }
    }
}

TEST(DirtyFiles, NoEntryOfAnArchiveReachesTheDisk) {
    SPECTRALPACK_NEEDS_DATA();
    read_meshes(*test::benchmark_data() / "dirty" / "path-traversal.3mf");
    EXPECT_FALSE(fs::exists("/absolute-escape.txt"));
    EXPECT_FALSE(fs::exists(fs::path("../../../../escaped-from-3mf.txt")));
    EXPECT_FALSE(fs::exists(fs::current_path() / "absolute-escape.txt"));
}

}  // namespace
}  // namespace spectralpack
