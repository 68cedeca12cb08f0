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
        Part part;
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
    check();
    EXPECT_EQ(spectralpack({"check", "--require-plan", (folder_ / "b.json").string()}).status, 1);
}

TEST_F(Check, RenderDrawsThePacking) {
    check();
    const auto picture = folder_ / "b.png";
    const Ran ran = spectralpack({"render", (folder_ / "b.json").string(), "-o", picture.string(), "--size", "320x240"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_GT(std::filesystem::file_size(picture), 1000u);
}

}  // namespace
}  // namespace spectralpack::test
