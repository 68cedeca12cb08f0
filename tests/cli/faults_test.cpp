/// What goes wrong around a run: output that is lost, options and files that say nothing sound, outputs that cannot be
/// written, meshes that change meanwhile.

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Faults : public WholeJob {
  protected:
    /// Runs the program by a shell that sends standard output there.
    static Ran to(const std::string& target, const std::vector<std::string>& arguments) {
        std::string line = std::string("exec '") + SPECTRALPACK_PROGRAM + "'";
        for (const std::string& argument : arguments) {
            line += " '" + argument + "'";
        }
        return run({"/bin/sh", "-c", line + " >" + target});
    }

    void expect_refused_before_packing(const std::vector<std::string>& more, const std::vector<Fact>& facts) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack", at("cube.stl:2"), "--tray", "11x11x11"} + more);
        EXPECT_EQ(ran.status, 2) << ran.err;
        EXPECT_TRUE(ran.out.empty()) << ran.out;
        EXPECT_TRUE(names(ran.err, facts));
    }

    std::vector<std::string> files() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_.path())) {
            found.push_back(entry.path().filename().string());
        }
        std::ranges::sort(found);
        return found;
    }

    void write(const std::string& name, const std::string& text) const { std::ofstream(at(name)) << text; }
};

TEST_F(Faults, OutputThatIsLostIsToldByEveryCommand) {
    ASSERT_EQ(pack({at("cube.stl")}).status, 0);
    const std::vector<std::vector<std::string>> calls{{"pack", at("cube.stl"), "--json"},
                                                      {"pack", at("cube.stl")},
                                                      {"pack", at("cube.stl"), "--dry-run"},
                                                      {"pack", "--printer", "list"},
                                                      {"pack", "--help"},
                                                      {"check", at("build.json")},
                                                      {"check", "--json", at("build.json")},
                                                      {"plan", at("build.json")},
                                                      {"plan", "--json", at("build.json")},
                                                      {"render", at("build.json"), "-o", at("a.png")},
                                                      {"inspect", at("cube.stl")},
                                                      {"inspect", "--json", at("cube.stl")},
                                                      {"generate", "tori", "--count", "1", "-o", at("tori")},
                                                      {"help", "gap"},
                                                      {"--help"},
                                                      {"--version"},
                                                      {"version"}};
    for (const auto& call : calls) {
        for (const char* lost : {"/dev/full", "&-"}) {
            const Ran ran = to(lost, call);
            EXPECT_EQ(ran.status, 4) << call.front() << " >" << lost << ": " << ran.err;
            EXPECT_TRUE(names(ran.err, {"standard output"})) << call.front();
        }
        EXPECT_EQ(to("/dev/null", call).status, 0) << call.front();
    }
}

TEST_F(Faults, AClosedOutputDoesNotEndUpInAFile) {
    EXPECT_EQ(to("&-", {"pack", at("cube.stl"), "-o", at("build.json"), "-o", at("build.csv")}).status, 4);
    EXPECT_EQ(build()["metrics"]["placed"], 1);
    EXPECT_EQ(read_text(at("build.csv")).find("Written"), std::string::npos);
}

TEST_F(Faults, ASetOrJobThatNamesNoPartSaysSo) {
    write("none.csv", "mesh,count\n");
    write("none.json", R"({"format": "spectralpack/job", "version": 1, "parts": []})");
    for (const char* name : {"none.csv", "none.json"}) {
        const Ran ran = pack({at(name)});
        EXPECT_EQ(ran.status, 3) << name;
        EXPECT_TRUE(names(ran.err, {name, "nothing"})) << ran.err;
    }
    EXPECT_EQ(pack({at("none.json"), at("cube.stl")}).status, 0) << "what is named beside a job is packed";
    EXPECT_EQ(pack({at("none.csv"), at("cube.stl")}).status, 3) << "packed, but a named file was of no use";
    EXPECT_EQ(build()["metrics"]["placed"], 1);
}

