#include <fstream>

#include "cli/program.hpp"
#include "core/parallel.hpp"
#include "formats/packing_file.hpp"
#include "packing/measure.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

/// A packing file of cubes of 10 mm written by hand, so that faults can be planted.
class Check : public testing::Test {
  protected:
    Check() {
        mesh_ = std::make_shared<const Mesh>(cube_mesh(10));
        Packing cubes;
        cubes.container.size = {100, 100, 100};
        cubes.trays.resize(1);
        cubes.parts.resize(1);
        cubes.trays[0].placements = {{0, 0, 0, false, {Mat3{}, {0, 0, 0}}}};
        write_stl(cubes, {mesh_}, folder_ / "cube.stl");

        packing_.container.size = {100, 50, 40};
        packing_.options.tray = packing_.container.size;
        packing_.options.gap = 0;
        PackedPart part;
        part.name = "cube";
        part.mesh = (folder_ / "cube.stl").string();
        part.count = 3;
        part.volume = 1000;
        packing_.parts = {part};
        packing_.trays.resize(1);
        for (int copy = 0; copy < 3; ++copy) {
            packing_.trays[0].placements.push_back({0, copy, 0, false, {Mat3{}, {10.0 * copy, 0, 0}}});
        }
        packing_.metrics.copies = packing_.metrics.placed = 3;
    }

    Ran check(bool remeasure = true) {
        if (remeasure) {
            measure_tray(packing_.trays[0], packing_.container, packing_.parts, {mesh_}, 2, Workers(1));
            packing_.metrics.density = packing_.trays[0].density;
        }
        write_packing(packing_, folder_ / "b.json");
        return spectralpack({"check", (folder_ / "b.json").string()});
    }

    Transform& transform(std::size_t copy) { return packing_.trays[0].placements[copy].transform; }

    TemporaryFolder folder_;
    std::shared_ptr<const Mesh> mesh_;
    Packing packing_;
};

TEST_F(Check, AcceptsTouchingAtGapZero) {
    const Ran ran = check();
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    EXPECT_TRUE(contains(ran.out, "least gap: 0 mm")) << ran.out;
}

TEST_F(Check, NamesTwoCopiesThatOverlapByHalfAMillimetre) {
    transform(1).translation.x -= 0.5;
    const Ran ran = check();
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(contains(ran.out, "cube #0")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "cube #1")) << ran.out;
    EXPECT_FALSE(contains(ran.out, "cube #2")) << ran.out;
}

TEST_F(Check, NamesACopyThatSticksOut) {
    transform(2).translation = {95, 20, 20};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(contains(ran.out, "cube #2")) << ran.out;
    EXPECT_FALSE(contains(ran.out, "cube #0")) << ran.out;
}

TEST_F(Check, NamesAMirroredCopy) {
    transform(2).linear.rows[0].x = -1;
    transform(2).translation = {60, 20, 20};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(contains(ran.out, "cube #2")) << ran.out;
}

TEST_F(Check, NoticesAMisstatedDensity) {
    check();
    packing_.trays[0].density += 0.01;
    const Ran ran = check(false);
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(contains(ran.out, "density")) << ran.out;
}

TEST_F(Check, NoticesTooSmallAGap) {
    transform(1).translation.x = 10.5;
    transform(2).translation.x = 40;
    packing_.parts[0].gap = packing_.options.gap = 1;
    const Ran ran = check();
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(contains(ran.out, "cube #1")) << ran.out;
    EXPECT_FALSE(contains(ran.out, "cube #2")) << ran.out;
}

TEST_F(Check, ReportsAsJson) {
    transform(1).translation.x -= 0.5;
    check();
    const Ran ran = spectralpack({"check", "--json", (folder_ / "b.json").string()});
    EXPECT_EQ(ran.status, 1);
    const json report = json::parse(ran.out);
    EXPECT_FALSE(report["ok"]);
    EXPECT_EQ(report["findings"][0]["kind"], "overlap");
    EXPECT_EQ(report["findings"][0]["placements"], json({0, 1}));
}

TEST_F(Check, AnUnreadablePackingExitsWithThreeAndNamesThePlace) {
    check();
    json broken = read_json(folder_ / "b.json");
    broken["trays"][0]["placements"][1]["transform"] = "nowhere";
    std::ofstream(folder_ / "b.json") << broken;
    const Ran ran = spectralpack({"check", (folder_ / "b.json").string()});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(contains(ran.err, "placements[1].transform")) << ran.err;
    EXPECT_EQ(spectralpack({"check", (folder_ / "missing.json").string()}).status, 3);
}

TEST_F(Check, RequirePlanFailsAsLongAsThereIsNone) {
    EXPECT_TRUE(contains(check().out, "interlocking: not checked"));
    EXPECT_EQ(spectralpack({"check", "--require-plan", (folder_ / "b.json").string()}).status, 1);
}

