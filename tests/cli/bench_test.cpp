/// The command bench, end to end.

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/program.hpp"
#include "formats/csv.hpp"
#include "support/sanitized.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Bench : public testing::Test {
  protected:
    Ran bench(const std::string& table, const std::vector<std::string>& more = {}, const Moment& interrupt_when = {}) {
        return spectralpack(
            std::vector<std::string>{"bench", "--table", table, "--scale", "quick", "-o", (folder_ / "out").string()} +
                more,
            interrupt_when);
    }

    /// Rows of a table's CSV by column name.
    std::vector<std::map<std::string, std::string>> rows(const std::string& table) const {
        const fs::path file = folder_ / "out" / ("table-" + table + ".csv");
        const std::vector<CsvRow> lines = parse_csv(file.string(), read_text(file));
        std::vector<std::map<std::string, std::string>> found;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            auto& row = found.emplace_back();
            for (std::size_t k = 0; k < lines[0].fields.size(); ++k) {
                row[lines[0].fields[k]] = lines[i].fields[k];
            }
        }
        return found;
    }

    static std::size_t times(const std::string& text, const std::string& what) {
        std::size_t count = 0;
        for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) {
            ++count;
        }
        return count;
    }

    fs::path kept() const { return folder_ / "out" / "runs"; }

    /// When each kept run was written. One that is being written is beside its place, and hidden.
    std::map<std::string, fs::file_time_type> runs() const {
        std::map<std::string, fs::file_time_type> written;
        for (const auto& entry : fs::directory_iterator(kept())) {
            const fs::path name = entry.path().filename();
            if (name.extension() == ".txt" && !name.string().starts_with('.')) written[name] = entry.last_write_time();
        }
        return written;
    }

    TemporaryFolder folder_;
};

TEST_F(Bench, OrdersArePackedInATrayAndAsAFixedSet) {
    if (kSanitized) GTEST_SKIP() << "many whole runs; other tests of bench run with sanitizers";
    const Ran ran = bench("order");
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto all = rows("order");
    ASSERT_EQ(all.size(), 32u);  // two sets, eight settings, tray and fixed set
    std::map<std::string, double> density;
    for (const auto& row : all) {
        EXPECT_TRUE(contains(row.at("command"), "spectralpack pack ")) << row.at("command");
        EXPECT_EQ(contains(row.at("command"), "--height-at bottom --height-penalty auto"), row.at("kind") == "tray")
            << "the paper's rule under a ceiling: " << row.at("command");
        EXPECT_FALSE(row.at("commit").empty());
        EXPECT_FALSE(row.at("machine").empty());
        EXPECT_GT(std::stod(row.at("cpu_seconds")), 0);
        if (row.at("kind") == "fixed") {
            EXPECT_EQ(row.at("placed"), row.at("copies")) << "a fixed set stands whole";
            EXPECT_GT(std::stod(row.at("height")), 0);
        } else {
            density[row.at("set") + row.at("setting")] = std::stod(row.at("density"));
        }
    }
    for (const char* set : {"pieces", "mixtures"}) {
        for (const char* order : {"size", "mixed"}) {
            const std::string plain = std::string(set) + order;
            EXPECT_GE(density[plain + ", best of 3"], density[plain]) << plain;
            EXPECT_GE(density[plain + ", beam of 5"], density[plain]) << plain;
        }
    }
    const std::string text = read_text(folder_ / "out" / "table-order.md");
    EXPECT_EQ(times(text, "spectralpack pack "), 32u);
    EXPECT_TRUE(contains(ran.out, text)) << "what is written is shown, too";
    EXPECT_TRUE(names(ran.err, {1, 32, "mixtures", "pieces", "beam of 5"})) << "which run of how many, and what it is";
    const fs::path log = fs::path(runs().begin()->first).replace_extension(".log");
    EXPECT_TRUE(reported([](const json& line) { return line.value("phase", "") == "search"; })(
        read_text(folder_ / "out" / "runs" / log)));
}

