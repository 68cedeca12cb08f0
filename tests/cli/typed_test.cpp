/// What people type, on the built program.

#include <set>

#include "cli/whole_job.hpp"
#include "formats/csv.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Typed : public WholeJob {
  protected:
    /// With what is needed for a small packing.
    Ran pack_cubes(const std::vector<std::string>& arguments) {
        return pack(std::vector<std::string>{"--tray", "40x40x40"} + arguments);
    }

    std::vector<std::string> part_names() const {
        std::vector<std::string> names;
        const json packing = build();
        for (const json& part : packing["parts"]) {
            names.push_back(part["name"]);
        }
        return names;
    }

    void folder_with(const std::vector<std::string>& files) {
        for (const std::string& file : files) {
            fs::create_directories((folder_ / file).parent_path());
            std::ofstream(at(file)) << "text";
        }
    }
};

TEST_F(Typed, TheVersionIsSaidInEveryWayThatPeopleAskForIt) {
    const Ran version = spectralpack({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_TRUE(version.out.starts_with("spectralpack "));
    EXPECT_EQ(spectralpack({"-V"}).out, version.out);
    EXPECT_EQ(spectralpack({"version"}).out, version.out);
}

TEST_F(Typed, ACommandOrAnOptionThatIsNotThereIsNamedWithTheOneThatWasMeant) {
    const std::pair<std::vector<std::string>, std::vector<Fact>> cases[] = {
        {{"pak", at("cube.stl")}, {"'pak'", "'pack'"}},
        {{at("cube.stl")}, {"no command", "spectralpack pack"}},
        {{"pack", at("cube.stl"), "--try", "160x120x100"}, {"option --try.", "--tray?"}},
        {{"pack", at("cube.stl"), "--tary=160x120x100"}, {"option --tary.", "--tray?"}},
        {{"check", at("build.json"), "--requireplan"}, {"--require-plan?"}},
        {{"pack", "-cube.stl"}, {"./-cube.stl"}},
        {{"pack", at("cube.stl"), "--printer", "hp-mjf-520"}, {"hp-mjf-520", "hp-mjf-5200", "--printer list"}}};
    for (const auto& [arguments, facts] : cases) {
        const Ran ran = spectralpack(arguments);
        EXPECT_EQ(ran.status, 2) << ran.err;
        EXPECT_TRUE(names(ran.err, facts));
    }
}

TEST_F(Typed, AFileThatIsNotThereIsNamedWithOneThatIsNear) {
    const Ran ran = pack_cubes({at("cubes.stl:3")});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"cubes.stl", "near it: cube.stl"}));
}

TEST_F(Typed, WhatCannotBeUsedIsLeftOverHoweverItIsNamed) {
    std::ofstream(at("set.csv")) << "mesh,count\ncube.stl,2\nnothing.stl,5\n";
    std::ofstream(at("bad.csv")) << "mesh,count\ncube.stl,many\n";
    fs::create_directory(folder_ / "empty");
    const std::pair<std::vector<std::string>, int> cases[] = {{{at("set.csv")}, 5},
                                                              {{at("cube.stl:2"), at("nothing.stl:5")}, 5},
                                                              {{at("cube.stl:2"), at("bad.csv")}, 1},
                                                              {{at("cube.stl:2"), at("empty")}, 1}};
    for (const auto& [parts, left] : cases) {
        SCOPED_TRACE(parts.back());
        const Ran ran =
            pack_cubes(parts + std::vector<std::string>{"--skip-unusable", "--require-all", "--report", at("r.csv")});
        EXPECT_EQ(ran.status, 5) << ran.out << ran.err;
        EXPECT_TRUE(names(ran.out, {2, 2 + left, left, "file cannot be used"}));
        const json packing = build();
        EXPECT_EQ(packing["metrics"]["copies"], 2 + left);
        ASSERT_EQ(packing["unplaced"].size(), static_cast<std::size_t>(left));
        EXPECT_EQ(packing["unplaced"][0]["reason"], "bad_file");
        EXPECT_NE(packing["unplaced"][0]["detail"], "");
        EXPECT_TRUE(names(read_text(folder_ / "r.csv"), {"bad_file"}));
        expect_sound();
        EXPECT_EQ(pack_cubes(parts).status, 3);
        const Ran both = pack_cubes(parts + std::vector<std::string>{"--require-all"});
        EXPECT_EQ(both.status, 3);
        EXPECT_TRUE(names(both.out, {"--require-all", "exit 3"}));
    }
}

