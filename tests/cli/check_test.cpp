/// The command check, end to end. What it judges and how is tested in verify/.

#include <fstream>

#include "cli/packed_cubes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

class Check : public PackedCubes {
  protected:
    Ran check() {
        measure();
        write();
        return spectralpack({"check", file()});
    }

    /// Fails with this finding about these copies, and names each by its part and number, as text and as JSON.
    void expect_finding(const std::string& kind, const std::vector<int>& copies) {
        const Ran ran = spectralpack({"check", file()});
        EXPECT_EQ(ran.status, 1) << ran.err;
        const json report = check_report(file(), 1);
        EXPECT_FALSE(report["ok"]);
        ASSERT_EQ(report["findings"].size(), 1u) << report;
        const json& finding = report["findings"][0];
        EXPECT_EQ(finding["kind"], kind);
        EXPECT_EQ(finding["placements"], json(copies));
        for (const int copy : copies) {
            EXPECT_TRUE(names(finding["message"], {std::to_string(copy + 1) + " cube"}));
        }
        EXPECT_TRUE(contains(ran.out, finding["message"])) << ran.out;
    }

    void expect_finding_once_measured(const std::string& kind, const std::vector<int>& copies) {
        measure();
        write();
        expect_finding(kind, copies);
    }
};

TEST_F(Check, AcceptsTouchingAtGapZero) {
    const Ran ran = check();
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    EXPECT_TRUE(names(ran.out, {"gap", 0, 3, "copies"}));
    const json report = check_report(file(), 0);
    EXPECT_TRUE(report["ok"]);
    EXPECT_EQ(report["min_gap"], 0);
    EXPECT_EQ(report["copies"], 3);
}

TEST_F(Check, NamesTwoCopiesThatOverlapByHalfAMillimetre) {
    transform(1).translation.x -= 0.5;
    expect_finding_once_measured("overlap", {0, 1});
}

TEST_F(Check, NamesACopyThatSticksOut) {
    transform(2).translation = {95, 20, 20};
    expect_finding_once_measured("outside", {2});
}

TEST_F(Check, NamesAMirroredCopy) {
    transform(2).linear.rows[0].x = -1;
    transform(2).translation = {60, 20, 20};
    expect_finding_once_measured("transform", {2});
}

TEST_F(Check, NoticesAMisstatedDensity) {
    measure();
    packing_.trays[0].density += 0.01;
    write();
    expect_finding("density", {});
}

TEST_F(Check, NoticesTooSmallAGap) {
    transform(1).translation.x = 10.5;
    transform(2).translation.x = 40;
    packing_.parts[0].gap = packing_.options.gap = 1;
    expect_finding_once_measured("gap", {0, 1});
}

TEST_F(Check, AnUnreadablePackingExitsWithThreeAndNamesThePlace) {
    check();
    json broken = read_json(file());
    broken["trays"][0]["placements"][1]["transform"] = "nowhere";
    std::ofstream(file()) << broken;
    const Ran ran = spectralpack({"check", file()});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"b.json", "placements[1].transform"}));
    std::filesystem::create_directory(folder_ / "moved");
    write();
    std::filesystem::copy_file(file(), folder_ / "moved" / "b.json");
    const Ran moved = spectralpack({"check", (folder_ / "moved" / "b.json").string()});
    EXPECT_EQ(moved.status, 3);
    EXPECT_TRUE(names(moved.err, {"cube.stl", "b.json", "relative"}));
    const Ran missing = spectralpack({"check", (folder_ / "missing.json").string()});
    EXPECT_EQ(missing.status, 3);
    EXPECT_TRUE(names(missing.err, {"missing.json"}));
}

TEST_F(Check, RequirePlanFailsAsLongAsThereIsNone) {
    EXPECT_TRUE(contains(check().out, "NOT CHECKED"));
    EXPECT_EQ(check_report(file(), 0)["interlocking"], "not checked");
    const Ran required = spectralpack({"check", "--require-plan", file()});
    EXPECT_EQ(required.status, 1);
    EXPECT_TRUE(names(required.out, {"FAULT", "no plan", "1 fault"}));
    const Ran as_json = spectralpack({"check", "--require-plan", "--json", file()});
    EXPECT_EQ(as_json.status, 1);
    const json report = json::parse(as_json.out);
    EXPECT_EQ(report["ok"], false);
    ASSERT_EQ(report["findings"].size(), 1u);
    EXPECT_EQ(report["findings"][0]["kind"], "plan");
}