TEST_F(Faults, ATrayThatStaysEmptyLeavesCopiesOverAndIsNoBadFile) {
    const std::vector<std::string> call{at("cube.stl"), at("slab.stl@1.3"), "--tray", "60x60x60", "--trays", "2",
                                        "--keep-out",   "0,0,0,48,60,60"};
    const Ran ran = pack(call);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {"slab", "tray 2"}));
    EXPECT_EQ(build()["unplaced"].size(), 1u);
    EXPECT_EQ(build()["unplaced"][0]["reason"], "no_place");
    EXPECT_EQ(pack(call + std::vector<std::string>{"--require-all"}).status, 5);
}

TEST_F(Faults, KeepOutsThatLeaveNoRoomAreWrongUsage) {
    stl("room.stl", cube_mesh(50));
    const std::string whole = "0,0,0,50,50,50";
    EXPECT_EQ(pack({at("cube.stl"), "--tray", "50x50x50", "--keep-out", whole}).status, 2);
    const Ran ran = pack({at("cube.stl"), "--container", at("room.stl"), "--keep-out", whole});
    EXPECT_EQ(ran.status, 2) << ran.err;
    EXPECT_TRUE(names(ran.err, {"keep-outs"}));
}

TEST_F(Faults, AnEmptyValueIsRefusedAndTakesNothing) {
    for (const char* empty : {"--gap=", "--seed=", "--tray=", "--output=", "--job-name=", "--json="}) {
        const Ran ran = pack({at("cube.stl"), empty, "--dry-run"});
        EXPECT_EQ(ran.status, 2) << empty;
        EXPECT_TRUE(names(ran.err, {empty})) << ran.err;
    }
    ASSERT_EQ(pack({at("cube.stl")}).status, 0);
    EXPECT_EQ(spectralpack({"check", at("build.json"), "--threads=", "1"}).status, 2);
}

TEST_F(Faults, NumbersAreDecimalAndWithinTheirRangeForEveryCommand) {
    ASSERT_EQ(pack({at("cube.stl")}).status, 0);
    const std::string build_file = at("build.json"), picture = at("a.png"), made = at("made");
    const std::string over = "99999999999999999999";
    const std::vector<std::vector<std::string>> wrong{
        {"pack", at("cube.stl"), "--gap=0x10"},
        {"pack", at("cube.stl"), "--seed=-1"},
        {"pack", at("cube.stl"), "--seed=" + over},
        {"pack", at("cube.stl"), "--seed=0x1"},
        {"pack", at("cube.stl"), "--memory=0x100M"},
        {"pack", at("cube.stl"), "--tray=0x10x10x10"},
        {"pack", at("cube.stl"), "--tray=10x0x10x10"},
        {"pack", at("cube.stl"), "--rotations=0x5a"},
        {"pack", at("cube.stl"), "--trays=0x2"},
        {"pack", at("cube.stl"), "--time-limit=1e999"},
        {"pack", at("cube.stl"), "--time-limit=inf"},
        {"generate", "tori", "-o", made, "--seed=-1"},
        {"generate", "tori", "-o", made, "--seed=" + over},
        {"generate", "tori", "-o", made, "--seed=0x1"},
        {"generate", "tori", "-o", made, "--count=0x1"},
        {"generate", "tori", "-o", made, "--count=0"},
        {"generate", "segments", at("cube.stl"), "-o", made, "--pieces=0x2"},
        {"generate", "segments", at("cube.stl"), "-o", made, "--tray=0x10x10x10"},
        {"prepare", folder_.path().string(), "-o", "/tmp/none", "--triangles=-1"},
        {"check", build_file, "--threads=0x1"},
        {"plan", build_file, "--voxel=0x2"},
        {"plan", build_file, "--ray-spacing=nan"},
        {"plan", build_file, "--time-limit=-1"},
        {"render", build_file, "-o", picture, "--azimuth=0x10"},
        {"render", build_file, "-o", picture, "--elevation=91"},
        {"render", build_file, "-o", picture, "--tray=0"},
        {"render", build_file, "-o", picture, "--explode=inf"},
        {"render", build_file, "-o", picture, "--section=z=0x1"},
        {"bench", "--table", "tori", "-o", made, "--time-limit=0x1"}};
    for (const auto& call : wrong) {
        const Ran ran = spectralpack(call);
        EXPECT_EQ(ran.status, 2) << call.front() << " " << call.back() << ": " << ran.err;
        EXPECT_TRUE(names(ran.err, {call.back().substr(0, call.back().find('='))})) << ran.err;
    }
    EXPECT_FALSE(fs::exists(made));
    EXPECT_FALSE(fs::exists(picture));
    EXPECT_EQ(spectralpack({"render", build_file, "-o", picture, "--azimuth", "-30", "--size", "64x64"}).status, 0);
}