TEST_F(Typed, AScaleNeedsNoCount) {
    ASSERT_EQ(pack_cubes({at("cube.stl@1.5"), at("slab.stl@5e-1")}).status, 0);
    EXPECT_EQ(build()["parts"][0]["scale"], 1.5);
    EXPECT_EQ(build()["parts"][0]["count"], 1);
    EXPECT_EQ(build()["parts"][1]["scale"], 0.5);
    EXPECT_EQ(pack_cubes({at("cube.stl@0")}).status, 2);
    stl("part@2.stl", cube_mesh(8));
    ASSERT_EQ(pack_cubes({at("part@2.stl")}).status, 0) << "a file of that name is that file";
    EXPECT_EQ(build()["parts"][0]["scale"], 1);
}

TEST_F(Typed, ACountOrScaleThatIsNoneSaysWhatOneIs) {
    for (const char* count : {"99999999999", "2.5", "+3", "0"}) {
        const Ran ran = pack_cubes({at("cube.stl:") + count});
        EXPECT_EQ(ran.status, 2);
        EXPECT_TRUE(names(ran.err, {std::string("'") + count + "'", "whole number from 1 to 10000000"}));
    }
    for (const char* scale : {"@1,5", ":2@1,5"}) {
        const Ran ran = pack_cubes({at("cube.stl") + scale});
        EXPECT_EQ(ran.status, 2);
        EXPECT_TRUE(names(ran.err, {"'1,5'", "point"}));
    }
    for (const char* neither : {"@1.5:2", ":abc", ":3x", ":1e3", ": 3", ":2:3", ":"}) {
        const Ran ran = pack_cubes({at("cube.stl") + neither});
        EXPECT_EQ(ran.status, 2) << neither;
        EXPECT_TRUE(names(ran.err, {"FILE:COUNT@SCALE", at("cube.stl:2@1.5")}));
    }
    EXPECT_EQ(pack_cubes({at("cube.stl@150%")}).status, 2);
    EXPECT_EQ(pack_cubes({at("nothing.stl:abc")}).status, 3) << "that is a file which is not there";
}

