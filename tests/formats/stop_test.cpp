/// Reading a mesh is given up in its midst once that is asked for.

#include <gtest/gtest.h>

#include <sstream>

#include "core/stopped.hpp"
#include "formats/files.hpp"
#include "formats/mesh_parsers.hpp"
#include "formats/zip_archive.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using Parser = std::vector<ParsedMesh> (*)(const MeshBytes&);

/// Of so many vertices and triangles that reading them looks whether it is to stop.
Mesh large_mesh() { return test::torus_mesh(9, 2, 100, 60); }

template <class Line>
void write_vertices(std::ostream& out, const char* word, const Line& end) {
    for (const Vec3& v : large_mesh().vertices) {
        out << word << v.x << ' ' << v.y << ' ' << v.z << end;
    }
}

std::string ascii_stl() {
    const Mesh mesh = large_mesh();
    std::ostringstream out;
    out << "solid\n";
    for (const Triangle& t : mesh.triangles) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t i : t) {
            out << "vertex " << mesh.vertices[i].x << ' ' << mesh.vertices[i].y << ' ' << mesh.vertices[i].z << '\n';
        }
        out << "endloop\nendfacet\n";
    }
    out << "endsolid\n";
    return out.str();
}

std::string obj() {
    std::ostringstream out;
    write_vertices(out, "v ", '\n');
    for (const Triangle& t : large_mesh().triangles) {
        out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    }
    return out.str();
}

/// The faces as OFF and ASCII PLY have them.
void write_faces(std::ostream& out) {
    for (const Triangle& t : large_mesh().triangles) {
        out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    }
}

std::string off() {
    const Mesh mesh = large_mesh();
    std::ostringstream out;
    out << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
    write_vertices(out, "", '\n');
    write_faces(out);
    return out.str();
}

std::string ply() {
    const Mesh mesh = large_mesh();
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    write_vertices(out, "", '\n');
    write_faces(out);
    return out.str();
}

std::string binvox() { return "#binvox 1\ndim 2 2 2\ndata\n" + std::string("\1\10", 2); }

std::string threemf() {
    return make_zip(
        {{"_rels/.rels",
          "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
          "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
          "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
         {"3D/3dmodel.model",
          "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>"
          "<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"9\" y=\"0\" z=\"0\"/>"
          "<vertex x=\"0\" y=\"9\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"9\"/></vertices><triangles>"
          "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
          "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh></object>"
          "</resources><build><item objectid=\"1\"/></build></model>"}});
}

TEST(Reading, IsGivenUpInTheMidstOfAMesh) {
    const std::pair<Parser, std::string> files[] = {{parse_stl, test::binary_stl(large_mesh())},
                                                    {parse_stl, ascii_stl()},
                                                    {parse_obj, obj()},
                                                    {parse_off, off()},
                                                    {parse_ply, ply()},
                                                    {parse_binvox, binvox()},
                                                    {parse_3mf, threemf()}};
    for (const auto& [parse, bytes] : files) {
        StopSource stop;
        MeshBytes source{"file", "stem", bytes, stop.token()};
        EXPECT_EQ(parse(source).size(), 1u) << bytes.substr(0, 20);
        stop.request(StopReason::time_limit);
        EXPECT_THROW(parse(source), Stopped) << bytes.substr(0, 20);
    }
}

TEST(Reading, IsGivenUpInTheMidstOfAFile) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = test::write_bytes(folder / "a.stl", test::binary_stl(large_mesh()));
    StopSource stop;
    EXPECT_EQ(read_meshes(file, 1, stop.token()).size(), 1u);
    stop.request(StopReason::cancelled);
    EXPECT_THROW(read_meshes(file, 1, stop.token()), Stopped);
    EXPECT_THROW(adopt_mesh(large_mesh(), "mesh", 1, stop.token()), Stopped);
}

}  // namespace
}  // namespace spectralpack
