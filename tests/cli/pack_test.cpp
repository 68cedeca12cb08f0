/// What pack does in the plain case: the same placements whatever the means, unusable input, copies left over.

#include <algorithm>
#include <fstream>

#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// What must not depend on threads, engine or machine.
json placements(const fs::path& packing) {
    json list = json::array();
    const json document = read_json(packing);
    for (const json& placement : document["trays"][0]["placements"]) {
        list.push_back({placement["part"], placement["copy"], placement["orientation"], placement["transform"]});
    }
    return list;
}

bool any_unplaced(const json& packing, const std::string& reason) {
    const json& unplaced = packing["unplaced"];
    return std::any_of(unplaced.begin(), unplaced.end(), [&](const json& copy) { return copy["reason"] == reason; });
}

class Pack : public testing::Test {
  protected:
    /// Packs the samples in the small tray.
    Ran pack(const std::string& name, const std::vector<std::string>& options) {
        return spectralpack(std::vector<std::string>{"pack", kSamples, "-o", at(name)} + kSmall + options);
    }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    TemporaryFolder folder_;
};

TEST_F(Pack, SaysLoudlyThatComingApartIsNotCheckedWhenItIsOff) {
    const Ran off = pack("b.json", {"--interlock", "off"});
    ASSERT_EQ(off.status, 0) << off.err;
    EXPECT_TRUE(contains(off.out, "NOT CHECKED")) << off.out;
    EXPECT_TRUE(names(off.out, {"plan", at("b.json")})) << "and what would check it";
    EXPECT_TRUE(read_json(at("b.json"))["trays"][0]["disassembly"].is_null());
    EXPECT_TRUE(contains(spectralpack({"check", at("b.json")}).out, "NOT CHECKED"));
    const Ran on = pack("b.json", {});
    EXPECT_FALSE(contains(on.out, "NOT CHECKED")) << on.out;
    const json steps = read_json(at("b.json"))["trays"][0]["disassembly"]["steps"];
    EXPECT_TRUE(names(on.out, {steps.size(), "step"}));
}

TEST_F(Pack, PlacementsDoNotDependOnThreadsMemoryOrEngine) {
    const std::vector<std::vector<std::string>> ways{{"--threads", "1"},
                                                     {"--threads", "3"},
                                                     {"--memory", "60M"},
#ifdef SPECTRALPACK_HAS_REFERENCE
                                                     {"--engine", "reference"}
#endif
    };
    json first;
    for (const auto& way : ways) {
        const Ran ran = pack("b.json", way);
        ASSERT_EQ(ran.status, 0) << ran.err;
        if (first.is_null()) {
            first = placements(at("b.json"));
            EXPECT_GT(first.size(), 3u);
        }
        EXPECT_EQ(placements(at("b.json")), first) << way[0] << ' ' << way[1];
    }
}

TEST_F(Pack, SeedDecidesTheRandomOrder) {
    const auto packed = [&](const char* seed) {
        const Ran ran = pack("b.json", {"--order", "random", "--seed", seed});
        EXPECT_EQ(ran.status, 0) << ran.err;
        return placements(at("b.json"));
    };
    const json one = packed("1");
    EXPECT_EQ(one, packed("1"));
    EXPECT_NE(one, packed("2"));
}

#ifdef SPECTRALPACK_HAS_REFERENCE
TEST_F(Pack, VerifyWithReferenceFindsNoDifference) {
    const Ran ran = pack("b.json", {"--verify-with", "reference", "--progress", "json"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json metrics = read_json(at("b.json"))["metrics"];
    const int searches = metrics["searches"], fills = metrics["interlock"]["fills"];
    EXPECT_EQ(metrics["verified"], searches + fills);
    const auto all = [&](const json& line) { return line.contains("verified") && line["verified"] == searches; };
    EXPECT_TRUE(reported(all)(ran.err)) << ran.err;
}
#endif

TEST_F(Pack, RefinedCopiesLeaveTheGridAndKeepTheGapExactly) {
    for (const char* text : {"0", "0.3"}) {
        const double gap = std::stod(text);
        const auto packed = [&](const char* refine) {
            const Ran ran = pack("b.json", {refine, "--gap", text, "--wall-gap", "0.5"});
            EXPECT_EQ(ran.status, 0) << ran.err;
            return check_report(at("b.json"), 0);
        };
        packed("--no-refine");
        const json on_grid = placements(at("b.json"));
        EXPECT_NEAR(packed("--refine")["min_gap"].get<double>(), gap, 1e-3);
        EXPECT_NEAR(read_json(at("b.json"))["metrics"]["min_gap"].get<double>(), gap, 1e-3);
        EXPECT_NE(placements(at("b.json")), on_grid);
    }
}

TEST_F(Pack, UnusableInputIsNamedAndTheRestIsPacked) {
    std::ofstream(at("broken.stl")) << "not a mesh";
    const std::vector<std::string> unusable{at("broken.stl"), at("missing.stl")};
    const Ran ran = pack("b.json", unusable);
    EXPECT_EQ(ran.status, 3) << ran.err;
    EXPECT_TRUE(names(ran.err, {"broken.stl", "missing.stl"}));
    const json packing = read_json(at("b.json"));
    EXPECT_GT(packing["metrics"]["placed"], 0);
    EXPECT_TRUE(any_unplaced(packing, "bad_file"));
    EXPECT_EQ(spectralpack({"check", at("b.json")}).status, 0);
    EXPECT_EQ(pack("b.json", unusable + std::vector<std::string>{"--skip-unusable"}).status, 0);
}

TEST_F(Pack, NothingUsableExitsWithThree) {
    std::ofstream(at("broken.stl")) << "not a mesh";
    const Ran ran = spectralpack({"pack", at("broken.stl"), "-o", at("b.json")});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"broken.stl"}));
    EXPECT_FALSE(fs::exists(at("b.json")));
}

