#include <algorithm>
#include <set>

#include "cli/program.hpp"
#include "core/parallel.hpp"
#include "formats/packing_file.hpp"
#include "support/die_behind_sill.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

const std::string kSampleFolder = samples().string();

/// Two tori of 24 mm, a standing and a lying one, `apart` mm along y.
std::string two_tori(const TemporaryFolder& folder, double apart) {
    const auto torus = std::make_shared<const Mesh>(torus_mesh(10, 2));
    Packing packing;
    packing.container.size = packing.options.tray = {120, 80, 60};
    packing.options.voxel = 1;
    PackedPart part;
    part.name = "ring";
    part.mesh = (folder / "ring.stl").string();
    part.count = 2;
    packing.parts = {part};
    packing.trays.resize(1);
    packing.trays[0].placements = {{0, 0, 0, false, {Mat3{}, {0, 0, 0}}}};
    write_stl(packing, {torus}, part.mesh);
    const Mat3 standing{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}};
    packing.trays[0].placements = {{0, 0, 0, false, {Mat3{}, {30, 20, 20}}},
                                   {0, 1, 0, false, {standing, {30, 20 + apart, 20}}}};
    packing.metrics.copies = packing.metrics.placed = 2;
    const std::string file = (folder / "b.json").string();
    write_packing(packing, file);
    return file;
}

TEST(Plan, NamesWhatHoldsEachOther) {
    const TemporaryFolder folder;
    const std::string file = two_tori(folder, 10);
    const Ran ran = spectralpack({"plan", file});
    EXPECT_EQ(ran.status, 1) << ran.err;
    EXPECT_TRUE(contains(ran.out, "DOES NOT COME APART")) << ran.out;
    EXPECT_TRUE(names(ran.out, {"tray 1", 2, "ring #0", "ring #1"}));
    const json findings = json::parse(spectralpack({"plan", file, "--json"}).out);
    EXPECT_EQ(findings["trays"][0]["complete"], false);
    const json& set = findings["trays"][0]["interlocked"][0];
    ASSERT_EQ(set.size(), 2u);
    EXPECT_EQ(set[0]["placement"], 0);
    EXPECT_EQ(set[1]["placement"], 1);
}

TEST(Plan, WritesHowAPackingFromElsewhereComesApart) {
    const TemporaryFolder folder;
    const std::string file = two_tori(folder, 30.3), planned = (folder / "planned.json").string();
    const Ran ran = spectralpack({"plan", file, "-o", planned});
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    EXPECT_TRUE(names(ran.out, {2, "step", planned}));
    EXPECT_FALSE(contains(ran.out, "NOT")) << ran.out;
    const json plan = read_json(planned)["trays"][0]["disassembly"];
    EXPECT_EQ(plan["complete"], true);
    EXPECT_EQ(plan["steps"].size(), 2u);
}

TEST(Plan, IsTheSameForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    const std::string packed = (folder / "b.json").string();
    ASSERT_EQ(spectralpack({"pack", kSampleFolder, "--tray", "120x100x80", "--interlock", "off", "-o", packed}).status,
              0);
    json first;
    for (const std::string threads : {"1", "3"}) {
        const std::string planned = (folder / (threads + ".json")).string();
        ASSERT_LE(spectralpack({"plan", packed, "--threads", threads, "-o", planned}).status, 1);
        const json plan = read_json(planned)["trays"][0]["disassembly"];
        if (first.is_null()) first = plan;
        EXPECT_EQ(plan, first);
    }
}

/// Rays only save sweeps and floods work.
TEST(Plan, HoldsWithRaysFarApart) {
    const TemporaryFolder folder;
    const std::string packed = (folder / "b.json").string();
    const Ran ran = spectralpack({"pack", kSampleFolder, "--tray", "120x100x80", "--ray-spacing", "500", "-o", packed});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(read_json(packed)["options"]["ray-spacing"], 500);
    EXPECT_EQ(spectralpack({"check", packed, "--require-plan"}).status, 0);
    EXPECT_EQ(spectralpack({"plan", packed}).status, 0);
    const std::string fine = spectralpack({"plan", packed, "--ray-spacing", "0.01"}).err;
    EXPECT_TRUE(names(fine, {"--ray-spacing", 0.01}));
}

/// What no search of the program's finds, a plan in the file may know.
TEST(Plan, GoesByTheFilesOwnPlanWhereItFindsNoWay) {
    const TemporaryFolder folder;
    const std::vector<std::shared_ptr<const Mesh>> meshes{std::make_shared<const Mesh>(box_with_sill(1.4, 1.7)),
                                                          std::make_shared<const Mesh>(die_mesh())};
    Packing packing;
    packing.container.size = packing.options.tray = {60, 40, 40};
    packing.options.voxel = 1;
    packing.options.detail = 1;
    packing.trays.resize(1);
    for (int i = 0; i < 2; ++i) {
        PackedPart part;
        part.name = i == 0 ? "box" : "die";
        part.mesh = (folder / (part.name + ".stl")).string();
        part.count = 1;
        Packing alone;
        alone.container = packing.container;
        alone.parts = {part};
        alone.trays.resize(1);
        alone.trays[0].placements = {{0, 0, 0, false, {}}};
        write_stl(alone, {meshes[static_cast<std::size_t>(i)]}, part.mesh);
        packing.parts.push_back(part);
        packing.trays[0].placements.push_back({i, 0, 0, i == 0, {}});
    }
    packing.metrics.copies = packing.metrics.placed = 2;
    const std::string file = (folder / "b.json").string(), planned = (folder / "planned.json").string();
    write_packing(packing, file);
    EXPECT_EQ(spectralpack({"plan", file}).status, 1);

    packing.trays[0].disassembly = Disassembly{true, {{{1}, {{0, 0, 1.5}, {30, 0, 0}}}}, {}};
    write_packing(packing, file);
    const Ran ran = spectralpack({"plan", file, "-o", planned});
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    EXPECT_EQ(read_json(planned)["trays"][0]["disassembly"], read_json(file)["trays"][0]["disassembly"]);
    const json report = check_report(planned, 1);  // the file states no figures
    EXPECT_EQ(report["interlocking"], "none");
    EXPECT_EQ(report["plans"][0]["steps"], 1);
    EXPECT_TRUE(report["plans"][0]["ok"]);
}

TEST(Plan, EveryPackedCopyComesOutOnce) {
    for (const std::string interlock : {"post", "place"}) {
        const TemporaryFolder folder;
        const std::string packed = (folder / "b.json").string();
        const Ran ran = spectralpack(
            {"pack", kSampleFolder, "--tray", "120x100x80", "--gap", "0", "--interlock", interlock, "-o", packed});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const json tray = read_json(packed)["trays"][0];
        EXPECT_EQ(tray["disassembly"]["complete"], true);
        std::multiset<int> out;
        for (const json& step : tray["disassembly"]["steps"]) {
            if (step["placements"].size() == 1) out.insert(step["placements"][0].get<int>());
        }
        std::multiset<int> all;
        for (int i = 0; i < static_cast<int>(tray["placements"].size()); ++i) {
            all.insert(i);
        }
        EXPECT_EQ(out, all);
        EXPECT_EQ(spectralpack({"plan", packed}).status, 0) << interlock;
    }
}

}  // namespace
}  // namespace spectralpack::test
