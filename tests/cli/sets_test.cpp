/// generate and prepare, end to end.

#include <algorithm>
#include <fstream>
#include <map>

#include "cli/program.hpp"
#include "formats/csv.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/packing_file.hpp"
#include "formats/set_file.hpp"
#include "geometry/mesh_edges.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

namespace fs = std::filesystem;

class Sets : public testing::Test {
  protected:
    std::string in(const std::string& name) const { return (folder_ / name).string(); }

    static std::map<std::string, std::string> contents(const fs::path& folder) {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file()) {
                files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
            }
        }
        return files;
    }

    /// When each mesh of a folder's was written; those of its folders not.
    static std::map<std::string, fs::file_time_type> meshes_written(const fs::path& folder) {
        std::map<std::string, fs::file_time_type> written;
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() == ".stl") written[entry.path().filename()] = entry.last_write_time();
        }
        return written;
    }

    /// Outcome by file, from report.csv.
    static std::map<std::string, std::string> outcomes(const fs::path& report) {
        std::map<std::string, std::string> found;
        for (const CsvRow& row : parse_csv(report.string(), read_text(report))) {
            found[row.fields[0]] = row.fields[2];
        }
        found.erase("file");
        return found;
    }

    /// A folder with one mesh of every outcome and one that must be simplified.
    void make_dirty_folder() const {
        fs::create_directories(folder_ / "dirty" / "deep");
        write_stl(cube_mesh(20), folder_ / "dirty" / "good.stl");
        write_stl(torus_mesh(30, 10, 80, 60), folder_ / "dirty" / "deep" / "dense.stl");
        write_stl(cube_mesh(1000), folder_ / "dirty" / "large, \"quoted\".stl");
        Mesh open = cube_mesh(20);
        open.triangles.pop_back();
        write_stl(open, folder_ / "dirty" / "open.stl");
        write_stl(turned_inside_out(cube_mesh(20)), folder_ / "dirty" / "turned.stl");
        std::ofstream(folder_ / "dirty" / "broken.stl") << "no mesh at all";
        std::ofstream(folder_ / "dirty" / "tetrahedron.off") << "OFF\n4 4 6\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n"
                                                                "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    }

    TemporaryFolder folder_;
};

TEST_F(Sets, GeneratedSetsAreTheSameForASeedAndPackWithoutComplaint) {
    for (const std::string set : {"pieces", "mixtures", "locks", "tori", "polyhedra"}) {
        const Ran ran = spectralpack({"generate", set, "--seed", "3", "--count", "20", "-o", in(set)});
        ASSERT_EQ(ran.status, 0) << ran.err;
        EXPECT_TRUE(names(ran.out, {in(set + "/" + set + ".csv"), 20, "copies"}));
        EXPECT_EQ(spectralpack({"generate", set, "--seed", "3", "--count", "20", "-o", in(set + "2")}).status, 0);
        EXPECT_EQ(contents(in(set)), contents(in(set + "2")));
        int copies = 0;
        for (const SetRow& row : read_set(in(set + "/" + set + ".csv"))) {
            copies += row.count;
            const auto loaded = read_meshes(in(set + "/" + row.mesh));
            ASSERT_EQ(loaded.size(), 1u);
            EXPECT_TRUE(loaded[0].repairs.empty()) << row.mesh << ": " << loaded[0].repairs[0];
            EXPECT_TRUE(is_closed(loaded[0].mesh)) << row.mesh;
            EXPECT_GT(signed_volume(loaded[0].mesh), 0) << row.mesh;
        }
        EXPECT_EQ(copies, 20);
    }
    const Ran packed =
        spectralpack({"pack", in("locks/locks.csv"), "--voxel", "4", "--rotations", "none", "-o", in("locks.json")});
    EXPECT_EQ(packed.status, 0) << packed.err;
    EXPECT_EQ(spectralpack({"check", in("locks.json")}).status, 0);
}

