#include <algorithm>

#include "files.hpp"
#include "formats/mesh_parsers.hpp"
#include "geometry/mesh_edges.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::bytes_of;
using test::read_as;
using test::refusal_of;

/// `text` stands for the header up to the vertex element.
std::string ply_header(const std::string& format, const Mesh& mesh) {
    return "ply\nformat " + format + " 1.0\ncomment made in code\nelement vertex " +
           std::to_string(mesh.vertices.size()) +
           "\nproperty uchar red\nproperty double x\nproperty float y\nproperty float z\n"
           "property list uchar short notes\nelement face " +
           std::to_string(mesh.triangles.size()) +
           "\nproperty float quality\nproperty list ushort int vertex_index\nelement edge "
           "1\nproperty int a\n"
           "end_header\n";
}

std::string ascii_ply(const Mesh& mesh) {
    std::ostringstream text;
    text << ply_header("ascii", mesh);
    for (const Vec3& v : mesh.vertices) {
        text << "255 " << v.x << ' ' << v.y << ' ' << v.z << " 2 7 -8\n";
    }
    for (const Triangle& t : mesh.triangles) {
        text << "0.5 3 " << t[0] << ' ' << t[1] << ' ' << t[2] << "\n";
    }
    text << "0\n";
    return text.str();
}

template <class T>
std::string ordered(T value, bool big_endian) {
    std::string bytes = bytes_of(value);
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string binary_ply(const Mesh& mesh, bool big) {
    std::string bytes = ply_header(big ? "binary_big_endian" : "binary_little_endian", mesh);
    for (const Vec3& v : mesh.vertices) {
        bytes += '\xff' + ordered(v.x, big) + ordered(static_cast<float>(v.y), big) +
                 ordered(static_cast<float>(v.z), big) + '\x01' + ordered(std::int16_t{-8}, big);
    }
    for (const Triangle& t : mesh.triangles) {
        bytes += ordered(0.5f, big) + ordered(std::uint16_t{3}, big);
        for (const std::uint32_t corner : t) {
            bytes += ordered(corner, big);
        }
    }
    return bytes + ordered(0, big);
}

TEST(Ply, AllThreeEncodingsGiveTheSameMesh) {
    const Mesh box = test::box_mesh({-1, 2, 3}, {4, 6, 8.5});
    for (const std::string& bytes : {ascii_ply(box), binary_ply(box, false), binary_ply(box, true)}) {
        const auto loaded = read_as("box.ply", bytes);
        ASSERT_EQ(loaded.size(), 1u);
        EXPECT_EQ(bounding_box(loaded[0].mesh), bounding_box(box));
        EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), signed_volume(box));
        EXPECT_TRUE(is_closed(loaded[0].mesh));
    }
}

TEST(Ply, EveryTruncationIsRefused) {
    const Mesh cube = test::cube_mesh(20);
    for (const std::string& whole : {ascii_ply(cube), binary_ply(cube, true)}) {
        for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
            const std::string part = whole.substr(0, length);
            EXPECT_FALSE(test::refusal([&] { parse_ply({"a.ply", "a", part}); }).cause().empty()) << length;
        }
    }
}

TEST(Ply, WhatAHeaderPromisesIsCheckedAgainstTheBytes) {
    for (const std::string format : {"ascii", "binary_little_endian"}) {
        const std::string body(200, '1');
        const std::string vertices = "ply\nformat " + format +
                                     " 1.0\nelement vertex 4000000000\n"
                                     "property float x\nproperty float y\nproperty float z\nend_header\n";
        EXPECT_TRUE(test::names(refusal_of("a.ply", vertices + body).cause(), {4000000000, "vertex"}));
        const std::string empty = "ply\nformat " + format + " 1.0\nelement nothing 4000000000\nend_header\n";
        EXPECT_TRUE(test::names(refusal_of("a.ply", empty + body).cause(), {4000000000, "nothing"}));
        const std::string list = "ply\nformat " + format +
                                 " 1.0\nelement face 1\n"
                                 "property list uint uchar vertex_indices\nend_header\n";
        EXPECT_TRUE(test::names(refusal_of("a.ply", list + body).cause(), {"list"}));
    }
}

