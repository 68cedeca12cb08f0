#include <sys/stat.h>

#include <cctype>
#include <clocale>
#include <limits>
#include <sstream>

#include "files.hpp"
#include "formats/mesh_parsers.hpp"
#include "geometry/mesh_edges.hpp"
#include "support/data.hpp"
#include "support/remarks.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::binary_stl;
using test::read_as;
using test::refusal_of;

const char* kAsciiTetrahedron =
    "solid a tetrahedron\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 10 0\nvertex 10 0 "
    "0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 0 "
    "10\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 10\nvertex 0 10 "
    "0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 10 0 0\nvertex 0 10 0\nvertex 0 0 "
    "1e1\nendloop\nendfacet\n"
    "endsolid a tetrahedron\n";

TEST(BinaryStl, CornersAreWeldedWithoutCallingItARepair) {
    const auto loaded = read_as("Name of it.stl", binary_stl(test::cube_mesh(20)));
    ASSERT_EQ(loaded.size(), 1u);
    EXPECT_EQ(loaded[0].name, "Name of it");
    EXPECT_EQ(loaded[0].mesh.vertices.size(), 8u);
    EXPECT_EQ(loaded[0].mesh.triangles.size(), 12u);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 8000);
    EXPECT_TRUE(loaded[0].repairs.empty());
    EXPECT_TRUE(loaded[0].warnings.empty());
    EXPECT_FALSE(loaded[0].object);
    EXPECT_FALSE(loaded[0].unit);
}

TEST(BinaryStl, TheLengthDecidesWhatItIsNotTheHeader) {
    EXPECT_DOUBLE_EQ(
        signed_volume(read_as("a.stl", binary_stl(test::cube_mesh(20), "solid cube\nfacet normal"))[0].mesh), 8000);
}

TEST(BinaryStl, NegativeZeroIsZero) {
    Mesh cube = test::cube_mesh(20);
    for (Triangle& t : cube.triangles) {  // every facet its own corners, every other with -0
        for (std::uint32_t& corner : t) {
            Vec3 vertex = cube.vertices[corner];
            if ((&t - cube.triangles.data()) % 2 == 1) vertex = {vertex.x == 0 ? -0.0 : vertex.x, vertex.y, vertex.z};
            corner = static_cast<std::uint32_t>(cube.vertices.size());
            cube.vertices.push_back(vertex);
        }
    }
    EXPECT_EQ(read_as("a.stl", binary_stl(cube))[0].mesh.vertices.size(), 8u);
}

TEST(BinaryStl, EveryTruncationIsRefused) {
    const std::string whole = binary_stl(test::cube_mesh(20));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::string part = whole.substr(0, length);
        EXPECT_FALSE(test::refusal([&] { parse_stl({"a.stl", "a", part}); }).cause().empty()) << length;
    }
}

TEST(BinaryStl, ACountThatDisagreesWithTheLengthIsRefusedOrTold) {
    std::string bytes = binary_stl(test::cube_mesh(20));
    EXPECT_TRUE(test::any_names(test::texts_of(read_as("a.stl", bytes + "stray")[0].warnings), {5, "bytes"}));
    for (const std::uint32_t count : {0u, 10u, 13u, 0xffffffffu}) {
        bytes.replace(80, 4, test::bytes_of(count));
        const InputError error = refusal_of("a.stl", bytes);
        EXPECT_TRUE(test::names(error.cause(), {count}));
    }
}

