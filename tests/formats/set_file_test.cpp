#include "formats/set_file.hpp"

#include "files.hpp"
#include "support/data.hpp"

namespace spectralpack {
namespace {

std::vector<SetRow> read(const std::string& text) {
    const test::TemporaryFolder folder;
    return read_set(test::write_bytes(folder / "set.csv", text));
}

TEST(SetFile, ColumnsComeInAnyOrderAndCountAndScaleMayBeMissing) {
    const auto full = read("scale,mesh,count\r\n0.5,\"a, b.stl\",3\r\n\r\n 2 , c.stl , 1 \r\n");
    ASSERT_EQ(full.size(), 2u);
    EXPECT_EQ(full[0].mesh, "a, b.stl");
    EXPECT_EQ(full[0].count, 3);
    EXPECT_EQ(full[0].scale, 0.5);
    EXPECT_EQ(full[0].line, 2);
    EXPECT_EQ(full[1].count, 1);
    EXPECT_EQ(full[1].line, 4);
    const auto bare = read("mesh\na.stl\n");
    ASSERT_EQ(bare.size(), 1u);
    EXPECT_EQ(bare[0].count, 1);
    EXPECT_EQ(bare[0].scale, 1);
}

TEST(SetFile, WhatIsWrongIsRefusedWithItsLine) {
    const std::pair<const char*, const char*> cases[] = {{"mesh,colour\na.stl,red\n", "line 1"},
                                                         {"mesh;count,scale\na.stl;1,2\n", "line 1"},
                                                         {"count\n1\n", "line 1"},
                                                         {"mesh,mesh\na,b\n", "line 1"},
                                                         {"mesh,count\n\na.stl\n", "line 3"},
                                                         {"mesh,count\na.stl,0\n", "line 2"},
                                                         {"mesh,count\na.stl,-1\n", "line 2"},
                                                         {"mesh,count\na.stl,1.5\n", "line 2"},
                                                         {"mesh,count\na.stl,9999999999\n", "line 2"},
                                                         {"mesh,count\na.stl,\n", "line 2"},
                                                         {"mesh,scale\na.stl,\"0,5\"\n", "line 2"},
                                                         {"mesh,scale\na.stl,0\n", "line 2"},
                                                         {"mesh,scale\na.stl,nan\n", "line 2"},
                                                         {"mesh,scale\na.stl,1e999\n", "line 2"},
                                                         {"mesh,count\n ,1\n", "line 2"},
                                                         {"file,mesh\na,b\n", "line 1"},
                                                         {"mesh,unit\na.stl,cubit\n", "line 2"},
                                                         {"mesh,gap\na.stl,-1\n", "line 2"},
                                                         {"mesh,value\na.stl,-1\n", "line 2"},
                                                         {"mesh,due\na.stl,2026-02-30\n", "line 2"},
                                                         {"mesh,orientations\na.stl,sideways\n", "line 2"},
                                                         {"mesh,orientations\na.stl,+z up\n", "line 2"},
                                                         {"mesh,\na.stl,5\n", "line 2"}};
    for (const auto& wrong : cases) {
        const auto& text = wrong.first;  // clang 14 cannot capture structured bindings
        const auto& place = wrong.second;
        EXPECT_EQ(test::refusal([&] { read(text); }).place(), place) << text;
    }
    EXPECT_TRUE(test::names(test::refusal([] { read(""); }).cause(), {"empty"}));
}

TEST(SetFile, EveryColumnIsRead) {
    const auto rows = read(
        "Orientations;VALUE;Due; Priority ;Gap;Unit;Scale;Quantity;Name;File;\r\n"
        "upright;2,5;2026-12-01;-1;1,5;Inch;1,02;12;Lid;parts/a.stl;\r\n"
        "+z -X;;;;;;;1;;b.stl;\r\n"
        "fixed;0;;;0;mm;;3;;c.stl;\r\n");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].mesh, "parts/a.stl");
    EXPECT_EQ(rows[0].name, "Lid");
    EXPECT_EQ(rows[0].count, 12);
    EXPECT_EQ(rows[0].scale, 1.02);
    EXPECT_EQ(rows[0].unit, 25.4);
    EXPECT_EQ(rows[0].gap, 1.5);
    EXPECT_EQ(rows[0].priority, -1);
    EXPECT_EQ(rows[0].due, "2026-12-01");
    EXPECT_EQ(rows[0].value, 2.5);
    EXPECT_EQ(rows[0].orientations.kind, PartOrientations::Kind::upright);
    EXPECT_EQ(rows[1].name, "");
    EXPECT_EQ(rows[1].scale, 1);
    EXPECT_FALSE(rows[1].unit);
    EXPECT_FALSE(rows[1].gap);
    EXPECT_EQ(rows[1].value, 1);
    EXPECT_EQ(rows[1].orientations.kind, PartOrientations::Kind::axes);
    EXPECT_EQ(rows[1].orientations.up, (std::vector<SignedAxis>{{2, true}, {0, false}}));
    EXPECT_EQ(rows[2].orientations.kind, PartOrientations::Kind::fixed);
    EXPECT_EQ(rows[2].gap, 0);
}

TEST(SetFile, AnUnknownColumnIsNamedWithThoseThatAreKnown) {
    EXPECT_TRUE(test::names(test::refusal([] { read("mesh,colour\na.stl,red\n"); }).cause(),
                            {"colour", "mesh", "file", "name", "count", "quantity", "scale", "unit", "gap", "priority",
                             "due", "value", "orientations"}));
}

TEST(SetFile, TheBenchmarkSetsAreRead) {
    SPECTRALPACK_NEEDS_DATA();
    int copies = 0;
    for (const SetRow& row : read_set(*test::benchmark_data() / "sets" / "pieces.csv")) {
        copies += row.count;
    }
    EXPECT_EQ(copies, 1446);
}

}  // namespace
}  // namespace spectralpack