TEST(Ply, BadIndicesAndHeadersAreRefused) {
    const Mesh cube = test::cube_mesh(20);
    const auto with = [&](const std::string& old_text, const std::string& new_text) {
        std::string text = ascii_ply(cube);
        return text.replace(text.find(old_text), old_text.size(), new_text);
    };
    EXPECT_EQ(refusal_of("a.ply", with("3 0 2 1", "3 0 2 8")).place(), "face 1");
    EXPECT_EQ(refusal_of("a.ply", with("3 0 2 1", "2 0 2  ")).place(), "face 1");
    EXPECT_FALSE(refusal_of("a.ply", with("3 0 2 1", "3 0 2 -1")).cause().empty());
    EXPECT_FALSE(refusal_of("a.ply", with("3 0 2 1", "3 0 2 1.5")).cause().empty());
    EXPECT_FALSE(refusal_of("a.ply", with("255 0 0 0", "255 nan 0 0")).cause().empty());
    EXPECT_FALSE(refusal_of("a.ply", with("255 0 0 0", "255 0,5 0 0")).cause().empty());
    EXPECT_EQ(refusal_of("a.ply", with("ascii", "utf-16")).place(), "line 2");
    EXPECT_EQ(refusal_of("a.ply", with("property double x", "property long x")).place(), "line 6");
    EXPECT_EQ(refusal_of("a.ply", with("property double x", "propertx double x")).place(), "line 6");
    EXPECT_FALSE(refusal_of("a.ply", with("property double x", "property double u")).cause().empty());
}

const std::string kOffTetrahedron = "4 4 0\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST(Off, HeadersWithAndWithoutKeyWordColoursAndComments) {
    std::string coloured = kOffTetrahedron;
    coloured.replace(coloured.find("6 0 0\n"), 6, "6 0 0 0.5 0.5 0.5 1 # red\n");
    for (const std::string& text : {"OFF\n" + kOffTetrahedron, "OFF " + kOffTetrahedron, kOffTetrahedron,
                                    "# a\n\nOFF # b\n#c\n" + kOffTetrahedron, "COFF\n" + coloured}) {
        EXPECT_DOUBLE_EQ(signed_volume(read_as("a.off", text)[0].mesh), 36) << text;
    }
}

TEST(Off, ErrorsNameTheLine) {
    const auto with = [](const std::string& old_text, const std::string& new_text) {
        std::string text = "OFF\n" + kOffTetrahedron;
        return text.replace(text.find(old_text), old_text.size(), new_text);
    };
    EXPECT_EQ(refusal_of("a.off", with("4 4 0", "4000000000 4 0")).place(), "line 10");
    EXPECT_EQ(refusal_of("a.off", with("4 4 0", "-4 4 0")).place(), "line 2");
    EXPECT_EQ(refusal_of("a.off", with("4 4 0", "4")).place(), "line 2");
    EXPECT_EQ(refusal_of("a.off", with("6 0 0", "6 0")).place(), "line 4");
    EXPECT_EQ(refusal_of("a.off", with("6 0 0", "6 0 0,5")).place(), "line 4");
    EXPECT_EQ(refusal_of("a.off", with("3 0 1 3", "3 0 1 4")).place(), "line 8");
    EXPECT_EQ(refusal_of("a.off", with("3 0 1 3", "4 0 1 3")).place(), "line 8");
    EXPECT_EQ(refusal_of("a.off", with("3 0 1 3", "99999999999999 0 1 3")).place(), "line 8");
    EXPECT_EQ(refusal_of("a.off", with("OFF", "4OFF")).place(), "line 1");
    EXPECT_EQ(refusal_of("a.off", with("OFF", "OFF BINARY")).place(), "line 1");
}

}  // namespace
}  // namespace spectralpack
