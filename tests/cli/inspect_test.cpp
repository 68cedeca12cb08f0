#include <fstream>

#include "cli/program.hpp"
#include "formats/packing_file.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Inspect : public testing::Test {
  protected:
    /// `mesh` as a binary STL.
    std::string stl(const std::string& name, const Mesh& mesh) {
        write_stl(mesh, folder_ / name);
        return (folder_ / name).string();
    }

    std::string broken(const std::string& name) {
        std::ofstream(folder_ / name) << "not a mesh";
        return (folder_ / name).string();
    }

    static json findings(std::vector<std::string> arguments, int status = 0) {
        arguments.insert(arguments.begin(), {"inspect", "--json"});
        const Ran ran = spectralpack(arguments);
        EXPECT_EQ(ran.status, status) << ran.err;
        return json::parse(ran.out);
    }

    TemporaryFolder folder_;
};

TEST_F(Inspect, TellsWhatACubeIs) {
    const std::string cube = stl("cube.stl", box_mesh({1, 2, 3}, {21, 12, 8}));
    const json report = findings({cube});
    EXPECT_EQ(report["usable"], 1);
    EXPECT_EQ(report["unusable"], 0);
    EXPECT_EQ(report["files"][0]["file"], cube);
    const json object = report["files"][0]["objects"][0];
    EXPECT_EQ(object["name"], "cube");
    EXPECT_EQ(object["size"], json({20, 10, 5}));
    EXPECT_EQ(object["box"], json({{1, 2, 3}, {21, 12, 8}}));
    EXPECT_NEAR(object["volume"].get<double>(), 1000, 1e-9);
    EXPECT_NEAR(object["area"].get<double>(), 700, 1e-9);
    EXPECT_EQ(object["triangles"], 12);
    EXPECT_EQ(object["vertices"], 8);
    EXPECT_EQ(object["shells"], 1);
    EXPECT_EQ(object["watertight"], true);
    EXPECT_EQ(object["orientation"], "outward");
    EXPECT_EQ(object["self_intersections"]["pairs"], 0);
    EXPECT_EQ(object["duplicates"], 0);
    EXPECT_TRUE(object["unit_hint"].is_null());
    EXPECT_TRUE(object["warnings"].empty());

    const Ran ran = spectralpack({"inspect", cube});
    EXPECT_EQ(ran.status, 0);
    EXPECT_TRUE(names(ran.out, {cube, 20, 10, 5, 1000, 700, 12, 8, "closed"}));
    EXPECT_TRUE(ran.err.empty()) << ran.err;
}

TEST_F(Inspect, TellsWhereAMeshIsOpen) {
    Mesh open = cube_mesh(20);
    open.triangles.pop_back();
    const std::string file = stl("open.stl", open);
    const json object = findings({file})["files"][0]["objects"][0];
    EXPECT_EQ(object["watertight"], false);
    EXPECT_EQ(object["border"]["edges"], 3);
    EXPECT_EQ(object["border"]["loops"], 1);
    const json hole = object["border"]["longest"][0];
    EXPECT_NEAR(hole["length"].get<double>(), 40 + std::sqrt(800.0), 1e-9);
    EXPECT_EQ(hole["place"][0], 20);
    const Ran ran = spectralpack({"inspect", file});
    EXPECT_EQ(ran.status, 0);
    EXPECT_TRUE(names(ran.out, {3, 1, 68.2843, "closed"}));
}

TEST_F(Inspect, TellsTurnsCrossingsAndRepairs) {
    const json turned = findings({stl("turned.stl", turned_inside_out(cube_mesh(20)))})["files"][0]["objects"][0];
    EXPECT_EQ(turned["orientation"], "turned");
    EXPECT_GT(turned["volume"].get<double>(), 0);
    EXPECT_EQ(turned["repairs"].size(), 1u);

    const Mesh two = merged(cube_mesh(20), box_mesh({10, 11, 12}, {30, 31, 32}));
    const json crossing = findings({stl("two.stl", two)})["files"][0]["objects"][0];
    EXPECT_EQ(crossing["shells"], 2);
    EXPECT_GT(crossing["self_intersections"]["pairs"], 0);
    EXPECT_EQ(crossing["self_intersections"]["complete"], true);
    EXPECT_FALSE(crossing["self_intersections"]["place"].is_null());
    EXPECT_FALSE(crossing["warnings"].empty());
}