TEST_F(Typed, EndingsMayHaveAnyCaseAndReportsBeSeveral) {
    std::ofstream(at("SET.CSV")) << "MESH;Quantity\ncube.stl;2\n";
    const Ran ran = pack_cubes(
        {at("SET.CSV"), "-o", at("a.PNG"), "-o", at("a.3MF"), "--report", at("r.HTML"), "--report", at("r.csv")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(read_text(folder_ / "a.PNG").starts_with("\x89PNG"));
    EXPECT_TRUE(read_text(folder_ / "a.3MF").starts_with("PK"));
    EXPECT_TRUE(read_text(folder_ / "r.HTML").starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(read_text(folder_ / "r.csv").starts_with("part,"));
    EXPECT_EQ(spectralpack({"render", at("build.json"), "-o", at("b.Png")}).status, 0);
    const Ran step = pack_cubes({at("cube.stl"), "-o", at("b.step")});
    EXPECT_EQ(step.status, 2);
    EXPECT_TRUE(names(step.err, {"b.step", ".3mf", ".png"}));
}

TEST_F(Typed, UprightPartsKeepTheirTopUp) {
    stl("pole.stl", box_mesh({0, 0, 0}, {10, 10, 60}));
    EXPECT_EQ(pack({at("pole.stl"), "--tray", "80x80x20"}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 1);
    const json upright = json::parse(pack({at("pole.stl"), "--tray", "80x80x20", "--upright", "--json"}).out);
    EXPECT_EQ(upright["metrics"]["placed"], 0);
    EXPECT_EQ(upright["parts"][0]["orientations"], "upright");
    EXPECT_EQ(upright["options"]["upright"], true);
    std::ofstream(at("set.csv")) << "mesh,orientations\npole.stl,+x\n";
    pack({at("set.csv"), "--tray", "80x80x20", "--upright"});
    EXPECT_EQ(build()["metrics"]["placed"], 1) << "what the set says of a part counts for it";
}

TEST_F(Typed, ASetSaysOfAPartWhatAJobCan) {
    std::ofstream(at("set.csv")) << "file,name,unit,gap,priority,due,value,orientations\n"
                                    "cube.stl,lid,inch,3,2,2026-12-01,4.5,fixed\n"
                                    "slab.stl,,,,,,,\n";
    ASSERT_EQ(pack({at("set.csv"), "--tray", "300x300x300", "--voxel", "10"}).status, 0);
    const json lid = build()["parts"][0], slab = build()["parts"][1];
    EXPECT_EQ(lid["name"], "lid");
    EXPECT_EQ(lid["unit"], 25.4);
    EXPECT_NEAR(lid["volume"], 254.0 * 254 * 254, 1);
    EXPECT_EQ(lid["gap"], 3);
    EXPECT_EQ(lid["priority"], 2);
    EXPECT_EQ(lid["due"], "2026-12-01");
    EXPECT_EQ(lid["value"], 4.5);
    EXPECT_EQ(lid["orientations"], "fixed");
    EXPECT_EQ(slab["unit"], 1);
    EXPECT_EQ(slab["value"], 1);
    EXPECT_EQ(slab["due"], nullptr);
    expect_sound();
}

TEST_F(Typed, ASetInWindows1252KeepsItsUmlauts) {
    stl("H\u00fclse \u2013 \u20ac.stl", cube_mesh(8));
    std::ofstream(at("set.csv")) << "mesh;name\nH\xfclse \x96 \x80.stl;Gr\xf6\xdf"
                                    "e\n";
    const Ran ran = pack_cubes({at("set.csv")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {"set.csv", "Windows-1252"}));
    EXPECT_EQ(build()["parts"][0]["name"], "Gr\u00f6\u00dfe");
    EXPECT_EQ(build()["parts"][0]["mesh"], "H\u00fclse \u2013 \u20ac.stl");
    std::ofstream(at("set.csv")) << "mesh;name\nH\u00fclse \u2013 \u20ac.stl;Gr\u00f6\u00dfe\n";
    const Ran utf8 = pack_cubes({at("set.csv")});
    EXPECT_EQ(utf8.status, 0) << utf8.err;
    EXPECT_FALSE(contains(utf8.err, "1252"));
    EXPECT_EQ(build()["parts"][0]["name"], "Gr\u00f6\u00dfe");
}

TEST_F(Typed, AnOptionThatIsGivenTwiceIsNamed) {
    const Ran ran = pack({at("cube.stl"), "--voxel", "2", "--voxel", "4"});
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(names(ran.err, {"--voxel is given 2 times"}));
    EXPECT_FALSE(contains(ran.err, "required"));
}

TEST_F(Typed, ASetWithoutRowsIsNamed) {
    std::ofstream(at("header.csv")) << "mesh,count\n";
    const Ran ran = pack_cubes({at("header.csv")});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"header.csv", "below its header"}));
}

TEST_F(Typed, WhatIsHiddenInAFolderIsPassedOver) {
    for (const char* folder : {"parts", "parts/.git", "parts/deep"}) {
        fs::create_directory(folder_ / folder);
        stl(std::string(folder) + "/cube.stl", cube_mesh(8));
    }
    std::ofstream(at("parts/._cube.stl")) << "of macOS";
    const Ran ran = pack_cubes({at("parts")});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(build()["parts"].size(), 2u);
    EXPECT_EQ(pack_cubes({at("parts/.git")}).status, 0) << "what is named is meant";
}

TEST_F(Typed, PartsOfTheSameFileNameStayApart) {
    for (const char* folder : {"left", "right"}) {
        fs::create_directory(folder_ / folder);
        stl(std::string(folder) + "/clip.stl", cube_mesh(folder[0] == 'l' ? 8 : 9));
    }
    ASSERT_EQ(pack_cubes({at("left"), at("right"), at("cube.stl"), at("cube.stl@1.5"), "-o", at("build.csv"), "-o",
                          at("build.3mf")})
                  .status,
              0);
    const std::vector<std::string> wanted{"left/clip", "right/clip", "cube", "cube x 1.5"};
    EXPECT_EQ(part_names(), wanted);
    std::set<std::string> in_table;
    for (const CsvRow& row : parse_csv("build.csv", read_text(folder_ / "build.csv"))) {
        in_table.insert(row.fields[2]);
    }
    for (const std::string& name : wanted) {
        EXPECT_TRUE(in_table.contains(name)) << name;
    }
    ASSERT_EQ(pack_cubes({at("build.3mf")}).status, 0) << "the part numbers are its objects' names";
    const std::vector<std::string> again = part_names();
    EXPECT_NE(std::find(again.begin(), again.end(), "left/clip"), again.end());
}

TEST_F(Typed, APartThatIsTooLargeSaysWhatWouldTakeIt) {
    stl("rod.stl", box_mesh({0, 0, 0}, {100, 4, 4}));
    const Ran turned = pack({at("rod.stl"), "--tray", "80x80x20"});
    EXPECT_TRUE(names(turned.err, {"rod", 100, 80, "--rotations 45"})) << "it lies across";
    EXPECT_EQ(pack({at("rod.stl"), "--tray", "80x80x20", "--rotations", "45"}).status, 0);
    EXPECT_EQ(build()["metrics"]["placed"], 1);
    stl("beam.stl", box_mesh({0, 0, 0}, {500, 45, 49}));
    const Ran larger = pack({at("beam.stl"), "--printer", "formlabs-fuse1", "--json"});
    EXPECT_TRUE(names(larger.err, {"beam", 500, 159, "EOS P 396", "--printer eos-p396"}));
    const json unplaced = json::parse(larger.out)["unplaced"][0];
    EXPECT_TRUE(names(unplaced["detail"].get<std::string>(), {"eos-p396"}));
    EXPECT_EQ(unplaced["reason"], "too_large");
    std::ofstream(at("set.csv")) << "mesh,orientations\nrod.stl,upright\n";
    EXPECT_TRUE(names(pack({at("set.csv"), "--tray", "90x20x110"}).err, {"rod", "--rotations", "orientations"}))
        << "it could be stood up";
    std::ofstream(at("own.json")) << "{}";
    std::ofstream(at("printers.json")) << json{{"printers", {{{"name", "long-one"}, {"size", {510, 50, 50}}}}}};
    EXPECT_TRUE(names(pack({at("beam.stl"), "--printer", "formlabs-fuse1", "--config", at("own.json")}).err,
                      {"--printer long-one"}));
    stl("huge.stl", cube_mesh(5000));
    const Ran none = pack({at("huge.stl"), "--printer", "formlabs-fuse1"});
    EXPECT_FALSE(contains(none.err, "--printer")) << none.err;
}

TEST_F(Typed, ManyRotationsAreWarnedOfBeforePacking) {
    const Ran many = pack({at("cube.stl"), "--tray", "20x20x20", "--rotations", "15"});
    EXPECT_EQ(many.status, 0);
    EXPECT_TRUE(names(many.err, {"--rotations 15", "--rotations 90", 24, "GB"}));
    EXPECT_EQ(pack({at("cube.stl"), "--tray", "20x20x20", "--rotations", "45"}).err, "");
}

TEST_F(Typed, KeepOutsWantSixNumbers) {
    const Ran four = pack({at("cube.stl"), "--tray", "200x200x100", "--keep-out", "50,50,150,150"});
    EXPECT_EQ(four.status, 2);
    EXPECT_TRUE(names(four.err, {"six numbers", "50,50,0,150,150,100"}));
    EXPECT_EQ(pack({at("cube.stl"), "--keep-out", "50, 50, 0, 150, 150, 100"}).status, 0) << "blanks do not matter";
}

TEST_F(Typed, KeepOutsThatLeaveNoRoomAreAnErrorBeforePacking) {
    for (const char* dry : {"--json", "--dry-run"}) {
        const Ran full = pack({at("cube.stl"), "--tray", "100x100x100", "--keep-out", "0,0,0,100,100,100", dry});
        EXPECT_EQ(full.status, 2) << full.err;
        EXPECT_TRUE(names(full.err, {"keep-out", "no room"}));
        EXPECT_FALSE(fs::exists(folder_ / "build.json"));
    }
    const Ran low = pack({at("cube.stl"), "--tray", "100x100x100", "--keep-out", "0,0,0,100,100,94", "--json"});
    const json unplaced = json::parse(low.out)["unplaced"][0];
    EXPECT_EQ(unplaced["reason"], "no_place");
    EXPECT_TRUE(names(unplaced["detail"].get<std::string>(), {"empty", "keep-outs"}));
}

TEST_F(Typed, AKeepOutOutsideTheTrayIsWarnedOf) {
    const Ran ran = pack({at("cube.stl"), "--tray", "100x100x100", "--keep-out", "100,0,0,120,20,20"});
    EXPECT_EQ(ran.status, 0);
    EXPECT_TRUE(names(ran.err, {"keep-out", 100, 120, "outside"}));
    EXPECT_EQ(pack({at("cube.stl"), "--tray", "100x100x100", "--keep-out", "90,0,0,120,20,20"}).err, "");
}

TEST_F(Typed, FilesInFoldersThatArePassedOverAreListed) {
    folder_with({"parts/base.step", "parts/deep/drawing.pdf", "parts/.hidden"});
    stl("parts/cube.stl", cube_mesh(10));
    const Ran ran = pack_cubes({at("parts")});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {2, "base.step", "drawing.pdf"}));
    EXPECT_FALSE(contains(ran.err, ".hidden"));
}

