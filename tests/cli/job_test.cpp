#include <fstream>

#include "cli/program.hpp"
#include "formats/packing_file.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A folder with a cube of 10 mm, a box of 20 x 10 x 10 mm and a job that packs them.
class JobFile : public testing::Test {
  protected:
    JobFile() {
        fs::create_directory(folder_ / "parts");
        stl("cube.stl", cube_mesh(10));
        stl("box.stl", box_mesh({0, 0, 0}, {20, 10, 10}));
    }

    void stl(const std::string& name, const Mesh& mesh) { write_stl(mesh, folder_ / "parts" / name); }

    Ran pack(const std::vector<std::string>& more = {}) {
        std::ofstream(file()) << job_;
        return spectralpack(std::vector<std::string>{"pack", file()} + more);
    }

    std::string file() const { return (folder_ / "job.json").string(); }
    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    TemporaryFolder folder_;
    json job_ = {{"format", "spectralpack/job"},
                 {"version", 1},
                 {"container", {{"size", {80, 60, 40}}}},
                 {"gap", 1},
                 {"parts",
                  {{{"name", "die"}, {"mesh", "parts/cube.stl"}, {"count", 3}},
                   {{"mesh", "parts/box.stl"}, {"count", 2}, {"scale", 1.5}, {"gap", 7}}}},
                 {"options", {{"voxel", 1}, {"output", "build.json"}, {"threads", 1}}}};
};

TEST_F(JobFile, SaysEverythingThatARunNeeds) {
    const Ran ran = pack();
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json packing = read_json(folder_ / "build.json");
    EXPECT_EQ(packing["container"]["size"], json({80, 60, 40}));
    EXPECT_EQ(packing["options"]["voxel"], 1);
    EXPECT_EQ(packing["options"]["gap"], 1);
    EXPECT_EQ(packing["options"]["threads"], 1);
    EXPECT_EQ(packing["parts"][0]["name"], "die");
    EXPECT_EQ(packing["parts"][0]["mesh"], "parts/cube.stl");
    EXPECT_EQ(packing["parts"][0]["count"], 3);
    EXPECT_EQ(packing["parts"][0]["gap"], 1);
    EXPECT_EQ(packing["parts"][1]["name"], "box");
    EXPECT_EQ(packing["parts"][1]["scale"], 1.5);
    EXPECT_EQ(packing["parts"][1]["gap"], 7);
    EXPECT_EQ(packing["metrics"]["placed"], 5);
}

TEST_F(JobFile, TheCommandLineOverridesOnlyWhatItNames) {
    const Ran ran = pack({"--gap", "2", "--tray", "90x70x50", "-o", at("other.json"), "--unit", "mm"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_FALSE(fs::exists(folder_ / "build.json"));
    const json packing = read_json(folder_ / "other.json");
    EXPECT_EQ(packing["container"]["size"], json({90, 70, 50}));
    EXPECT_EQ(packing["options"]["gap"], 2);
    EXPECT_EQ(packing["options"]["voxel"], 1);
    EXPECT_EQ(packing["parts"][0]["gap"], 2);
    EXPECT_EQ(packing["parts"][1]["gap"], 7) << "a part's own gap is not the job's";
}

TEST_F(JobFile, OptionsGivenAsTheirDefaultsOverrideToo) {
    job_["options"]["rotations"] = "none";
    job_["options"]["height-penalty"] = 4;
    ASSERT_EQ(pack({"--voxel", "2", "--rotations", "90", "--height-penalty", "auto"}).status, 0);
    const json options = read_json(folder_ / "build.json")["options"];
    EXPECT_EQ(options["voxel"], 2);
    EXPECT_EQ(options["rotations"], "90");
    EXPECT_EQ(options["height-penalty"], 1e8) << "small parts in a large tray: appendix A.2";
}

TEST_F(JobFile, CheckConfirmsThePartsOwnGap) {
    ASSERT_EQ(pack().status, 0);
    EXPECT_EQ(spectralpack({"check", at("build.json")}).status, 0);
    // The same placements judged by a wider gap of that part: something must be nearer than 30 mm.
    json packing = read_json(folder_ / "build.json");
    packing["parts"][1]["gap"] = 30;
    std::ofstream(folder_ / "build.json") << packing;
    const json report = check_report(at("build.json"), 1);
    EXPECT_FALSE(report["findings"].empty());
    for (const json& finding : report["findings"]) {
        EXPECT_EQ(finding["kind"], "gap");
        bool wide = false;
        for (const json& index : finding["placements"]) {
            wide = wide || packing["trays"][0]["placements"][index.get<std::size_t>()]["part"] == 1;
        }
        EXPECT_TRUE(wide) << finding;
    }
}

TEST_F(JobFile, UnknownKeysAndWrongTypesAreNamedAndNothingIsPacked) {
    job_["parts"][1]["colour"] = "red";
    const Ran unknown = pack({at("parts/cube.stl")});
    EXPECT_EQ(unknown.status, 3);
    EXPECT_TRUE(names(unknown.err, {"job.json", "parts[1].colour"}));
    job_["parts"][1].erase("colour");
    job_["options"]["voxel"] = "fine";
    const Ran wrong = pack();
    EXPECT_EQ(wrong.status, 3);
    EXPECT_TRUE(names(wrong.err, {"job.json", "options.voxel", "number"}));
    EXPECT_FALSE(fs::exists(folder_ / "build.json"));
}

TEST_F(JobFile, FilesThatItNamesAreCheckedBeforeWork) {
    job_["options"]["report"] = "no/such/folder/r.html";
    EXPECT_EQ(pack().status, 2);
    job_["options"]["report"] = "r.txt";
    EXPECT_EQ(pack().status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "build.json"));
}

TEST_F(JobFile, AMissingMeshIsUnusableAndTheRestIsPacked) {
    job_["parts"].push_back({{"mesh", "parts/missing.stl"}, {"name", "ghost"}});
    const Ran ran = pack();
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"missing.stl"}));
    const json packing = read_json(folder_ / "build.json");
    EXPECT_EQ(packing["metrics"]["placed"], 5);
    EXPECT_EQ(packing["parts"][2]["name"], "ghost");
    EXPECT_EQ(packing["unplaced"][0]["reason"], "bad_file");
    job_["options"]["skip-unusable"] = true;
    EXPECT_EQ(pack().status, 0);
}

TEST_F(JobFile, MeshesMayBeNamedBesideIt) {
    ASSERT_EQ(pack({at("parts/cube.stl") + ":4"}).status, 0);
    EXPECT_EQ(read_json(folder_ / "build.json")["metrics"]["placed"], 9);
    EXPECT_EQ(pack({file()}).status, 2) << "two jobs in one run";
}

}  // namespace
}  // namespace spectralpack::test
