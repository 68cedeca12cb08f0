/// Containers of any shape, and rooms in them that stay empty.

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Containers : public WholeJob {};

TEST_F(Containers, FillsAMesh) {
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
    const json finding = finding_of(moved);
    EXPECT_EQ(finding["kind"], "outside");
    EXPECT_EQ(finding["placements"], json::array({0}));
}

TEST_F(Containers, CapsInAMeshAreOfItsVolumeAndSections) {
    stl("bottle.stl", bottle_mesh());  // 22.4 of 32 cm3; 800 mm2 below, 320 in the neck
    ASSERT_EQ(pack({at("cube.stl") + ":30", "--container", at("bottle.stl"), "--max-density", "0.5"}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 11);
    EXPECT_LE(build()["metrics"]["density"], 0.5);
    expect_sound();
    ASSERT_EQ(pack({at("cube.stl") + ":30", "--container", at("bottle.stl"), "--max-layer-fill", "0.5", "--no-refine"})
                  .status,
              0);
    EXPECT_EQ(build()["metrics"]["placed"], 4 + 4 + 1 + 1) << "half of each layer";
    EXPECT_TRUE(names(build()["unplaced"][0]["detail"], {50, "%"}));
    expect_sound();
}

TEST_F(Containers, RefinementStaysInTheMeshAndOutOfKeepOuts) {
    stl("tube.stl", torus_mesh(40, 18, 48, 24));
    stl("ball.stl", torus_mesh(5, 4, 16, 12));
    const Ran ran = pack({at("ball.stl") + ":12", at("cube.stl") + ":12", "--container", at("tube.stl"), "--refine",
                          "--wall-gap", "0.5", "--keep-out", "0,0,0,58,30,36"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_GT(build()["metrics"]["placed"], 10);
    expect_sound();
}

TEST_F(Containers, KeepOutsStayEmpty) {
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
    moved["trays"][0]["disassembly"] = nullptr;  // which leads through there
    std::ofstream(at("build.json")) << moved;
    const json findings = check_report(at("build.json"), 1)["findings"];
    ASSERT_FALSE(findings.empty());
    for (const json& finding : findings) {
        EXPECT_EQ(finding["kind"], "outside");
        EXPECT_TRUE(names(finding["message"], {"keep-out", 0}));
    }
    const Ran missing = pack({at("cube.stl"), "--keep-out", at("missing.stl")});
    EXPECT_EQ(missing.status, 3);
    EXPECT_TRUE(names(missing.err, {"missing.stl"}));
}

TEST_F(Containers, AContainerThatIsNoneIsNamedWithItsFault) {
    Mesh open = cube_mesh(30);
    open.triangles.pop_back();
    stl("open.stl", open);
    const Ran hole = pack({at("cube.stl"), "--container", at("open.stl")});
    EXPECT_EQ(hole.status, 3);
    EXPECT_TRUE(names(hole.err, {"open.stl", 30, 3, "edges"})) << "a corner of the hole, and its edges";
    stl("tiny.stl", cube_mesh(1));
    const Ran tiny = pack({at("cube.stl"), "--container", at("tiny.stl")});
    EXPECT_EQ(tiny.status, 2);
    EXPECT_TRUE(names(tiny.err, {"voxel", 2}));
    stl("ring.stl", torus_mesh(20, 1.2));
    const Ran thin = pack({at("cube.stl"), "--container", at("ring.stl")});
    EXPECT_EQ(thin.status, 3);
    EXPECT_TRUE(names(thin.err, {"ring.stl", "voxel", 2}));
    const Ran missing = pack({at("cube.stl"), "--container", at("missing.stl")});
    EXPECT_EQ(missing.status, 3);
    EXPECT_TRUE(names(missing.err, {"missing.stl"}));
}

}  // namespace
}  // namespace spectralpack::test