TEST_F(Inspect, MeasuresInTheUnitThatIsNamedAndDoubtsASuspiciousOne) {
    const std::string file = stl("inch.stl", box_mesh({0, 0, 0}, {2, 1.5, 0.5}));
    const json mm = findings({file})["files"][0]["objects"][0];
    EXPECT_TRUE(names(mm["unit_hint"], {"inch"}));
    const json inch = findings({"--unit", "inch", file})["files"][0]["objects"][0];
    EXPECT_TRUE(inch["unit_hint"].is_null());
    EXPECT_NEAR(inch["size"][0].get<double>(), 50.8, 1e-9);
    EXPECT_NEAR(inch["volume"].get<double>(), 1.5 * 25.4 * 25.4 * 25.4, 1e-6);
    EXPECT_EQ(spectralpack({"inspect", file, "--unit", "cubit"}).status, 2);
}

TEST_F(Inspect, AnUnusableFileExitsWithThreeAndTheRestIsReported) {
    const std::string cube = stl("cube.stl", cube_mesh(20)), bad = broken("bad.stl");
    const std::string missing = (folder_ / "missing.stl").string();
    const json report = findings({bad, cube, missing}, 3);
    EXPECT_EQ(report["usable"], 1);
    EXPECT_EQ(report["unusable"], 2);
    EXPECT_EQ(report["files"][0]["file"], bad);
    EXPECT_EQ(report["files"][0]["usable"], false);
    EXPECT_FALSE(report["files"][0]["cause"].get<std::string>().empty());
    EXPECT_EQ(report["files"][1]["usable"], true);
    EXPECT_EQ(report["files"][2]["file"], missing);
    const Ran ran = spectralpack({"inspect", bad, cube, missing});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.out, {bad, "cannot be used", cube, 20, missing}));
    EXPECT_TRUE(names(ran.err, {2, 3}));
}

TEST_F(Inspect, LooksThroughFolders) {
    fs::create_directory(folder_ / "in");
    stl("in/b.stl", cube_mesh(20));
    stl("in/a.stl", cube_mesh(30));
    std::ofstream(folder_ / "in" / "notes.txt") << "no mesh";
    const json report = findings({(folder_ / "in").string()});
    ASSERT_EQ(report["files"].size(), 2u);
    EXPECT_EQ(fs::path(report["files"][0]["file"].get<std::string>()).filename(), "a.stl");
}

TEST_F(Inspect, AHostileNameStaysInItsLineAndInItsString) {
    const std::string name = "a\n\"b\"\x1b[2J,.stl";
    const std::string file = stl(name, cube_mesh(20));
    EXPECT_EQ(findings({file})["files"][0]["file"], file);
    const Ran ran = spectralpack({"inspect", file});
    EXPECT_EQ(ran.out.find('\x1b'), std::string::npos);
    EXPECT_TRUE(contains(ran.out, "a?\"b\"?[2J,.stl")) << ran.out;
}

TEST_F(Inspect, DrawsWhatCanBeUsed) {
    const std::string cube = stl("cube.stl", cube_mesh(20)), torus = stl("torus.stl", torus_mesh(30, 10));
    const fs::path picture = folder_ / "p.png";
    const Ran ran =
        spectralpack({"inspect", cube, broken("bad.stl"), torus, "-o", picture.string(), "--size", "160x120"});
    EXPECT_EQ(ran.status, 3) << ran.err;
    EXPECT_GT(fs::file_size(picture), 500u);
    EXPECT_EQ(spectralpack({"inspect", cube, "-o", (folder_ / "p.jpg").string()}).status, 2);
    EXPECT_EQ(spectralpack({"inspect", cube, "-o", (folder_ / "no" / "p.png").string()}).status, 2);
}

}  // namespace
}  // namespace spectralpack::test