TEST_F(Faults, AnArgumentOfAnyLengthIsAName) {
    const Ran ran = pack({std::string(100'000, 'a') + ":x"});
    EXPECT_EQ(ran.status, 3) << ran.err.substr(0, 200);
}

TEST_F(Faults, CheckReadsThePlacementsMeshes) {
    ASSERT_EQ(pack({at("cube.stl:2")}).status, 0);
    const json sound = build();
    const auto expect_bad = [&](const json& packing, const std::vector<Fact>& facts) {
        std::ofstream(at("build.json")) << packing;
        const Ran ran = spectralpack({"check", at("build.json")});
        EXPECT_EQ(ran.status, 3) << ran.out;
        EXPECT_TRUE(names(ran.err, facts)) << ran.err;
    };
    json packing = sound;
    packing["trays"][0]["placements"][1]["mesh"] = "other.stl";
    expect_bad(packing, {"placements[1].mesh", "cube.stl"});
    packing["trays"][0]["placements"][1]["mesh"] = 5;
    expect_bad(packing, {"placements[1].mesh"});
    packing = sound;
    packing["trays"][0]["placements"][1]["scale"] = 2;
    expect_bad(packing, {"placements[1].scale"});
    packing = sound;
    packing["trays"][0]["placements"][1]["mesh"] = "./" + sound["parts"][0]["mesh"].get<std::string>();
    std::ofstream(at("build.json")) << packing;
    expect_sound();
}

TEST_F(Faults, OutputsAreDifferentFiles) {
    expect_refused_before_packing({"-o", at("a.csv"), "--report", at("a.csv")}, {"--report", "a.csv", "-o"});
    expect_refused_before_packing({"-o", at("a.json"), "-o", at("./a.json")}, {"-o", "a.json"});
    expect_refused_before_packing({"-o", at("a.stl"), "-o", at("a-2.stl"), "--trays", "2"}, {"a.stl", "a-2.stl"});
    stl("a-1.stl", cube_mesh(10));
    const Ran ran = pack({at("a-1.stl:2"), "--tray", "11x11x11", "--trays", "all", "-o", at("a.stl")});
    EXPECT_EQ(ran.status, 2) << "a tray's file would take the part's place";
    ASSERT_EQ(pack({at("cube.stl")}).status, 0);
    EXPECT_EQ(pack({at("slab.stl"), "--onto", at("build.json"), "-o", at("cube.stl")}).status, 2)
        << "a mesh of the build that is topped up";
    EXPECT_EQ(spectralpack({"plan", at("build.json"), "-o", at("a.csv"), "-o", at("./a.csv")}).status, 2);
}

TEST_F(Faults, WhatCannotBeWrittenIsToldBeforePacking) {
    const std::vector<std::string> before = files();
    expect_refused_before_packing({"-o", at(std::string(252, 'n') + ".stl")}, {"too long"});
    expect_refused_before_packing({"--report", at(std::string(252, 'n') + ".csv")}, {"too long"});
    expect_refused_before_packing({"-o", at(std::string(250, 'n') + ".stl"), "--trays", "2"},
                                  {at(std::string(250, 'n') + "-2.stl"), "too long"});
    expect_refused_before_packing({"-o", at("cube.stl/a.stl")}, {"folder"});
    EXPECT_EQ(files(), before) << "files were left behind";
    const std::string longest = std::string(250, 'n') + ".json";  // 255 bytes
    EXPECT_EQ(pack({at("cube.stl"), "-o", at(longest)}).status, 0);
    EXPECT_TRUE(fs::exists(folder_ / longest));
}

TEST_F(Faults, NamesThatJsonCannotHoldAreToldBeforePacking) {
    const std::string name = "cube\xff.stl";
    stl(name, cube_mesh(10));
    for (const auto& more : std::vector<std::vector<std::string>>{{"-o", at("a.json")}, {"--json"}}) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack", at(name)} + more);
        EXPECT_EQ(ran.status, 2) << ran.err;
        EXPECT_TRUE(names(ran.err, {"UTF-8", "cube"}));
    }
    EXPECT_EQ(spectralpack({"pack", at(name), "-o", at("a.3mf")}).status, 0);
}

/// Marks a file so that nobody may change it; false where the tests may not.
bool mark(const std::string& path, bool immutable) {
    const int file = open(path.c_str(), O_RDONLY);
    int flags = 0;
    bool done = file >= 0 && ioctl(file, FS_IOC_GETFLAGS, &flags) == 0;
    flags = immutable ? flags | FS_IMMUTABLE_FL : flags & ~FS_IMMUTABLE_FL;
    done = done && ioctl(file, FS_IOC_SETFLAGS, &flags) == 0;
    if (file >= 0) close(file);
    return done;
}

TEST_F(Faults, FilesAndFoldersThatNobodyMayChangeAreToldBeforePacking) {
    write("kept.stl", "");
    fs::create_directory(folder_ / "kept");
    if (!mark(at("kept.stl"), true)) GTEST_SKIP() << "needs a file system and rights to mark files as immutable";
    mark(at("kept"), true);
    expect_refused_before_packing({"-o", at("kept.stl")}, {"kept.stl"});
    expect_refused_before_packing({"-o", at("kept/a.stl")}, {"read-only"});
    mark(at("kept.stl"), false);
    mark(at("kept"), false);
}

TEST_F(Faults, ScalesThatTransformsCannotHoldAreRefused) {
    EXPECT_EQ(pack({at("cube.stl:1@1e-300")}).status, 2);
    EXPECT_EQ(pack({at("cube.stl@1e300")}).status, 2);
    write("set.csv", "mesh,count,scale\ncube.stl,1,1e-8\n");
    const Ran ran = pack({at("set.csv@0.01")});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"line 2", "scale"}));
    ASSERT_EQ(pack({at("cube.stl@1e-9")}).status, 0);
    expect_sound();
}

