/// Many trays, containers of any shape, keep-outs, fixed copies and printers, on the built program.

#include <fstream>

#include "cli/program.hpp"
#include "formats/packing_file.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class WholeJob : public testing::Test {
  protected:
    WholeJob() {
        stl("cube.stl", cube_mesh(10));
        stl("slab.stl", box_mesh({0, 0, 0}, {40, 40, 10}));
    }

    void stl(const std::string& name, const Mesh& mesh) { write_stl(mesh, folder_ / name); }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    /// Packs into build.json at 2 mm without gaps.
    Ran pack(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "pack");
        for (const char* more : {"--gap", "0", "--threads", "1", "-o"}) {
            arguments.emplace_back(more);
        }
        arguments.push_back(at("build.json"));
        return spectralpack(arguments);
    }

    json build() const { return read_json(folder_ / "build.json"); }

    void expect_sound() {
        const Ran checked = spectralpack({"check", at("build.json")});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    }

    TemporaryFolder folder_;
};

/// An L of 40 x 40 x 20 mm with arms of 20 mm.
Mesh angle_mesh() {
    Mesh mesh;
    const Vec3 corners[] = {{0, 0, 0}, {40, 0, 0}, {40, 20, 0}, {20, 20, 0}, {20, 40, 0}, {0, 40, 0}};
    for (const double z : {0.0, 20.0}) {
        for (const Vec3& corner : corners) {
            mesh.vertices.push_back({corner.x, corner.y, z});
        }
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t j = (i + 1) % 6;
        mesh.triangles.push_back({i, j, j + 6});
        mesh.triangles.push_back({i, j + 6, i + 6});
    }
    const Triangle faces[] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    for (const Triangle& f : faces) {
        mesh.triangles.push_back({f[0], f[2], f[1]});
        mesh.triangles.push_back({f[0] + 6, f[1] + 6, f[2] + 6});
    }
    return mesh;
}

TEST_F(WholeJob, FillsAsManyTraysAsItTakes) {
    const std::string model = at("build.3mf");
    const Ran ran = pack({at("cube.stl") + ":20", "--tray", "20x20x20", "--trays", "all", "-o", model, "-o",
                          at("build.csv"), "--report", at("r.html")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "3 containers")) << ran.out;
    const json packing = build();
    ASSERT_EQ(packing["trays"].size(), 3u);
    EXPECT_EQ(packing["trays"][0]["placements"].size(), 8u);
    EXPECT_EQ(packing["trays"][2]["placements"].size(), 4u);
    EXPECT_NEAR(packing["trays"][2]["density"], 0.5, 1e-9);
    EXPECT_NEAR(packing["metrics"]["density"], 2.5 / 3, 1e-9);
    EXPECT_EQ(packing["metrics"]["placed"], 20);
    EXPECT_EQ(packing["options"]["trays"], "all");
    expect_sound();
    for (const char* name : {"build-1.3mf", "build-2.3mf", "build-3.3mf", "build.3mf", "build-3.csv"}) {
        EXPECT_TRUE(fs::exists(folder_ / name)) << name;
        EXPECT_TRUE(contains(ran.out, at(name))) << ran.out;
    }
    EXPECT_FALSE(fs::exists(folder_ / "build-4.3mf"));
    EXPECT_TRUE(contains(read_text(folder_ / "r.html"), "83.3 %"));
}