TEST_F(Sets, LettersAreSevenContainers) {
    EXPECT_EQ(spectralpack({"generate", "letters", "-o", in("letters")}).status, 0);
    EXPECT_EQ(read_set(in("letters/letters.csv")).size(), 7u);
    EXPECT_EQ(bounding_box(read_meshes(in("letters/letter-G.stl"))[0].mesh).max, (Vec3{322, 322, 80}));
}

TEST_F(Sets, SegmentsAreOfTwoBodiesAndTheSameForASeed) {
    const Ran ran = spectralpack({"generate", "segments", "--seed", "3", "-o", in("a")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {in("a/segments.csv"), 25, "copies"}));
    EXPECT_EQ(read_set(in("a/bunny.csv")).size(), 13u);
    EXPECT_EQ(read_set(in("a/molecule.csv")).size(), 12u);
    for (const SetRow& row : read_set(in("a/segments.csv"))) {
        const auto loaded = read_meshes(in("a/" + row.mesh));
        ASSERT_EQ(loaded.size(), 1u);
        EXPECT_TRUE(loaded[0].repairs.empty()) << row.mesh << ": " << loaded[0].repairs[0];
        EXPECT_TRUE(is_closed(loaded[0].mesh)) << row.mesh;
    }
    EXPECT_EQ(spectralpack({"generate", "segments", "--seed", "3", "-o", in("b")}).status, 0);
    EXPECT_EQ(contents(in("a")), contents(in("b")));
    EXPECT_EQ(spectralpack({"generate", "segments", "--seed", "4", "-o", in("c")}).status, 0);
    EXPECT_NE(contents(in("a")), contents(in("c")));
    const Ran packed = spectralpack({"pack", in("a/bunny.csv"), "--tray", "160x160", "--minimise", "box", "--gap", "1",
                                     "--voxel", "5", "--require-all", "-o", in("bunny.json")});
    EXPECT_EQ(packed.status, 0) << packed.err;
    EXPECT_EQ(spectralpack({"check", in("bunny.json"), "--require-plan"}).status, 0);
}

TEST_F(Sets, AMeshTooLargeForTheTrayIsCutIntoPiecesThatFit) {
    const Mesh ring = torus_mesh(100, 30, 60, 30);
    write_stl(transformed(ring, {Mat3{}, {500, -40, 7}}), folder_ / "ring.stl");
    EXPECT_EQ(spectralpack({"pack", in("ring.stl"), "--tray", "150x150x70", "-o", in("whole.json")}).status, 6);
    const Ran ran = spectralpack({"generate", "segments", in("ring.stl"), "--tray", "150x150x70", "-o", in("cut")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {in("cut/segments.csv"), 4, "pieces"})) << ran.out;
    double volume = 0;
    Box box;
    const auto rows = read_set(in("cut/segments.csv"));
    EXPECT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0].mesh, "ring-01.stl");
    for (const SetRow& row : rows) {
        const auto loaded = read_meshes(in("cut/" + row.mesh));
        ASSERT_EQ(loaded.size(), 1u);
        EXPECT_TRUE(loaded[0].repairs.empty()) << loaded[0].repairs[0];
        EXPECT_TRUE(is_closed(loaded[0].mesh));
        volume += signed_volume(loaded[0].mesh);
        box.add(bounding_box(loaded[0].mesh));
    }
    const Mesh whole = read_meshes(in("ring.stl"))[0].mesh;
    EXPECT_NEAR(volume, signed_volume(whole), 1e-6 * signed_volume(whole));
    EXPECT_EQ(box, bounding_box(whole)) << "each where it lay in the whole";
    const Ran packed = spectralpack({"pack", in("cut/segments.csv"), "--tray", "150x150x70", "--trays", "all",
                                     "--require-all", "--voxel", "4", "-o", in("cut.json")});
    EXPECT_EQ(packed.status, 0) << packed.err;
    // What fits stays whole, unless more pieces are asked for.
    EXPECT_EQ(spectralpack({"generate", "segments", in("ring.stl"), "--tray", "70x260x270", "-o", in("one")}).status,
              0);
    EXPECT_EQ(read_set(in("one/segments.csv")).size(), 1u);
    EXPECT_EQ(spectralpack({"generate", "segments", in("ring.stl"), "--pieces", "6", "-o", in("six")}).status, 0);
    EXPECT_EQ(read_set(in("six/segments.csv")).size(), 6u);
    // Units count.
    EXPECT_EQ(spectralpack({"generate", "segments", in("ring.stl"), "--unit", "inch", "--tray", "3500x3500x1800", "-o",
                            in("inch")})
                  .status,
              0);
    EXPECT_EQ(read_set(in("inch/segments.csv")).size(), 4u);
}

