#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

TEST(Usage, HelpAndVersionExitWithZero) {
    const Ran help = spectralpack({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_TRUE(names(help.out, {"pack", "check", "plan", "render", "inspect"}));
    const Ran of_pack = spectralpack({"pack", "--help"});
    EXPECT_EQ(of_pack.status, 0);
    EXPECT_TRUE(names(of_pack.out, {"PART", "--tray", "--voxel", "--gap", "--output"}));
    const Ran version = spectralpack({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_TRUE(names(version.out, {"spectralpack", "0."}));
}

struct BadCall {
    std::vector<std::string> arguments;
    std::vector<Fact> named;  ///< by the message
};

void PrintTo(const BadCall& call, std::ostream* out) {
    for (const std::string& argument : call.arguments) {
        *out << std::filesystem::path(argument).filename().string() << ' ';
    }
}

class Refuses : public testing::TestWithParam<BadCall> {};

TEST_P(Refuses, WithStatusTwoAndNamesWhatIsWrong) {
    const Ran ran = spectralpack(GetParam().arguments);
    EXPECT_EQ(ran.status, 2) << ran.err;
    EXPECT_TRUE(names(ran.err, GetParam().named));
    EXPECT_TRUE(ran.out.empty()) << ran.out;
}

INSTANTIATE_TEST_SUITE_P(
    Calls, Refuses,
    testing::Values(
        BadCall{{}, {"--help"}}, BadCall{{"pakc"}, {"pakc"}}, BadCall{{"prepare", "x"}, {"--output"}},
        BadCall{{"bench"}, {"--table"}}, BadCall{{"pack"}, {"PART"}}, BadCall{{"pack", "-rf.stl"}, {"-rf.stl"}},
        BadCall{{"pack", kSamples, "--tray", "480x245"}, {"--tray"}},
        BadCall{{"pack", kSamples, "--tray", "0x1x1"}, {"--tray"}},
        BadCall{{"pack", kSamples, "--tray", "nanx1x1"}, {"--tray"}},
        BadCall{{"pack", kSamples, "--tray", "1x1x1", "--voxel", "2"}, {"voxel", 2}},
        BadCall{{"pack", kSamples, "--voxel", "-1"}, {"--voxel"}},
        BadCall{{"pack", kSamples, "--voxel", "nan"}, {"--voxel"}},
        BadCall{{"pack", kSamples, "--gap", "-0.5"}, {"--gap"}}, BadCall{{"pack", kSamples, "--gap", "nan"}, {"--gap"}},
        BadCall{{"pack", kSamples, "--detail", "0"}, {"--detail"}},
        BadCall{{"pack", kSamples, "--detail", "9"}, {"--detail"}},
        BadCall{{"pack", kSamples, "--wall-gap", "200"}, {"--wall-gap", 200, 245}},
        BadCall{{"pack", kSamples, "--rotations", "17"}, {360}},
        BadCall{{"pack", kSamples, "--rotations", "lots"}, {"--rotations", "lots"}},
        BadCall{{"pack", kSamples, "--order", "best"}, {"--order", "best"}},
        BadCall{{"pack", kSamples, "--height-penalty", "4x"}, {"--height-penalty", "4x"}},
        BadCall{{"pack", kSamples, "--memory", "lots"}, {"--memory", "lots"}},
        BadCall{{"pack", kSamples, "--verify-with", "reference:0"}, {"--verify-with"}},
        BadCall{{"pack", kSamples, "--engine", "cuda"}, {"cuda"}},
        BadCall{{"pack", kSamples, "--interlock", "never"}, {"--interlock", "never"}},
        BadCall{{"pack", kSamples, "--ray-spacing", "0"}, {"--ray-spacing"}},
        BadCall{{"pack", kSamples, "--ray-spacing", "0.01"}, {"--ray-spacing", 0.01, 0.05}},
        BadCall{{"pack", kSamples, "--links", "never"}, {"--links", "never"}},
        BadCall{{"pack", kSamples, "--trays", "few"}, {"--trays", "few"}},
        BadCall{{"pack", kSamples, "--printer", "typewriter"}, {"typewriter", "--printer list"}},
        BadCall{{"pack", kSamples, "--keep-out", "5,0,0,1,1,1"}, {"--keep-out", "5,0,0,1,1,1"}},
        BadCall{{"pack", kSamples + ":0"}, {kSamples + ":0"}}, BadCall{{"pack", kSamples + ":2@-1"}, {":2@-1"}},
        BadCall{{"pack", kSamples, "-o", "build.xyz"}, {"build.xyz", ".json", ".3mf"}},
        BadCall{{"pack", kSamples, "-o", "no/such/folder/build.json"}, {"no/such/folder"}},
        BadCall{{"render", "x.json"}, {"--output"}}, BadCall{{"render", "x.json", "-o", "x.stl"}, {"x.stl", ".png"}},
        BadCall{{"render", "x.json", "-o", "no/such/folder/x.png"}, {"no/such/folder"}},
        BadCall{{"plan", "x.json", "-o", "no/such/folder/x.json"}, {"no/such/folder"}},
        BadCall{{"render", "x.json", "-o", "x.png", "--size", "5"}, {"--size"}}));

}  // namespace
}  // namespace spectralpack::test