TEST_F(WholeJob, LeavesOverWhatTheTraysDoNotHold) {
    const Ran ran = pack({at("cube.stl") + ":20", "--tray", "20x20x20", "--trays", "2"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(build()["trays"].size(), 2u);
    EXPECT_EQ(build()["unplaced"].size(), 4u);
    expect_sound();
}

TEST_F(WholeJob, PriorityAndDueDateDecideWhoGoesFirst) {
    std::ofstream(at("job.json")) << json{{"format", "spectralpack/job"},
                                          {"version", 1},
                                          {"container", {{"size", {40, 40, 10}}}},
                                          {"trays", "all"},
                                          {"gap", 0},
                                          {"parts",
                                           {{{"name", "late"}, {"mesh", "slab.stl"}},
                                            {{"name", "soon"}, {"mesh", "slab.stl"}, {"due", "2026-11-30"}},
                                            {{"name", "small"}, {"mesh", "cube.stl"}, {"priority", 1}}}}};
    ASSERT_EQ(spectralpack({"pack", at("job.json"), "-o", at("build.json")}).status, 0);
    const json packing = build();
    ASSERT_EQ(packing["trays"].size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto part = packing["trays"][i]["placements"][0]["part"].get<std::size_t>();
        EXPECT_EQ(packing["parts"][part]["name"], (std::vector{"small", "soon", "late"}[i]));
    }
}

TEST_F(WholeJob, ATrayThatStaysEmptyIsAnErrorAndTheOthersAreKept) {
    stl("angle.stl", angle_mesh());
    // The slab fits the container's box, not the container.
    const Ran ran = pack({at("slab.stl"), at("cube.stl"), "--container", at("angle.stl"), "--trays", "all"});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(contains(ran.err, "tray 2 stays empty")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "slab")) << ran.err;
    EXPECT_EQ(build()["trays"].size(), 1u);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 1u);
    EXPECT_EQ(build()["unplaced"].size(), 1u);
}

TEST_F(WholeJob, FillsAMesh) {
    stl("angle.stl", angle_mesh());
    const Ran ran = pack({at("cube.stl") + ":30", "--container", at("angle.stl"), "-o", at("build.png")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = build();
    EXPECT_EQ(packing["metrics"]["placed"], 24);
    EXPECT_NEAR(packing["metrics"]["density"], 1, 1e-6);
    EXPECT_EQ(packing["container"]["mesh"], "angle.stl");
    EXPECT_EQ(packing["container"]["size"], json({40, 40, 20}));
    expect_sound();
    EXPECT_GT(fs::file_size(folder_ / "build.png"), 1000u);
    // A copy in the notch is inside the box and outside the container.
    json moved = packing;
    for (int axis = 0; axis < 3; ++axis) {
        moved["trays"][0]["placements"][0]["transform"][axis] = json::array({0, 0, 0, 27});
        moved["trays"][0]["placements"][0]["transform"][axis][axis] = 1;
    }
    moved["trays"][0]["placements"][0]["transform"][2][3] = 0;
    std::ofstream(at("build.json")) << moved;
    const Ran checked = spectralpack({"check", at("build.json")});
    EXPECT_EQ(checked.status, 1);
    EXPECT_TRUE(contains(checked.out, "the outside of the container")) << checked.out;
}

struct Vec2 {
    double x = 0, z = 0;
};

/// A bottle's inside: 40 x 20 mm and 20 high, then a neck of 16 x 20 mm up to 40.
Mesh bottle_mesh() {
    const Vec2 corners[] = {{0, 0}, {40, 0}, {40, 20}, {28, 20}, {28, 40}, {12, 40}, {12, 20}, {0, 20}};
    const Triangle faces[] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 6}, {0, 6, 7}, {6, 3, 4}, {6, 4, 5}};  // seen from -y
    Mesh mesh;
    for (const double y : {0.0, 20.0}) {
        for (const Vec2& corner : corners) {
            mesh.vertices.push_back({corner.x, y, corner.z});
        }
    }
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::uint32_t j = (i + 1) % 8;
        mesh.triangles.push_back({i, j + 8, j});
        mesh.triangles.push_back({i, i + 8, j + 8});
    }
    for (const Triangle& f : faces) {
        mesh.triangles.push_back(f);
        mesh.triangles.push_back({f[0] + 8, f[2] + 8, f[1] + 8});
    }
    return mesh;
}