TEST_F(Sets, AnOpenMeshIsNotCut) {
    Mesh open = cube_mesh(20);
    open.triangles.pop_back();
    write_stl(open, folder_ / "open.stl");
    const Ran ran = spectralpack({"generate", "segments", in("open.stl"), "--tray", "10x10x10", "-o", in("x")});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {in("open.stl"), "not closed", 3, "edges"})) << ran.err;
    EXPECT_FALSE(fs::exists(in("x")));
    EXPECT_EQ(spectralpack({"generate", "segments", in("none.stl"), "-o", in("x")}).status, 3);
}

TEST_F(Sets, SegmentsRefuseWhatMakesNoSense) {
    write_stl(cube_mesh(20), folder_ / "cube.stl");
    const std::vector<std::vector<std::string>> wrong{{"segments", "--count", "5"},
                                                      {"segments", "--tray", "10x10x10"},
                                                      {"segments", "--pieces", "5"},
                                                      {"segments", in("cube.stl"), "--count", "5"},
                                                      {"segments", in("cube.stl"), "--pieces", "0"},
                                                      {"segments", in("cube.stl"), "--pieces", "1001"},
                                                      {"segments", in("cube.stl"), "--tray", "1x1x1"},
                                                      {"segments", in("cube.stl"), "--tray", "10x10"},
                                                      {"segments", in("cube.stl"), "--unit", "cubit"},
                                                      {"tori", in("cube.stl")}};
    for (const auto& call : wrong) {
        const Ran ran =
            spectralpack(std::vector<std::string>{"generate"} + call + std::vector<std::string>{"-o", in("x")});
        EXPECT_EQ(ran.status, 2) << call.back() << ": " << ran.err;
        EXPECT_FALSE(ran.err.empty());
    }
    EXPECT_FALSE(fs::exists(in("x")));
}

TEST_F(Sets, GenerateRefusesWhatMakesNoSense) {
    EXPECT_EQ(spectralpack({"generate", "bricks", "-o", in("x")}).status, 2);
    EXPECT_EQ(spectralpack({"generate", "pieces", "--count", "0", "-o", in("x")}).status, 2);
    EXPECT_EQ(spectralpack({"generate", "letters", "--count", "5", "-o", in("x")}).status, 2);
    EXPECT_EQ(spectralpack({"generate", "pieces"}).status, 2);
    std::ofstream(folder_ / "file") << "in the way";
    EXPECT_EQ(spectralpack({"generate", "tori", "-o", in("file/x")}).status, 4);
}

TEST_F(Sets, PrepareKeepsWhatEnclosesASolidAndTellsOfTheRest) {
    make_dirty_folder();
    const Ran ran = spectralpack({"prepare", in("dirty"), "-o", in("out"), "--triangles", "1000"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {7, 5, in("out/set.csv"), in("out/report.csv")}));
    const std::map<std::string, std::string> expected{{"broken.stl", "unusable"}, {"deep/dense.stl", "kept"},
                                                      {"good.stl", "kept"},       {"large, \"quoted\".stl", "kept"},
                                                      {"open.stl", "open"},       {"tetrahedron.off", "kept"},
                                                      {"turned.stl", "kept"}};
    EXPECT_EQ(outcomes(folder_ / "out" / "report.csv"), expected);
    const auto set = read_set(folder_ / "out" / "set.csv");
    ASSERT_EQ(set.size(), 5u);
    for (const SetRow& row : set) {
        const auto loaded = read_meshes(folder_ / "out" / row.mesh);
        EXPECT_TRUE(loaded[0].repairs.empty()) << row.mesh;
        EXPECT_LE(loaded[0].mesh.triangles.size(), 1000u) << row.mesh;
        const Vec3 size = bounding_box(loaded[0].mesh).size();
        EXPECT_LE(size.z, 200) << row.mesh;
    }
    EXPECT_TRUE(fs::exists(folder_ / "out" / "tetrahedron.off.stl"));
    EXPECT_EQ(spectralpack({"pack", in("out/set.csv"), "--voxel", "8", "--dry-run"}).status, 0);
}