TEST_F(Bench, WhatWasRunIsNotRunAgain) {
    if (kSanitized) GTEST_SKIP() << "many whole runs; other tests of bench run with sanitizers";
    const std::vector<std::string> options{"--threads", "1"};
    const Moment three_done = [&](const std::string&) { return fs::exists(kept()) && runs().size() >= 3; };
    const Ran cut = bench("4", options, three_done);  // three sets, twice each
    EXPECT_EQ(cut.status, 130) << cut.err;
    const auto before = runs();
    EXPECT_GE(before.size(), 3u);
    EXPECT_LT(before.size(), 6u);
    EXPECT_LT(rows("4").size(), 6u);
    ASSERT_EQ(bench("4", options).status, 0);
    const auto after = runs();
    EXPECT_EQ(after.size(), 6u);
    for (const auto& [name, time] : before) {
        ASSERT_TRUE(after.contains(name));
        EXPECT_EQ(after.at(name), time) << "run again";
    }
    ASSERT_EQ(rows("4").size(), 6u);
    EXPECT_EQ(bench("4", options).status, 0);
    EXPECT_EQ(runs(), after);
    // Another command is another run.
    EXPECT_EQ(bench("4", {"--threads", "2"}).status, 0);
    EXPECT_EQ(runs().size(), 12u);
}

