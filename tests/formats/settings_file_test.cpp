#include "formats/settings_file.hpp"

#include "files.hpp"
#include "formats/job_file.hpp"
#include "formats/json_node.hpp"

namespace spectralpack::test {
namespace {

namespace fs = std::filesystem;

class SettingsFiles : public testing::Test {
  protected:
    SettingsFiles() {
        fs::create_directory(folder_ / "home");
        fs::create_directory(folder_ / "project");
    }

    fs::path write(const std::string& name, const std::string& text) const { return write_bytes(folder_ / name, text); }

    JobSettings read(const std::vector<fs::path>& files, const std::string& profile = "") const {
        JobSettings settings;
        read_settings(files, profile, settings);
        return settings;
    }

    InputError refusal_of(const std::string& text) const {
        const fs::path file = write("wrong.json", text);
        return refusal([&] { read({file}); });
    }

    TemporaryFolder folder_;
};

TEST_F(SettingsFiles, TheProjectComesBeforeTheUserAndProfilesBeforeBoth) {
    const fs::path user = write("home/config.json", R"({"options": {"gap": 1, "voxel": 3, "threads": 2},
        "profiles": {"pa12": {"gap": 4, "seed": 7}}})");
    const fs::path project = write("project/spectralpack.json", R"({"format": "spectralpack/settings", "version": 1,
        "options": {"gap": 2, "output": "build.3mf"}, "profiles": {"pa12": {"seed": 8}, "steel": {"gap": 9}}})");
    const JobSettings plain = read({user, project});
    EXPECT_EQ(plain.options.gap, 2);
    EXPECT_EQ(plain.options.voxel, 3);
    EXPECT_EQ(plain.outputs, (std::vector{(folder_ / "project" / "build.3mf").string()}));
    EXPECT_EQ(plain.defaults, (std::vector<SettingsSource>{{user.string(), "", {"voxel", "threads"}},
                                                           {project.string(), "", {"output", "gap"}}}));
    const JobSettings pa12 = read({user, project}, "pa12");
    EXPECT_EQ(pa12.options.gap, 4);
    EXPECT_EQ(pa12.options.seed, 8u);
    EXPECT_EQ(pa12.defaults, (std::vector<SettingsSource>{{user.string(), "", {"voxel", "threads"}},
                                                          {project.string(), "", {"output"}},
                                                          {user.string(), "pa12", {"gap"}},
                                                          {project.string(), "pa12", {"seed"}}}));
}

TEST_F(SettingsFiles, AJobSaysWhatItSaysOverThem) {
    const fs::path project = write("project/spectralpack.json", R"({"options": {"gap": 2, "voxel": 3}})");
    const JobFile job =
        parse_job("job.json", R"({"format": "spectralpack/job", "version": 1, "gap": 5, "parts": [{"mesh": "a.stl"}]})",
                  read({project}));
    EXPECT_EQ(job.settings.options.gap, 5);
    EXPECT_EQ(job.settings.options.voxel, 3);
    EXPECT_EQ(job.settings.defaults, (std::vector<SettingsSource>{{project.string(), "", {"voxel"}}}));
}

TEST_F(SettingsFiles, OwnPrintersStandBesideThem) {
    const fs::path project = write("project/spectralpack.json", R"({"options": {"printer": "Shop-1", "gap": 3}})");
    write("project/printers.json",
          R"({"printers": [{"name": "shop-1", "size": [300, 200, 100], "gap": 1.5, "wall": 4}]})");
    const JobSettings settings = read({project});
    ASSERT_EQ(settings.own_printers.size(), 1u);
    EXPECT_EQ(settings.options.tray, (Vec3{300, 200, 100}));
    EXPECT_EQ(settings.options.gap, 3);
    EXPECT_EQ(settings.options.wall_gap, 4);
    EXPECT_EQ(settings.options.printer, "shop-1");
    EXPECT_EQ(find_printer("SHOP-1", settings.own_printers), settings.own_printers.data());
    EXPECT_EQ(find_printer("shop-1"), nullptr);
}

TEST_F(SettingsFiles, PrintersAreReadAsTheyAreWritten) {
    const fs::path file = write("printers.json", printers_to_json(printers()));
    const std::vector<Printer> read = read_printers(file);
    ASSERT_EQ(read.size(), printers().size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].name, printers()[i].name);
        EXPECT_EQ(read[i].size, printers()[i].size);
        EXPECT_EQ(read[i].wall_gap(), printers()[i].wall_gap());
        EXPECT_EQ(read[i].source, printers()[i].source);
    }
}

TEST_F(SettingsFiles, WhatIsWrongIsNamedWithItsPath) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"option": {}})", "option"},
        {R"({"options": {"gaps": 1}})", "options.gaps"},
        {R"({"options": {"gap": "wide"}})", "options.gap"},
        {R"({"options": {"printer": "typewriter"}})", "options.printer"},
        {R"({"profiles": {"a": {"gap": 1}, "b": {"voxel": 0}}})", "profiles.b.voxel"},
        {R"({"profiles": []})", "profiles"},
        {R"({"format": "spectralpack/packing"})", "format"},
        {R"({"version": 2})", "version"}};
    for (const auto& [text, place] : cases) {
        const InputError error = refusal_of(text);
        EXPECT_EQ(error.place(), place) << text;
        EXPECT_EQ(error.file(), (folder_ / "wrong.json").string());
    }
    EXPECT_TRUE(names(refusal_of(R"({"options": {"gaps": 1}})").cause(), {"gap"})) << "what was probably meant";
    const char* const printers[] = {
        R"({"printers": [{"name": "a"}]})",
        R"({"printers": [{"size": [1, 2, 3]}]})",
        R"({"printers": [{"name": "a", "size": [1, 2]}]})",
        R"({"printers": [{"name": "a", "size": [1, 2, 3], "walls": 1}]})",
        R"({"printers": [{"name": "list", "size": [1, 2, 3]}]})",
        R"({"printers": [{"name": "a", "size": [1, 2, 3]}, {"name": "a", "size": [1, 2, 3]}]})"};
    for (const char* text : printers) {
        const fs::path file = write("printers.json", text);
        EXPECT_TRUE(names(refusal([&] { read_printers(file); }).place(), {"printers["})) << text;
    }
}

TEST_F(SettingsFiles, AProfileThatIsNotThereIsNamedWithThoseThatAre) {
    const fs::path file = write("config.json", R"({"profiles": {"pa12": {}, "tpu": {}}})");
    for (const auto& [files, facts] : {std::pair(std::vector{file}, std::vector<Fact>{"pa11", "pa12", "tpu"}),
                                       std::pair(std::vector<fs::path>{}, std::vector<Fact>{"pa11", "--config"})}) {
        try {
            read(files, "pa11");
            ADD_FAILURE() << "was taken";
        } catch (const UsageError& error) {
            EXPECT_TRUE(names(error.what(), facts));
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