double top_of(const json& packing, const json& step) {
    double z = packing["trays"][0]["placements"][step["placements"][0].get<std::size_t>()]["transform"][2][3];
    for (const json& move : step["path"]) {
        z += move[2].get<double>();
    }
    return z;
}

TEST_F(WholeJob, WhatLeavesABottleLeavesThroughItsNeck) {
    stl("bottle.stl", bottle_mesh());
    const std::vector<std::string> options{at("cube.stl") + ":6", "--container", at("bottle.stl"), "--no-refine"};
    ASSERT_EQ(pack(options).status, 0);
    json packing = build();
    EXPECT_EQ(packing["metrics"]["placed"], 6);
    expect_sound();
    // That plan goes through the walls.
    packing["container"]["physical"] = true;
    std::ofstream(at("through.json")) << packing;
    const Ran through = spectralpack({"check", at("through.json")});
    EXPECT_EQ(through.status, 1);
    EXPECT_TRUE(contains(through.out, "runs into the container")) << through.out;

    for (const char* interlock : {"post", "place"}) {
        std::vector<std::string> physical = options;
        physical.insert(physical.end(), {"--physical", "--interlock", interlock});
        const Ran ran = pack(physical);
        ASSERT_EQ(ran.status, 0) << ran.err;
        packing = build();
        EXPECT_EQ(packing["metrics"]["placed"], 6);
        EXPECT_TRUE(packing["container"]["physical"]);
        ASSERT_EQ(packing["trays"][0]["disassembly"]["steps"].size(), 6u);
        bool corners = false;
        for (const json& step : packing["trays"][0]["disassembly"]["steps"]) {
            EXPECT_GE(top_of(packing, step), 40);
            corners = corners || step["path"].size() > 1;
        }
        EXPECT_TRUE(corners) << "from beside the neck";
        const Ran checked = spectralpack({"check", at("build.json"), "--require-plan"});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
        EXPECT_EQ(spectralpack({"plan", at("build.json"), "--voxel", "1", "-o", at("planned.json")}).status, 0);
        EXPECT_EQ(spectralpack({"check", at("planned.json"), "--require-plan"}).status, 0);
    }
}

