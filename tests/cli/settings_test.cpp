/// Defaults from the user's and the project's files.

#include "cli/whole_job.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class Settings : public WholeJob {
  protected:
    Settings() {
        fs::create_directories(folder_ / "config" / "spectralpack");
        fs::create_directory(folder_ / "project");
        say("config/spectralpack/config.json",
            {{"options", {{"gap", 1}, {"voxel", 3}, {"seed", 5}}}, {"profiles", {{"pa12", {{"gap", 2}}}}}});
        say("project/spectralpack.json", {{"options", {{"voxel", 4}, {"output", "build.json"}}}});
    }

    void say(const std::string& file, const json& document) const { std::ofstream(at(file)) << document; }

    /// In the project's folder, with the user's settings.
    Ran pack_there(const std::vector<std::string>& options) const {
        return run(std::vector<std::string>{"/usr/bin/env", "-C", at("project"), "XDG_CONFIG_HOME=" + at("config"),
                                            SPECTRALPACK_PROGRAM, "pack", at("cube.stl"), "--tray", "40x40x40"} +
                   options);
    }

    json built() const { return read_json(folder_ / "project" / "build.json"); }
};

TEST_F(Settings, CountWhereNobodySaysOtherwiseAndTheRecordNamesThem) {
    const Ran ran = pack_there({"--seed", "6"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.err, {"gap", "config.json", "voxel", "spectralpack.json"}));
    const json packing = built();
    EXPECT_EQ(packing["options"]["gap"], 1);
    EXPECT_EQ(packing["options"]["voxel"], 4);
    EXPECT_EQ(packing["options"]["seed"], 6);
    EXPECT_EQ(packing["defaults"],
              (json{{{"file", at("config/spectralpack/config.json")}, {"profile", nullptr}, {"options", {"gap"}}},
                    {{"file", "spectralpack.json"}, {"profile", nullptr}, {"options", {"output", "voxel"}}}}));
}

TEST_F(Settings, AProfileComesBeforeThemAndTheCommandLineBeforeIt) {
    ASSERT_EQ(pack_there({"--profile", "pa12"}).status, 0);
    EXPECT_EQ(built()["options"]["gap"], 2);
    EXPECT_EQ(built()["defaults"].back()["profile"], "pa12");
    ASSERT_EQ(pack_there({"--profile", "pa12", "--gap", "0.5"}).status, 0);
    EXPECT_EQ(built()["options"]["gap"], 0.5);
    const Ran none = pack_there({"--profile", "pa11"});
    EXPECT_EQ(none.status, 2);
    EXPECT_TRUE(names(none.err, {"pa11", "pa12"}));
}

TEST_F(Settings, AJobFileComesBeforeThem) {
    say("job.json", {{"format", "spectralpack/job"},
                     {"version", 1},
                     {"gap", 3},
                     {"parts", json::array({{{"mesh", "cube.stl"}}})},
                     {"options", {{"voxel", 5}}}});
    ASSERT_EQ(pack_there({at("job.json"), "--profile", "pa12"}).status, 0);
    EXPECT_EQ(built()["options"]["gap"], 3);
    EXPECT_EQ(built()["options"]["voxel"], 5);
    EXPECT_EQ(built()["options"]["seed"], 5);
}

TEST_F(Settings, OthersAreUsedInsteadOrNone) {
    say("other.json", {{"options", {{"gap", 4}}}});
    const std::string out = at("project/build.json");
    const Ran other = pack_there({"--config", at("other.json"), "-o", out});
    ASSERT_EQ(other.status, 0) << other.err;
    EXPECT_EQ(built()["options"]["gap"], 4);
    EXPECT_EQ(built()["options"]["voxel"], 2);
    const Ran none = pack_there({"--no-config", "-o", out});
    ASSERT_EQ(none.status, 0);
    EXPECT_EQ(none.err, "");
    EXPECT_EQ(built()["options"]["gap"], 0.2);
    EXPECT_EQ(built()["defaults"], json::array());
    EXPECT_EQ(pack_there({"--config", at("absent.json")}).status, 2);
    EXPECT_EQ(pack_there({"--config", at("other.json"), "--no-config"}).status, 2);
}

TEST_F(Settings, OwnPrintersAreListedAndUsed) {
    say("project/printers.json", {{"printers", {{{"name", "shop-1"}, {"size", {60, 50, 40}}, {"gap", 1.5}}}}});
    const Ran list = pack_there({"--printer", "list"});
    EXPECT_EQ(list.status, 0) << list.err;
    EXPECT_TRUE(names(list.out, {"shop-1", "hp-mjf-5200"}));
    const json printers = json::parse(pack_there({"--printer", "list", "--json"}).out);
    EXPECT_EQ(printers["printers"][0]["name"], "shop-1");
    ASSERT_EQ(pack_there({"--printer", "shop-1"}).status, 0);
    EXPECT_TRUE(names(pack_there({"--printer", "fuse1"}).err, {"did you mean formlabs-fuse1?"}))
        << "what a name holds is enough";
    EXPECT_EQ(built()["options"]["gap"], 1.5);
    EXPECT_EQ(built()["defaults"][0]["options"], json::array({"seed"}))
        << "the printer's gap took the place of the user's";
}

TEST_F(Settings, AnUnknownKeyIsAnErrorThatNamesFileAndPath) {
    say("project/spectralpack.json", {{"options", {{"gaps", 1}}}});
    const Ran ran = pack_there({});
    EXPECT_EQ(ran.status, 3);
    EXPECT_TRUE(names(ran.err, {"spectralpack.json", "options.gaps", "gap"}));
}

}  // namespace
}  // namespace spectralpack::test