TEST_F(Check, ReplaysThePlan) {
    packing_.trays[0].disassembly = {true, {{{2}, {{10, 0, 0}}}, {{1}, {{0, 0, 4}, {0, 0, 6}}}, {{0}, {}}}, {}};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 0) << ran.out;
    EXPECT_TRUE(contains(ran.out, "plan: 3 steps replayed, ok\ninterlocking: none")) << ran.out;
    EXPECT_EQ(spectralpack({"check", "--require-plan", (folder_ / "b.json").string()}).status, 0);
    const json report = json::parse(spectralpack({"check", "--json", (folder_ / "b.json").string()}).out);
    EXPECT_EQ(report["interlocking"], "none");
    EXPECT_EQ(report["plans"][0]["steps"], 3);
    EXPECT_TRUE(report["plans"][0]["complete"]);
}

TEST_F(Check, NamesTheStepThatFails) {
    packing_.trays[0].disassembly = {true, {{{1}, {{30, 0, 0}}}, {{2}, {{10, 0, 0}}}, {{0}, {}}}, {}};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(contains(ran.out, "FAILED: plan, step 1 of 3: cube #1 runs into cube #2, at least ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "plan: 3 steps replayed, 1 failed")) << ran.out;
    const json report = json::parse(spectralpack({"check", "--json", (folder_ / "b.json").string()}).out);
    EXPECT_EQ(report["findings"][0]["kind"], "plan");
    EXPECT_EQ(report["findings"][0]["placements"], json({1, 2}));
    EXPECT_EQ(report["plans"][0]["failed_steps"], json::array({0}));
}

TEST_F(Check, ToldLoudlyWhereAPlanIsIncomplete) {
    packing_.trays[0].disassembly = {false, {{{2}, {{10, 0, 0}}}}, {{0, 1}}};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 0) << ran.out;
    EXPECT_TRUE(contains(ran.out, "INCOMPLETE: no way out for cube #0, cube #1")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "NOT EXCLUDED")) << ran.out;
    const Ran required = spectralpack({"check", "--require-plan", (folder_ / "b.json").string()});
    EXPECT_EQ(required.status, 1);
    EXPECT_TRUE(contains(required.err, "no complete disassembly plan")) << required.err;
}

TEST_F(Check, APlanForCopiesThatAreNotThereExitsWithThree) {
    packing_.trays[0].disassembly = {true, {{{3}, {}}}, {}};
    const Ran ran = check();
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(contains(ran.err, "trays[0].disassembly.steps[0].placements[0]")) << ran.err;
}

TEST_F(Check, RenderDrawsHowItComesApart) {
    check();
    const auto render = [&](std::vector<std::string> options, const std::string& name) {
        options.insert(options.begin(),
                       {"render", (folder_ / "b.json").string(), "-o", (folder_ / name).string(), "--size", "120x90"});
        return spectralpack(options);
    };
    const Ran without = render({"--explode", "1"}, "none.png");
    EXPECT_EQ(without.status, 2);
    EXPECT_TRUE(contains(without.err, "no disassembly plan")) << without.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "none.png"));
    packing_.trays[0].disassembly = {true, {{{2}, {{10, 0, 0}}}, {{1}, {{10, 0, 0}}}, {{0}, {}}}, {}};
    check();
    EXPECT_EQ(render({}, "whole.png").status, 0);
    EXPECT_EQ(render({"--step", "0"}, "0.png").status, 0);
    EXPECT_EQ(render({"--step", "1"}, "1.png").status, 0);
    EXPECT_EQ(render({"--step", "3", "--tray", "0"}, "3.png").status, 0);
    EXPECT_EQ(render({"--explode", "0.5"}, "apart.png").status, 0);
    EXPECT_EQ(read_text(folder_ / "0.png"), read_text(folder_ / "whole.png"));
    EXPECT_NE(read_text(folder_ / "1.png"), read_text(folder_ / "whole.png"));
    EXPECT_NE(read_text(folder_ / "apart.png"), read_text(folder_ / "whole.png"));
    EXPECT_EQ(render({"--step", "4"}, "none.png").status, 2);
    EXPECT_EQ(render({"--step", "-1"}, "none.png").status, 2);
    EXPECT_EQ(render({"--explode", "-1"}, "none.png").status, 2);
    EXPECT_EQ(render({"--explode", "1", "--step", "1"}, "none.png").status, 2);
}

TEST_F(Check, RenderDrawsThePacking) {
    check();
    const auto picture = folder_ / "b.png";
    const Ran ran =
        spectralpack({"render", (folder_ / "b.json").string(), "-o", picture.string(), "--size", "320x240"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_GT(std::filesystem::file_size(picture), 1000u);
}

}  // namespace
}  // namespace spectralpack::test