TEST_F(Faults, MeshesThatChangeDuringTheRunAreNamed) {
    const auto change = [&](const std::function<void()>& action) {
        bool done = false;
        return spectralpack({"pack", at("cube.stl:200"), at("slab.stl:8"), "--progress", "json", "--threads", "1"},
                            [&](const std::string& err) {
                                if (!done && contains(err, "\"search\"")) {
                                    action();
                                    done = true;
                                }
                                return false;
                            });
    };
    const Ran changed = change([&] { stl("cube.stl", cube_mesh(11)); });
    EXPECT_EQ(changed.status, 0);
    EXPECT_TRUE(names(changed.err, {"changed", "cube.stl"}));
    EXPECT_FALSE(contains(changed.err, "slab.stl"));
    const Ran touched = change([&] { fs::last_write_time(folder_ / "cube.stl", fs::file_time_type::clock::now()); });
    EXPECT_FALSE(contains(touched.err, "changed")) << touched.err;
    const Ran gone = change([&] { fs::remove(folder_ / "slab.stl"); });
    EXPECT_TRUE(names(gone.err, {"gone", "slab.stl"}));
}

TEST_F(Faults, RowsThatSayTheSameAreOnePart) {
    std::string rows = "mesh,count,name\n";
    for (int i = 0; i < 3; ++i) {
        rows += "cube.stl,2,\n";
    }
    write("set.csv", rows + "cube.stl,1,other\nslab.stl,1,\ncube.stl,1,\n");
    ASSERT_EQ(pack({at("set.csv"), "--order", "input"}).status, 0);
    std::vector<int> counts;
    const json packing = build();
    for (const json& part : packing["parts"]) {
        counts.push_back(part["count"]);
    }
    EXPECT_EQ(counts, (std::vector<int>{6, 1, 1, 1})) << "those that follow one another";
    expect_sound();
}

}  // namespace
}  // namespace spectralpack::test