TEST_F(WholeJob, WhatIsTooWideForTheNeckStaysOut) {
    stl("bottle.stl", bottle_mesh());
    stl("wide.stl", cube_mesh(18));
    const std::vector<std::string> options{at("wide.stl"), at("cube.stl") + ":2", "--container", at("bottle.stl")};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), options.begin(), options.end());
        return pack(more);
    };
    ASSERT_EQ(with({}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 3);
    ASSERT_EQ(with({"--physical", "--interlock", "off"}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 3);
    const Ran planned = spectralpack({"plan", at("build.json")});
    EXPECT_EQ(planned.status, 1);
    EXPECT_TRUE(contains(planned.out, "1 hold each other or cannot leave the container: wide copy 0")) << planned.out;
    const char* reasons[] = {"interlocked", "tray_full"};
    for (const char* interlock : {"post", "place"}) {
        ASSERT_EQ(with({"--physical", "--interlock", interlock}).status, 0);
        EXPECT_EQ(build()["metrics"]["placed"], 2);
        ASSERT_EQ(build()["unplaced"].size(), 1u);
        EXPECT_EQ(build()["unplaced"][0]["reason"], reasons[interlock == std::string("place")]);
        EXPECT_EQ(spectralpack({"check", at("build.json"), "--require-plan"}).status, 0);
    }
}

TEST_F(WholeJob, ACrateIsLeftUpwardsAndRoundItsKeepOuts) {
    for (const char* gap : {"0", "1.5"}) {
        const Ran ran = pack({at("cube.stl") + ":12", "--tray", "44x44x44", "--physical", "--keep-out",
                              "14,0,22,44,44,26", "--wall-gap", gap});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const json packing = build();
        EXPECT_EQ(packing["metrics"]["placed"], 12);
        for (const json& step : packing["trays"][0]["disassembly"]["steps"]) {
            EXPECT_GE(top_of(packing, step), 44);
        }
        const Ran checked = spectralpack({"check", at("build.json"), "--require-plan"});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    }
}

TEST_F(WholeJob, AContainerThatNothingCanLeaveIsNamed) {
    stl("tube.stl", torus_mesh(40, 18, 48, 24));
    const Ran closed = pack({at("cube.stl"), "--container", at("tube.stl"), "--physical"});
    EXPECT_EQ(closed.status, 3);
    EXPECT_TRUE(contains(closed.err, "tube.stl") && contains(closed.err, "no flat face at its top")) << closed.err;
    EXPECT_EQ(pack({at("cube.stl"), "--container", at("tube.stl"), "--physical", "--interlock", "off"}).status, 0);
    EXPECT_EQ(pack({at("cube.stl"), "--tray", "40x40", "--open-height", "--physical"}).status, 2);
}

TEST_F(WholeJob, CapsInAMeshAreOfItsVolumeAndSections) {
    stl("bottle.stl", bottle_mesh());  // 22.4 of 32 cm3; 800 mm2 below, 320 in the neck
    ASSERT_EQ(pack({at("cube.stl") + ":30", "--container", at("bottle.stl"), "--max-density", "0.5"}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 11);
    EXPECT_LE(build()["metrics"]["density"], 0.5);
    expect_sound();
    ASSERT_EQ(pack({at("cube.stl") + ":30", "--container", at("bottle.stl"), "--max-layer-fill", "0.5", "--no-refine"})
                  .status,
              0);
    EXPECT_EQ(build()["metrics"]["placed"], 4 + 4 + 1 + 1) << "half of each layer";
    EXPECT_TRUE(contains(build()["unplaced"][0]["detail"], "cap of 50 %")) << build()["unplaced"][0];
    expect_sound();
}

TEST_F(WholeJob, CapsCountFixedCopies) {
    ASSERT_EQ(pack({at("slab.stl"), "--tray", "40x40x40"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");  // a quarter of it
    ASSERT_EQ(pack({at("cube.stl") + ":30", "--onto", at("old.json"), "--max-density", "0.35"}).status, 0);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 1 + 6u);
    EXPECT_NEAR(build()["metrics"]["density"], 0.25 + 6 / 64.0, 1e-9);
    ASSERT_EQ(pack({at("cube.stl") + ":60", "--onto", at("old.json"), "--max-layer-fill", "0.5", "--no-refine"}).status,
              0);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 1 + 3 * 8u) << "the layers of the slab are full";
    expect_sound();
}

TEST_F(WholeJob, WithoutACeilingOnTopOfWhatStands) {
    stl("pole.stl", box_mesh({0, 0, 0}, {10, 10, 90}));
    ASSERT_EQ(pack({at("pole.stl"), at("slab.stl"), "--tray", "50x40x100", "--rotations", "none"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    for (const char* at_top : {"top", "bottom"}) {
        const Ran ran = pack({at("cube.stl") + ":40", "--onto", at("old.json"), "--tray", "50x40", "--open-height",
                              "--height-at", at_top, "--verify-with", "reference:5"});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const json packing = build();
        EXPECT_EQ(packing["trays"][0]["placements"].size(), 42u);
        EXPECT_TRUE(packing["trays"][0]["placements"][0]["fixed"]);
        EXPECT_EQ(packing["container"]["size"], json({50, 40, 90})) << "as high as the pole";
        double top = 0;
        for (std::size_t i = 2; i < 42; ++i) {
            top = std::max(top, packing["trays"][0]["placements"][i]["transform"][2][3].get<double>());
        }
        EXPECT_LE(top, 30) << "beside the pole and on the slab";
        expect_sound();
    }
    EXPECT_EQ(pack({at("cube.stl"), "--onto", at("old.json"), "--tray", "50x40", "--minimise", "box"}).status, 2);
}

TEST_F(WholeJob, RefinementStaysInTheMeshAndOutOfKeepOuts) {
    stl("tube.stl", torus_mesh(40, 18, 48, 24));
    stl("ball.stl", torus_mesh(5, 4, 16, 12));
    const Ran ran = pack({at("ball.stl") + ":12", at("cube.stl") + ":12", "--container", at("tube.stl"), "--refine",
                          "--wall-gap", "0.5", "--keep-out", "0,0,0,58,30,36"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_GT(build()["metrics"]["placed"], 10);
    expect_sound();
}

TEST_F(WholeJob, AContainerThatIsNoneIsNamedWithItsFault) {
    Mesh open = cube_mesh(30);
    open.triangles.pop_back();
    stl("open.stl", open);
    const Ran hole = pack({at("cube.stl"), "--container", at("open.stl")});
    EXPECT_EQ(hole.status, 3);
    EXPECT_TRUE(contains(hole.err, "open.stl")) << hole.err;
    EXPECT_TRUE(contains(hole.err, "not closed; it is open at (")) << hole.err;
    stl("tiny.stl", cube_mesh(1));
    const Ran tiny = pack({at("cube.stl"), "--container", at("tiny.stl")});
    EXPECT_NE(tiny.status, 0);
    EXPECT_TRUE(contains(tiny.err, "smaller than one voxel")) << tiny.err;
    stl("ring.stl", torus_mesh(20, 1.2));
    const Ran thin = pack({at("cube.stl"), "--container", at("ring.stl")});
    EXPECT_EQ(thin.status, 3);
    EXPECT_TRUE(contains(thin.err, "no voxel of 2 mm is wholly free")) << thin.err;
    EXPECT_EQ(pack({at("cube.stl"), "--container", at("missing.stl")}).status, 3);
}

TEST_F(WholeJob, KeepOutsStayEmpty) {
    stl("pin.stl", box_mesh({10, 10, 0}, {20, 20, 20}));
    const Ran ran = pack(
        {at("cube.stl") + ":99", "--tray", "40x40x20", "--keep-out", "30,0,0,40,40,10", "--keep-out", at("pin.stl")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(build()["metrics"]["placed"], 32 - 4 - 2);
    ASSERT_EQ(build()["container"]["keep_out"].size(), 2u);
    EXPECT_EQ(build()["container"]["keep_out"][1]["mesh"], "pin.stl");
    expect_sound();
    json moved = build();
    moved["container"]["keep_out"][0]["box"] = {{20, 0, 0}, {40, 40, 10}};
    std::ofstream(at("build.json")) << moved;
    const Ran checked = spectralpack({"check", at("build.json")});
    EXPECT_EQ(checked.status, 1);
    EXPECT_TRUE(contains(checked.out, "keep-out 0")) << checked.out;
    EXPECT_EQ(pack({at("cube.stl"), "--keep-out", at("missing.stl")}).status, 3);
}

TEST_F(WholeJob, TopsUpABuildWithoutTouchingIt) {
    ASSERT_EQ(pack({at("slab.stl") + ":2", "--tray", "40x40x30"}).status, 0);
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    const json old = read_json(folder_ / "old.json");
    const Ran ran = pack({at("cube.stl") + ":20", "--onto", at("old.json")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = build();
    EXPECT_EQ(packing["container"]["size"], json({40, 40, 30}));
    EXPECT_EQ(packing["parts"].size(), 2u);
    EXPECT_EQ(packing["parts"][0]["name"], "slab");
    const json& placements = packing["trays"][0]["placements"];
    ASSERT_EQ(placements.size(), 18u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(placements[i]["fixed"]);
        EXPECT_EQ(placements[i]["transform"], old["trays"][0]["placements"][i]["transform"]);
    }
    EXPECT_FALSE(placements[2]["fixed"]);
    EXPECT_NEAR(packing["trays"][0]["density"], 1, 1e-9);
    EXPECT_EQ(packing["metrics"]["placed"], 18);
    EXPECT_EQ(packing["unplaced"].size(), 4u);
    expect_sound();
    // And once more, in two trays now.
    fs::rename(folder_ / "build.json", folder_ / "old.json");
    ASSERT_EQ(pack({at("cube.stl") + ":4", "--onto", at("old.json"), "--trays", "all"}).status, 0);
    EXPECT_EQ(build()["trays"].size(), 2u);
    EXPECT_EQ(build()["trays"][0]["placements"].size(), 18u);
    expect_sound();
}

TEST_F(WholeJob, FixedCopiesAreObstacles) {
    json job{
        {"format", "spectralpack/job"},
        {"version", 1},
        {"container", {{"size", {40, 40, 10}}}},
        {"gap", 0},
        {"fixed", {{{"mesh", "cube.stl"}, {"transform", {{0, -1, 0, 25}, {1, 0, 0, 15}, {0, 0, 1, 0}, {0, 0, 0, 1}}}}}},
        {"parts", {{{"mesh", "cube.stl"}, {"count", 16}}}},
        {"options", {{"output", "build.json"}, {"refine", true}}}};
    std::ofstream(at("job.json")) << job;
    const Ran ran = spectralpack({"pack", at("job.json")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = build();
    EXPECT_TRUE(packing["trays"][0]["placements"][0]["fixed"]);
    EXPECT_EQ(packing["trays"][0]["placements"][0]["transform"], job["fixed"][0]["transform"]);
    EXPECT_EQ(packing["trays"][0]["placements"].size(), 13u);  // 5 mm off the grid of cubes
    expect_sound();

    job["fixed"].push_back(
        {{"mesh", "cube.stl"}, {"transform", {{1, 0, 0, 20}, {0, 1, 0, 15}, {0, 0, 1, 0}, {0, 0, 0, 1}}}});
    std::ofstream(at("job.json")) << job;
    const Ran overlap = spectralpack({"pack", at("job.json")});
    EXPECT_EQ(overlap.status, 3);
    EXPECT_TRUE(contains(overlap.err, "overlap")) << overlap.err;

    job["fixed"][1]["transform"][0][3] = 35;
    std::ofstream(at("job.json")) << job;
    const Ran outside = spectralpack({"pack", at("job.json")});
    EXPECT_EQ(outside.status, 3);
    EXPECT_TRUE(contains(outside.err, "sticks out")) << outside.err;

    job["fixed"][1]["transform"][0] = {-1, 0, 0, 40};
    std::ofstream(at("job.json")) << job;
    const Ran mirror = spectralpack({"pack", at("job.json")});
    EXPECT_EQ(mirror.status, 3);
    EXPECT_TRUE(contains(mirror.err, "fixed[1]: its transform is a mirror image")) << mirror.err;
}

TEST_F(WholeJob, PrintersAreListedAndUsed) {
    const Ran list = spectralpack({"pack", "--printer", "list"});
    EXPECT_EQ(list.status, 0);
    EXPECT_TRUE(contains(list.out, "hp-mjf-5200")) << list.out;
    EXPECT_TRUE(contains(list.out, "UNVERIFIED")) << list.out;
    ASSERT_EQ(
        spectralpack({"pack", at("cube.stl"), "--printer", "formlabs-fuse1", "--gap", "1", "-o", at("build.json")})
            .status,
        0);
    EXPECT_EQ(build()["container"]["size"], json({165, 165, 300}));
    EXPECT_EQ(build()["options"]["printer"], "formlabs-fuse1");
    EXPECT_EQ(build()["options"]["gap"], 1);
    EXPECT_EQ(build()["options"]["wall-gap"], 3);
    EXPECT_EQ(spectralpack({"pack"}).status, 2);
}

}  // namespace
}  // namespace spectralpack::test