TEST_F(Check, ReplaysThePlan) {
    plan() = {true, {{{2}, {{10, 0, 0}}}, {{1}, {{0, 0, 4}, {0, 0, 6}}}, {{0}, {}}}, {}};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 0) << ran.out;
    EXPECT_TRUE(names(ran.out, {"tray", 1, "comes apart", 3, "steps"}));
    EXPECT_EQ(spectralpack({"check", "--require-plan", file()}).status, 0);
    const json report = check_report(file(), 0);
    EXPECT_EQ(report["interlocking"], "none");
    EXPECT_EQ(report["plans"][0]["steps"], 3);
    EXPECT_TRUE(report["plans"][0]["complete"]);
}

TEST_F(Check, NamesTheStepThatFails) {
    plan() = {true, {{{1}, {{30, 0, 0}}}, {{2}, {{10, 0, 0}}}, {{0}, {}}}, {}};
    check();
    expect_finding("plan", {1, 2});
    const json report = check_report(file(), 1);
    EXPECT_TRUE(names(report["findings"][0]["message"], {"step", 1}));
    EXPECT_EQ(report["plans"][0]["failed_steps"], json::array({0}));
}

TEST_F(Check, ToldLoudlyWhereAPlanIsIncomplete) {
    plan() = {false, {{{2}, {{10, 0, 0}}}}, {{0, 1}}};
    EXPECT_TRUE(names(check().out, {"DOES NOT COME APART", "hold each other", "1 cube", "2 cube"}));
    plan()->interlocked.clear();
    const Ran ran = check();
    EXPECT_EQ(ran.status, 0) << ran.out;
    EXPECT_TRUE(contains(ran.out, "NOT CHECKED")) << ran.out;
    EXPECT_TRUE(names(ran.out, {"1 cube", "2 cube"}));
    EXPECT_FALSE(names(ran.out, {"comes apart in"}));
    const json report = check_report(file(), 0);
    EXPECT_EQ(report["plans"][0]["without_step"], json({0, 1}));
    EXPECT_NE(report["interlocking"], "none");
    const Ran required = spectralpack({"check", "--require-plan", file()});
    EXPECT_EQ(required.status, 1);
    EXPECT_TRUE(names(required.out, {"FAULT", "the plan leaves 1 cube, 2 cube", "1 fault"}));
}

TEST_F(Check, APlanForCopiesThatAreNotThereExitsWithThree) {
    plan() = {true, {{{3}, {}}}, {}};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"b.json", "trays[0].disassembly.steps[0].placements[0]"}));
}

TEST_F(Check, SaysThatNothingIsPlaced) {
    packing_.trays[0].placements.clear();
    packing_.parts[0].count = 0;
    packing_.metrics.copies = packing_.metrics.placed = 0;
    const Ran ran = check();
    EXPECT_EQ(ran.status, 6) << ran.out;
    EXPECT_TRUE(names(ran.out, {"nothing is placed"}));
    EXPECT_FALSE(names(ran.out, {"comes apart"}));
    const Ran planned = spectralpack({"plan", file()});
    EXPECT_EQ(planned.status, 6) << planned.out;
    EXPECT_TRUE(names(planned.out, {"nothing is placed"}));
}

TEST_F(Check, CountsTraysFromOne) {
    packing_.trays.push_back(packing_.trays[0]);
    packing_.parts[0].count = 6;
    packing_.metrics.copies = packing_.metrics.placed = 6;
    for (int copy = 0; copy < 3; ++copy) {
        packing_.trays[1].placements[static_cast<std::size_t>(copy)].copy = copy + 3;
    }
    packing_.trays[1].placements[0].transform.translation.x = -5;
    const Ran ran = check();
    EXPECT_TRUE(names(ran.out, {"tray 1:", "tray 2:", "tray 2: 4 cube"})) << ran.out;
    EXPECT_FALSE(names(ran.out, {"tray 0"})) << ran.out;
}

}  // namespace
}  // namespace spectralpack::test