TEST_F(Sets, PrepareGoesOnWhereItWasKilledAndSeesChanges) {
    make_dirty_folder();
    ASSERT_EQ(spectralpack({"prepare", in("dirty"), "-o", in("whole")}).status, 0);
    ASSERT_EQ(spectralpack({"prepare", in("dirty"), "-o", in("out")}).status, 0);

    // As if killed while writing: half of the journal, torn in a line; a result is missing as well.
    const std::string journal = read_text(folder_ / "out" / "journal.csv");
    std::ofstream(folder_ / "out" / "journal.csv") << journal.substr(0, journal.size() * 6 / 10);
    fs::remove(folder_ / "out" / "deep" / "dense.stl");
    fs::remove(folder_ / "out" / "report.csv");
    const std::map<std::string, fs::file_time_type> cut = meshes_written(folder_ / "out");
    const Ran again = spectralpack({"prepare", in("dirty"), "-o", in("out")});
    ASSERT_EQ(again.status, 0) << again.err;
    const auto ended = meshes_written(folder_ / "out");
    const auto kept =
        std::count_if(cut.begin(), cut.end(), [&](const auto& mesh) { return ended.at(mesh.first) == mesh.second; });
    EXPECT_GT(kept, 0) << "all were made again";
    auto whole = contents(folder_ / "whole"), out = contents(folder_ / "out");
    whole.erase("journal.csv"), out.erase("journal.csv");
    EXPECT_EQ(out, whole);

    write_stl(cube_mesh(30), folder_ / "dirty" / "open.stl");
    const Ran changed = spectralpack({"prepare", in("dirty"), "-o", in("out")});
    EXPECT_TRUE(names(changed.out, {7, 6})) << "of seven files, six were done before";
    for (const auto& [mesh, time] : meshes_written(folder_ / "out")) {
        EXPECT_EQ(mesh == "open.stl", !ended.contains(mesh) || ended.at(mesh) != time) << mesh;
    }
    EXPECT_EQ(outcomes(folder_ / "out" / "report.csv").at("open.stl"), "kept");
}

TEST_F(Sets, PrepareRefusesWhatWouldGoWrong) {
    make_dirty_folder();
    EXPECT_EQ(spectralpack({"prepare", in("none"), "-o", in("out")}).status, 3);
    EXPECT_EQ(spectralpack({"prepare", in("dirty"), "-o", in("dirty/out")}).status, 2);
    EXPECT_EQ(spectralpack({"prepare", in("dirty"), "-o", in("dirty")}).status, 2);
    EXPECT_EQ(spectralpack({"prepare", in("dirty"), "-o", in("out"), "--tray", "1x1x1"}).status, 2);
    ASSERT_EQ(spectralpack({"prepare", in("dirty"), "-o", in("out")}).status, 0);
    const Ran other = spectralpack({"prepare", in("dirty"), "-o", in("out"), "--triangles", "99"});
    EXPECT_EQ(other.status, 2);
    EXPECT_TRUE(names(other.err, {in("out/journal.csv"), "options", 99}));
    fs::create_directory(folder_ / "empty");
    EXPECT_EQ(spectralpack({"prepare", in("empty"), "-o", in("out2")}).status, 3);
}

}  // namespace
}  // namespace spectralpack::test