TEST_F(Pack, LeftOverCopiesAreToldAndFailOnlyWhereAllAreRequired) {
    const Ran ran = pack("b.json", {});
    EXPECT_EQ(ran.status, 0) << ran.err;
    const json packing = read_json(at("b.json"));
    ASSERT_GT(packing["unplaced"].size(), 0u);
    const json& metrics = packing["metrics"];
    EXPECT_TRUE(
        names(ran.out, {metrics["placed"].get<int>(), metrics["copies"].get<int>(), packing["unplaced"].size()}));
    EXPECT_TRUE(names(ran.out, {100 * metrics["density"].get<double>(), "%"}));
    const Ran required = pack("b.json", {"--require-all"});
    EXPECT_EQ(required.status, 5);
    const std::string last = required.out.substr(required.out.rfind("\n\n"));
    EXPECT_TRUE(names(last, {packing["unplaced"].size(), "--require-all", 5, "--trays all"}));
}

TEST_F(Pack, APartTooLargeForTheTrayIsNamedAndListed) {
    const Ran ran = spectralpack({"pack", (samples() / "wedge.obj").string(), (samples() / "nut.stl").string(),
                                  "--tray", "60x40x30", "-o", at("b.json")});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {"wedge", 70, 26, 20, "larger than the tray", 60, 40, 30, "--printer"}));
    EXPECT_TRUE(any_unplaced(read_json(at("b.json")), "too_large"));
    // Many are one remark.
    const Ran many = spectralpack({"pack", kSamples, "--tray", "60x40x30"});
    EXPECT_TRUE(names(many.err, {11, "parts", "larger than the tray", "more"}));
    EXPECT_LT(std::count(many.err.begin(), many.err.end(), '\n'), 4) << many.err;
}

/// A run that places nothing is no success, and leaves no file that looks like one.
TEST_F(Pack, NothingPlacedIsNoSuccessAndWritesNothing) {
    const std::vector<std::string> call{
        "pack", (samples() / "wedge.obj").string(), "--tray", "20x20x20", "-o", at("b.json"), "-o", at("b.3mf")};
    const auto nothing = [&](const std::vector<std::string>& more, int status) {
        const Ran ran = spectralpack(call + more);
        EXPECT_EQ(ran.status, status) << ran.err;
        EXPECT_TRUE(fs::is_empty(folder_.path()));
        return ran;
    };
    const Ran ran = nothing({"--report", at("r.html")}, 6);
    EXPECT_TRUE(names(ran.out, {"nothing is placed", "nothing was written", "larger than the tray", 1, "wedge"}));
    EXPECT_FALSE(names(ran.out, {"comes apart"}));
    nothing({"--trays", "all"}, 6);
    nothing({"--fill"}, 6);
    nothing({"--require-all"}, 6);
    EXPECT_EQ(json::parse(nothing({"--json"}, 6).out)["metrics"]["placed"], 0);
    const std::string missing = at("missing.stl");
    nothing({missing}, 3);  // the files come first
    nothing({missing, "--skip-unusable"}, 6);
    EXPECT_EQ(spectralpack({"pack", missing, "--skip-unusable", "-o", at("b.json")}).status, 6) << "and nothing else";
}

TEST_F(Pack, NothingNewOnAnOldBuildIsNoSuccessEither) {
    ASSERT_EQ(
        spectralpack({"pack", (samples() / "nut.stl").string(), "--tray", "30x30x20", "-o", at("old.json")}).status, 0);
    const Ran ran =
        spectralpack({"pack", (samples() / "wedge.obj").string(), "--onto", at("old.json"), "-o", at("b.json")});
    EXPECT_EQ(ran.status, 6) << ran.err;
    EXPECT_FALSE(fs::exists(at("b.json")));
}

TEST_F(Pack, FilesThatCannotBeUsedAreOneList) {
    std::ofstream(at("broken.stl")) << "not a mesh";
    fs::create_directory(at("other"));
    std::ofstream(at("other/broken.stl")) << "nor this";
    const Ran ran = pack("b.json", {at("broken.stl"), at("other/broken.stl"), at("missing.stl")});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {3, "files", at("broken.stl"), at("other/broken.stl")})) << "apart by their folders";
    EXPECT_FALSE(names(ran.err, {at("missing.stl")})) << "one of its name has no folder";
    EXPECT_TRUE(names(ran.err, {"missing.stl"}));
}

}  // namespace
}  // namespace spectralpack::test
