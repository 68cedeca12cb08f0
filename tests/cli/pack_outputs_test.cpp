/// What pack writes, and what it must not write over.

#include <fstream>

#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A part would be lost, or the last build, lying among the parts, packed as one.
TEST(PackOutputs, AreNoFileThatIsRead) {
    const TemporaryFolder folder;
    for (const char* name : {"box.stl", "clip.stl", "nut.stl"}) {
        fs::copy_file(samples() / name, folder / name);
    }
    std::ofstream(folder / "set.csv") << "mesh,count,scale\nbox.stl,1,1\n";
    fs::create_symlink(folder / "box.stl", folder / "link.stl");
    const auto at = [&](const char* name) { return (folder / name).string(); };
    const std::vector<std::vector<std::string>> wrong{
        {at("box.stl"), "-o", at("box.stl")},
        {at("box.stl"), "-o", at("link.stl")},
        {at("box.stl") + ":2", "-o", at("./box.stl")},
        {folder.path().string(), "-o", at("nut.stl")},
        {at("set.csv"), "-o", at("box.stl")},
        {at("set.csv"), "-o", at("set.csv")},
        {at("set.csv"), "--report", at("set.csv")},
        {at("nut.stl"), "--container", at("clip.stl"), "-o", at("clip.stl")},
        {at("nut.stl"), "--keep-out", at("clip.stl"), "-o", at("clip.stl")},
    };
    for (const auto& options : wrong) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack"} + options);
        EXPECT_EQ(ran.status, 2) << ran.err;
        EXPECT_TRUE(names(ran.err, {options[options.size() - 2], options.back()}));
    }
    for (const char* name : {"box.stl", "clip.stl", "nut.stl"}) {
        EXPECT_EQ(read_text(folder / name), read_text(samples() / name));
    }
    // A build that is topped up may take the old one's place.
    for (const auto& more : {std::vector<std::string>{}, {"--onto", at("build.json")}}) {
        EXPECT_EQ(spectralpack(std::vector<std::string>{"pack", at("nut.stl"), "-o", at("build.json")} + more).status,
                  0);
    }
    EXPECT_EQ(read_json(folder / "build.json")["trays"][0]["placements"].size(), 2U);
    EXPECT_EQ(spectralpack({"plan", at("build.json"), "-o", at("nut.stl")}).status, 2);
    EXPECT_EQ(read_text(folder / "nut.stl"), read_text(samples() / "nut.stl"));
}

/// What stands behind an output is a part, not another output: it would be written over.
TEST(PackOutputs, EachOptionNamesOneFile) {
    const TemporaryFolder folder;
    fs::copy_file(samples() / "box.stl", folder / "box.stl");
    const std::string build = (folder / "b.json").string(), box = (folder / "box.stl").string();
    const Ran ran = spectralpack({"pack", (samples() / "nut.stl").string(), "-o", build, box});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(read_json(build)["metrics"]["placed"], 2);
    EXPECT_EQ(read_text(box), read_text(samples() / "box.stl"));
}

TEST(PackOutputs, ThatCannotBeWrittenAreNamedBeforeItPacks) {
    const TemporaryFolder folder;
    const std::string taken = (folder / "build.json").string();
    fs::create_directory(taken);
    const Ran ran = spectralpack({"pack", kSamples, "-o", taken});
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(names(ran.err, {"-o", taken, "folder"}));
    EXPECT_TRUE(ran.out.empty()) << ran.out;
}

TEST(PackOutputs, OfEveryKindAreWrittenAndCheckAgrees) {
    const TemporaryFolder folder;
    std::vector<std::string> call{"pack", kSamples, "--tray", "160x120x100", "--gap", "1"};
    const std::vector<std::string> kinds{"b.json", "b.3mf", "b.stl", "b.csv", "b.png"};
    for (const std::string& name : kinds) {
        call = call + std::vector<std::string>{"-o", (folder / name).string()};
    }
    const Ran ran = spectralpack(call);
    ASSERT_EQ(ran.status, 0) << ran.err;
    for (const std::string& name : kinds) {
        ASSERT_TRUE(fs::exists(folder / name)) << name;
        EXPECT_GT(fs::file_size(folder / name), 1000u) << name;
        EXPECT_TRUE(names(ran.out, {(folder / name).string()}));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 5)
        << "temporary files were left behind";
    const json packing = read_json(folder / "b.json");
    EXPECT_GT(packing["metrics"]["placed"], 20);
    EXPECT_EQ(packing["metrics"]["placed"].get<std::size_t>() + packing["unplaced"].size(),
              packing["metrics"]["copies"].get<std::size_t>());
    EXPECT_TRUE(packing["trays"][0]["disassembly"]["complete"].get<bool>());
    EXPECT_TRUE(check_report((folder / "b.json").string(), 0)["ok"]);
}

TEST(PackOutputs, OneThatFailsDoesNotKeepTheOthersFromBeingWritten) {
    const TemporaryFolder folder;
    const fs::path taken = folder / "a.json";
    const auto take_its_place = [&](const std::string& err) {
        if (err.find("\"search\"") != std::string::npos) fs::create_directories(taken / "full");
        return false;
    };
    const std::vector<std::string> outputs{"-o", taken.string(), "-o", (folder / "b.csv").string()};
    const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--progress", "json"} + outputs + kSmall,
                                 take_its_place);
    EXPECT_EQ(ran.status, 4) << ran.err;
    EXPECT_TRUE(names(ran.err, {taken.string()}));
    EXPECT_TRUE(fs::exists(folder / "b.csv"));
}

TEST(PackOutputs, JsonOnStandardOutputIsThePacking) {
    const Ran ran = spectralpack(std::vector<std::string>{"pack", kSamples, "--json"} + kSmall);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(json::parse(ran.out)["format"], "spectralpack/packing");
}

}  // namespace
}  // namespace spectralpack::test