TEST_F(Typed, ABuildOfOursInAFolderIsNotTakenForParts) {
    fs::create_directory(folder_ / "parts");
    stl("parts/cube.stl", cube_mesh(10));
    ASSERT_EQ(pack_cubes({at("parts"), "-o", at("parts/build.3mf")}).status, 0);
    const Ran again = pack_cubes({at("parts")});
    EXPECT_TRUE(names(again.err, {"build.3mf", "name the file"}));
    EXPECT_EQ(build()["parts"].size(), 1u);
    ASSERT_EQ(pack_cubes({at("parts"), at("parts/build.3mf")}).status, 0);
    EXPECT_EQ(build()["parts"].size(), 2u) << "unless it is named";
}

TEST_F(Typed, TraysCountFromOne) {
    const Ran ran = pack({at("cube.stl") + ":3", "--tray", "10x10x10", "--trays", "all", "-o", at("build.csv")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto trays_in = [&](const char* file) {
        std::vector<std::string> trays;
        for (const CsvRow& row : parse_csv(file, read_text(folder_ / file))) {
            trays.push_back(row.fields[0]);
        }
        return trays;
    };
    EXPECT_EQ(trays_in("build.csv"), (std::vector<std::string>{"tray", "1", "2", "3"}));
    EXPECT_EQ(trays_in("build-3.csv"), (std::vector<std::string>{"tray", "3"}));
    const Ran checked = spectralpack({"check", at("build.json")});
    EXPECT_TRUE(names(checked.out, {"tray 1", "tray 3"}));
    EXPECT_FALSE(contains(checked.out, "tray 0"));
    EXPECT_TRUE(names(spectralpack({"plan", at("build.json")}).out, {"tray 1", "tray 3"}));
    EXPECT_EQ(spectralpack({"render", at("build.json"), "--tray", "3", "-o", at("3.png")}).status, 0);
    const Ran fourth = spectralpack({"render", at("build.json"), "--tray", "4", "-o", at("4.png")});
    EXPECT_EQ(fourth.status, 2);
    EXPECT_TRUE(names(fourth.err, {"tray 4", 3}));
    EXPECT_EQ(spectralpack({"render", at("build.json"), "--tray", "0", "-o", at("0.png")}).status, 2);
    json wrong = build();
    wrong["trays"][2]["density"] = 0.5;
    const json finding = finding_of(wrong);
    EXPECT_EQ(finding["tray"], 3);
    EXPECT_TRUE(names(finding["message"].get<std::string>(), {"tray 3"}));
}

TEST_F(Typed, AWrongUnitIsRemarkedWithTheRightSize) {
    stl("metre-part.stl", cube_mesh(0.12));
    EXPECT_TRUE(names(pack_cubes({at("metre-part.stl")}).err, {"metre-part", 0.12, 120, 3.048, "--unit", "column"}));
}

}  // namespace
}  // namespace spectralpack::test