TEST(BinaryStl, WhatIsNotFiniteIsRefusedWithTheFacet) {
    const std::string whole = binary_stl(test::cube_mesh(20));
    for (const float bad : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()}) {
        std::string bytes = whole;
        bytes.replace(84 + 4 * 50 + 12 + 8, 4, test::bytes_of(bad));
        EXPECT_EQ(refusal_of("a.stl", bytes).place(), "facet 5");
    }
    std::string normal = whole;  // the normal is not used
    normal.replace(84, 4, test::bytes_of(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_DOUBLE_EQ(signed_volume(read_as("a.stl", normal)[0].mesh), 8000);
}

TEST(AsciiStl, AnyCaseAnyLineEndAnyWhiteSpace) {
    std::string text = kAsciiTetrahedron;
    const double volume = 1000.0 / 6;
    EXPECT_NEAR(signed_volume(read_as("a.stl", text)[0].mesh), volume, 1e-9);
    std::string loud;
    for (const char c : text) {
        loud += c == '\n' ? std::string(" \t\r\n\r\n  ") : std::string(1, static_cast<char>(std::toupper(c)));
    }
    EXPECT_NEAR(signed_volume(read_as("a.stl", loud)[0].mesh), volume, 1e-9);
    EXPECT_EQ(read_as("a.STL", text + text)[0].repairs.size(),
              1u);  // the same facets in a second solid
}

TEST(AsciiStl, NumbersDoNotDependOnTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed
    std::string text = kAsciiTetrahedron;
    text.replace(text.find("1e1"), 3, "10.0");
    const auto loaded = read_as("a.stl", text);
    std::setlocale(LC_ALL, before.c_str());
    EXPECT_NEAR(signed_volume(loaded[0].mesh), 1000.0 / 6, 1e-9);
}

TEST(AsciiStl, ErrorsNameTheLine) {
    const auto with = [](const std::string& old_text, const std::string& new_text) {
        std::string text = kAsciiTetrahedron;
        return text.replace(text.find(old_text), old_text.size(), new_text);
    };
    EXPECT_EQ(refusal_of("a.stl", with("vertex 0 10 0", "vertex 0 10,5 0")).place(), "line 5");
    EXPECT_TRUE(test::names(refusal_of("a.stl", with("vertex 0 10 0", "vertex 0 10,5 0")).cause(), {"10,5", "comma"}));
    EXPECT_EQ(refusal_of("a.stl", with("vertex 0 10 0", "vertex 0 10")).place(), "line 5");
    EXPECT_EQ(refusal_of("a.stl", with("vertex 0 10 0", "vertex 0 ten 0")).place(), "line 5");
    EXPECT_EQ(refusal_of("a.stl", with("vertex 0 10 0", "vertex 0 nan 0")).place(), "line 5");
    EXPECT_EQ(refusal_of("a.stl", with("vertex 0 10 0", "vertex 0 1e999 0")).place(), "line 5");
    EXPECT_EQ(refusal_of("a.stl", with("endloop", "junk")).place(), "line 7");
    EXPECT_EQ(refusal_of("a.stl", with("endsolid a tetrahedron\n", "")).place(), "line 29");
    EXPECT_EQ(refusal_of("a.stl", kAsciiTetrahedron + std::string("more")).place(), "line 31");
}

TEST(AsciiStl, TextThatIsNoStlIsCalledThat) {
    const std::string prose(500, 'x');
    EXPECT_TRUE(test::names(refusal_of("a.stl", prose).cause(), {"text"}));
    EXPECT_TRUE(test::names(refusal_of("a.stl", "solid nothing\nendsolid\n").cause(), {"triangles"}));
}

TEST(Stl, TheBenchmarkMeshesLoadAsTheirIndexSays) {
    SPECTRALPACK_NEEDS_DATA();
    std::ifstream index(*test::benchmark_data() / "meshes" / "index.csv");
    std::string line;
    std::getline(index, line);
    int read = 0;
    while (std::getline(index, line) && read < 60) {
        std::vector<std::string> fields;
        std::istringstream row(line);
        for (std::string field; std::getline(row, field, ',');) {
            fields.push_back(field);
        }
        const LoadedMesh loaded = read_meshes(*test::benchmark_data() / "meshes" / fields[0])[0];
        EXPECT_TRUE(loaded.repairs.empty()) << fields[0];
        EXPECT_TRUE(is_closed(loaded.mesh)) << fields[0];
        EXPECT_EQ(loaded.mesh.triangles.size(), std::stoul(fields[4])) << fields[0];
        const double volume = std::stod(fields[8]);
        EXPECT_NEAR(signed_volume(loaded.mesh), volume, 1e-3 * volume + 1e-3) << fields[0];
        ++read;
    }
    EXPECT_EQ(read, 60);
}

TEST(MeshFiles, UnknownOrUnreadableOnesAreRefused) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(is_mesh_file("a/B.StL"));
    EXPECT_TRUE(is_mesh_file("x.3mf"));
    EXPECT_FALSE(is_mesh_file("x.step"));
    EXPECT_FALSE(is_mesh_file("stl"));
    EXPECT_TRUE(test::names(refusal_of("a.step", "ISO-10303-21;").what(), {"a.step", "STL"}));
    EXPECT_TRUE(test::names(test::refusal([&] { read_meshes(folder / "no.stl"); }).what(), {"no.stl"}));
    std::filesystem::create_directory(folder / "d.stl");
    EXPECT_TRUE(test::names(test::refusal([&] { read_meshes(folder / "d.stl"); }).cause(), {"folder"}));
    ASSERT_EQ(::mkfifo((folder / "pipe.stl").c_str(), 0600), 0);
    EXPECT_TRUE(test::names(test::refusal([&] { read_meshes(folder / "pipe.stl"); }).what(), {"pipe.stl"}));
}

TEST(MeshFiles, WhatAFileIsDecidesNotItsName) {
    EXPECT_DOUBLE_EQ(signed_volume(read_as("really.stl",
                                           "OFF\n4 4 0\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n"
                                           "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")[0]
                                       .mesh),
                     36);
}

}  // namespace
}  // namespace spectralpack
