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
    EXPECT_TRUE(names(ran.out, {"tray 1", 2, "1 ring", "2 ring"}));
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
    const json plan = read_json(planned)["trays"][0]["disassembly"];
    EXPECT_EQ(plan["steps"], read_json(file)["trays"][0]["disassembly"]["steps"]);
    EXPECT_EQ(plan["through_walls"], json::array({0}));  // it leads out sideways
    const json report = check_report(planned, 1);        // the file states no figures
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

/// Where a copy's box ends in the tray as its step's path has been gone.
double top_before(const json& tray, const json& step) {
    double top = 0;
    for (const json& i : step["placements"]) {
        top = std::max(top, tray["placements"][i.get<std::size_t>()]["transform"][2][3].get<double>());
    }
    return top;
}

TEST(Plan, GoesFromTheTopDownInABox) {
    const TemporaryFolder folder;
    write_stl(cube_mesh(10), folder / "cube.stl");
    const std::string packed = (folder / "b.json").string(), planned = (folder / "p.json").string();
    const Ran ran = spectralpack({"pack", (folder / "cube.stl").string() + ":27", "--tray", "34x34x34", "-o", packed});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {27, "steps"}));
    EXPECT_FALSE(contains(ran.out, "through the walls")) << ran.out;
    EXPECT_EQ(read_json(packed)["options"]["unpack"], "top");
    const json tray = read_json(packed)["trays"][0], plan = tray["disassembly"];
    EXPECT_EQ(plan["unpack"], "top");
    EXPECT_EQ(plan["through_walls"], json::array());
    ASSERT_EQ(plan["steps"].size(), 27u);
    double last = 100;
    for (const json& step : plan["steps"]) {
        EXPECT_LE(top_before(tray, step), last + 1e-9);
        last = top_before(tray, step);
        ASSERT_EQ(step["path"].size(), 1u);
        EXPECT_GT(step["path"][0][2], 0);
    }
    EXPECT_EQ(check_report(packed, 0)["plans"][0]["unpack"], "top");

    // Likewise `plan`, unless it is told otherwise, and for files that know nothing of it.
    json old = read_json(packed);
    old["options"].erase("unpack");
    for (const char* key : {"unpack", "through_walls"}) {
        old["trays"][0]["disassembly"].erase(key);
    }
    std::ofstream(folder / "old.json") << old;
    ASSERT_EQ(spectralpack({"check", (folder / "old.json").string(), "--require-plan"}).status, 0);
    ASSERT_EQ(spectralpack({"plan", (folder / "old.json").string(), "-o", planned}).status, 0);
    EXPECT_EQ(read_json(planned)["trays"][0]["disassembly"], plan);
    ASSERT_EQ(spectralpack({"plan", packed, "--unpack", "any", "-o", planned}).status, 0);
    EXPECT_EQ(read_json(planned)["trays"][0]["disassembly"]["unpack"], "any");
    EXPECT_EQ(spectralpack({"plan", packed, "--unpack", "up"}).status, 2);
}

/// The same copies stand in the same places, and all still comes apart.
TEST(Plan, OrderChangesNoPlacement) {
    const TemporaryFolder folder;
    json placements;
    for (const std::string unpack : {"any", "top"}) {
        for (const std::vector<std::string>& tray :
             {std::vector<std::string>{"--tray", "120x100x80"}, {"--tray", "120x100", "--open-height"}}) {
            const std::string packed = (folder / (unpack + tray.back() + ".json")).string();
            std::vector<std::string> arguments{"pack", kSampleFolder, "--unpack", unpack, "-o", packed};
            arguments.insert(arguments.end(), tray.begin(), tray.end());
            const Ran ran = spectralpack(arguments);
            ASSERT_EQ(ran.status, 0) << ran.err;
            const json build = read_json(packed);
            EXPECT_EQ(build["trays"][0]["disassembly"]["unpack"], unpack);
            json& known = placements[tray.back()];
            if (known.is_null()) known = build["trays"][0]["placements"];
            EXPECT_EQ(build["trays"][0]["placements"], known);
            const Ran checked = spectralpack({"check", packed, "--require-plan"});
            EXPECT_EQ(checked.status, 0) << checked.out;
        }
    }
}

/// A die in a box whose only door is a side of it, against the tray's wall.
TEST(Plan, SaysWhatLeavesThroughTheWalls) {
    const TemporaryFolder folder;
    Packing packing;
    packing.container.size = packing.options.tray = {24, 20, 20};
    packing.options.voxel = 1;
    packing.trays.resize(1);
    Mesh shelf = box_mesh({0, 0, 0}, {20, 20, 6});
    shelf = merged(shelf, box_mesh({0, 0, 12}, {20, 20, 20}));
    shelf = merged(shelf, box_mesh({0, 0, 6}, {12, 20, 12}));
    const std::vector<Mesh> meshes{shelf, box_mesh({12, 7, 6}, {24, 13, 12})};
    for (int i = 0; i < 2; ++i) {
        PackedPart part;
        part.name = i == 0 ? "shelf" : "die";
        part.mesh = (folder / (part.name + ".stl")).string();
        part.count = 1;
        write_stl(meshes[static_cast<std::size_t>(i)], part.mesh);
        packing.parts.push_back(part);
        packing.trays[0].placements.push_back({i, 0, 0, i == 0, {}});
    }
    packing.metrics.copies = packing.metrics.placed = 2;
    const std::string file = (folder / "b.json").string(), planned = (folder / "planned.json").string();
    write_packing(packing, file);
    const Ran ran = spectralpack({"plan", file, "-o", planned});
    ASSERT_EQ(ran.status, 0) << ran.out << ran.err;
    EXPECT_TRUE(contains(ran.out, "1 of them sideways through the walls")) << ran.out;
    EXPECT_EQ(read_json(planned)["trays"][0]["disassembly"]["through_walls"], json::array({0}));
    const json report = check_report(planned, 1);  // the file states no figures
    EXPECT_TRUE(report["plans"][0]["ok"]);
    EXPECT_EQ(report["plans"][0]["through_walls"], 1);
    EXPECT_TRUE(contains(spectralpack({"check", planned}).out, "1 of them sideways through the walls"));
    EXPECT_FALSE(contains(spectralpack({"plan", file, "--unpack", "any"}).out, "walls"));
}

}  // namespace
}  // namespace spectralpack::test
