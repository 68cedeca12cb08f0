#include "files.hpp"
#include "geometry/mesh_edges.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::read_as;
using test::refusal_of;

const std::string kCubeVertices =
    "v 0 0 0\nv 20 0 0\nv 0 20 0\nv 20 20 0\nv 0 0 20\nv 20 0 20\nv 0 20 20\nv 20 20 20\n";
const std::string kCubeFaces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

TEST(Obj, QuadsBecomeTriangles) {
    const auto loaded = read_as("cube.obj", "o cube\n" + kCubeVertices + kCubeFaces);
    ASSERT_EQ(loaded.size(), 1u);
    EXPECT_EQ(loaded[0].name, "cube");
    EXPECT_EQ(loaded[0].mesh.triangles.size(), 12u);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 8000);
    EXPECT_TRUE(is_closed(loaded[0].mesh));
    EXPECT_TRUE(loaded[0].repairs.empty());
}

TEST(Obj, CommentsContinuationsColoursAndUnknownStatementsAreFine) {
    std::string text = "# cube\r\nmtllib /dev/zero\r\nvp 0.1\r\n" + kCubeVertices + "vn 0 0 1\ns off\nusemtl red\n";
    text.replace(text.find("v 20 0 0"), 8, "v 20 0 0 1.0 0.5 0.25 # red");
    EXPECT_DOUBLE_EQ(
        signed_volume(
            read_as("a.obj", text + "f 1 3 \\\n 4 2 # front\n" + kCubeFaces.substr(kCubeFaces.find('\n') + 1))[0].mesh),
        8000);
}

TEST(Obj, VerticesMayComeAfterTheFacesThatUseThem) {
    EXPECT_DOUBLE_EQ(signed_volume(read_as("a.obj", kCubeFaces + kCubeVertices)[0].mesh), 8000);
}

TEST(Obj, ErrorsNameTheLine) {
    const auto refused = [](const std::string& statement) {
        return refusal_of("a.obj", kCubeVertices + statement + "\n" + kCubeFaces).place();
    };
    for (const char* statement : {"f 1 2 9", "f 0 1 2", "f 1 2 -9", "f 1 2", "f 1 x 2", "f 1 2 3,4", "v 1 2",
                                  "v 1 2 inf", "v 1 2,5 3", "f 1 2 99999999999999999999"}) {
        EXPECT_EQ(refused(statement), "line 9") << statement;
    }
    EXPECT_TRUE(test::names(refusal_of("a.obj", kCubeVertices).cause(), {"triangles"}));
    EXPECT_TRUE(test::names(refusal_of("a.obj", "# nothing\n").cause(), {"triangles"}));
}

}  // namespace
}  // namespace spectralpack
