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

TEST_F(Pack, SaysLoudlyThatInterlockingIsNotCheckedWhenItIsOff) {
    const Ran off = pack("b.json", {"--interlock", "off"});
    ASSERT_EQ(off.status, 0) << off.err;
    EXPECT_TRUE(contains(off.out, "INTERLOCK")) << off.out;
    EXPECT_TRUE(read_json(at("b.json"))["trays"][0]["disassembly"].is_null());
    EXPECT_TRUE(contains(spectralpack({"check", at("b.json")}).out, "interlocking: not checked"));
    const Ran on = pack("b.json", {});
    EXPECT_FALSE(contains(on.out, "INTERLOCK")) << on.out;
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
    EXPECT_EQ(metrics["verified"], metrics["searches"]);
    const auto all = [&](const json& line) {
        return line.contains("verified") && line["verified"] == metrics["verified"];
    };
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
    EXPECT_TRUE(any_unplaced(packing, "unusable"));
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
    EXPECT_EQ(pack("b.json", {"--require-all"}).status, 5);
}

TEST_F(Pack, APartTooLargeForTheTrayIsNamedAndListed) {
    const Ran ran = spectralpack({"pack", kSamples, "--tray", "60x40x30", "-o", at("b.json")});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {"wedge", 70, 26, 20, 60, 40, 30, "--printer"}));
    EXPECT_TRUE(any_unplaced(read_json(at("b.json")), "too_large"));
}

}  // namespace
}  // namespace spectralpack::test