TEST_F(Bench, TheLargeSetTellsTimePerPhase) {
    const Ran ran = bench("3", {"--time-limit", "60"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto all = rows("3");
    ASSERT_EQ(all.size(), 12u);
    for (const auto& row : all) {
        double phases = 0;
        for (const char* phase : {"load", "voxelize", "search", "refine", "disassemble", "reinsert"}) {
            phases += std::stod(row.at(phase));
        }
        EXPECT_GT(std::stod(row.at("search")), 0);
        EXPECT_LE(phases, std::stod(row.at("seconds")));
        if (row.at("kind") == "tray") continue;
        EXPECT_EQ(row.at("placed"), row.at("copies"));
    }
    EXPECT_GT(std::stoi(all[1].at("trays")), 1) << "many trays";
}

TEST_F(Bench, OnlyRowsThatAreAskedFor) {
    const Ran ran = bench("4", {"--rows", "pieces", "--rows", "locks, spectralpack"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    std::map<std::string, int> sets;
    for (const auto& row : rows("4")) {
        ++sets[row.at("set")];
    }
    EXPECT_EQ(sets, (std::map<std::string, int>{{"pieces", 2}, {"locks", 2}}));
}

TEST_F(Bench, AllTablesAreOneCallAndOneFile) {
    const Ran ran = bench("all", {"--rows", "tori, off", "--rows", "tori, least box"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(rows("1").size(), 2u);
    EXPECT_EQ(rows("tori").size(), 1u);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "table-2.md")) << "no row of it was wanted";
    // What another call adds stands beside it.
    ASSERT_EQ(bench("4", {"--rows", "pieces"}).status, 0);
    const std::string text = read_text(folder_ / "out" / "benchmarks.md");
    const std::size_t first = text.find("Table 1"), fourth = text.find("Table 4"), tori = text.find("Fig. 22");
    EXPECT_LT(first, fourth);
    EXPECT_LT(fourth, tori);
    EXPECT_NE(tori, std::string::npos);
    EXPECT_EQ(bench("all", {"--rows", "no such row"}).status, 2);
}

TEST_F(Bench, ToriOnAWideBaseStandWholeHoweverTheyAreKeptFromLocking) {
    const Ran ran = bench("1", {"--rows", "tori"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto all = rows("1");
    ASSERT_EQ(all.size(), 6u);  // off, place and post at two voxel sizes
    for (const auto& row : all) {
        EXPECT_EQ(row.at("kind"), "fixed");
        EXPECT_EQ(row.at("placed"), row.at("copies")) << row.at("setting");
        EXPECT_EQ(row.at("planned"), row.at("setting").starts_with("off") ? "0" : "1") << row.at("setting");
    }
}

TEST_F(Bench, LettersAndToriRun) {
    if (kSanitized) GTEST_SKIP() << "many whole runs; other tests of bench run with sanitizers";
    const Ran letters = bench("letters");
    EXPECT_EQ(letters.status, 0) << letters.err;
    EXPECT_EQ(rows("letters").size(), 1u) << "one letter, no fixed set";
    const Ran tori = bench("tori");
    EXPECT_EQ(tori.status, 0) << tori.err;
    EXPECT_GE(rows("tori").size(), 2u);
}

TEST_F(Bench, PolyhedraOfEightyAndSeventySevenAtTwoVoxelSizes) {
    if (kSanitized) GTEST_SKIP() << "many whole runs; other tests of bench run with sanitizers";
    const Ran ran = bench("polyhedra");
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto all = rows("polyhedra");
    ASSERT_EQ(all.size(), 16u);  // two numbers, two voxel sizes, off and post, tray and fixed set
    std::map<std::string, int> numbers;
    for (const auto& row : all) {
        ++numbers[row.at("set")];
        EXPECT_TRUE(contains(row.at("command"), " --rotations 30 ")) << row.at("command");
        EXPECT_TRUE(contains(row.at("command"), " --gap 0 ")) << row.at("command");
        EXPECT_EQ(row.at("planned"), contains(row.at("setting"), "post") ? "1" : "0");
        if (row.at("kind") == "tray") continue;
        EXPECT_TRUE(contains(row.at("command"), "--tray 36.98x4")) << row.at("command");
        EXPECT_EQ(row.at("placed"), row.at("copies"));
    }
    EXPECT_EQ(numbers, (std::map<std::string, int>{{"polyhedra:77", 8}, {"polyhedra:80", 8}}));
    EXPECT_TRUE(names(ran.out, {51.27, 56.37, 329})) << "the published values";
}

TEST_F(Bench, SegmentsArePackedIntoTheLeastBox) {
    const Ran ran = bench("segments", {"--rows", "90°, 5 mm"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto all = rows("segments");
    ASSERT_EQ(all.size(), 2u);
    for (const auto& row : all) {
        const bool bunny = row.at("set") == "bunny";
        EXPECT_EQ(row.at("copies"), bunny ? "13" : "12");
        EXPECT_EQ(row.at("placed"), row.at("copies"));
        EXPECT_TRUE(contains(row.at("command"), " --minimise box ")) << row.at("command");
        EXPECT_TRUE(contains(row.at("command"), " --gap 1")) << row.at("command");
        const double box = std::stod(row.at("box_volume"));
        EXPECT_NEAR(box * std::stod(row.at("density_own_box")), bunny ? 118.9e3 : 85.6e3, 500) << "of its pieces";
        char text[16];
        std::snprintf(text, sizeof text, "%.2f", box / 1e5);
        EXPECT_TRUE(contains(ran.out, text)) << text;
    }
    EXPECT_TRUE(names(ran.out, {2.90, 4.01, 19.2, 2.09, 3.67, 27.4})) << "the published values";
}

TEST_F(Bench, SetsOfAFolderArePacked) {
    fs::create_directories(folder_ / "sets");
    for (const char* name : {"pieces", "mixtures", "locks"}) {
        fs::copy_file(samples() / "samples.csv", folder_ / "sets" / (std::string(name) + ".csv"));
    }
    const std::vector<std::string> options{"--sets", (folder_ / "sets").string(), "--mesh-dir", samples().string()};
    const Ran ran = bench("4", options);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(rows("4").size(), 6u);
    const Ran missing = bench("tori", options);
    EXPECT_EQ(missing.status, 3);
    EXPECT_TRUE(names(missing.err, {"tori.csv"}));
}

TEST_F(Bench, APeerIsMeasuredByWhatItLeaves) {
    // A "packer" that places one copy: the first mesh as it is.
    const Ran ran = bench("4", {"--peer", "one=set -- {files}; cp \"$1\" {out}", "--peer", "none=true {out}"});
    EXPECT_EQ(ran.status, 1) << "a peer that leaves nothing has failed";
    EXPECT_TRUE(names(ran.err, {"none"}));
    int measured = 0;
    for (const auto& row : rows("4")) {
        if (row.at("setting") != "one") continue;
        ++measured;
        EXPECT_GT(std::stod(row.at("density_own_box")), 0);
        EXPECT_EQ(row.at("program"), "one");
    }
    EXPECT_EQ(measured, 6);
}

TEST_F(Bench, WrongUsageIsSaidBeforeAnythingRuns) {
    EXPECT_EQ(bench("7").status, 2);
    EXPECT_EQ(bench("4", {"--peer", "nothing"}).status, 2);
    EXPECT_EQ(bench("4", {"--scale", "huge"}).status, 2);
    EXPECT_EQ(bench("4", {"--time-limit", "0"}).status, 2);
    EXPECT_EQ(bench("4", {"--rows", "gold"}).status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace spectralpack::test
