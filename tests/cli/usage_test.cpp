#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

TEST(Usage, HelpAndVersionExitWithZero) {
    EXPECT_EQ(spectralpack({"--help"}).status, 0);
    EXPECT_EQ(spectralpack({"pack", "--help"}).status, 0);
    const Ran version = spectralpack({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_TRUE(contains(version.out, "spectralpack 0.")) << version.out;
}

struct BadCall {
    std::vector<std::string> arguments;
    std::string said;  ///< what the message must name
};

void PrintTo(const BadCall& call, std::ostream* out) {
    for (const std::string& argument : call.arguments) {
        *out << std::filesystem::path(argument).filename().string() << ' ';
    }
}

class Refuses : public testing::TestWithParam<BadCall> {};

TEST_P(Refuses, WithStatusTwoAndTheReason) {
    const Ran ran = spectralpack(GetParam().arguments);
    EXPECT_EQ(ran.status, 2) << ran.err;
    EXPECT_TRUE(contains(ran.err, GetParam().said)) << ran.err;
    EXPECT_TRUE(ran.out.empty()) << ran.out;
}

const std::string kPart = (samples() / "samples.csv").string();

INSTANTIATE_TEST_SUITE_P(
    Calls, Refuses,
    testing::Values(
        BadCall{{}, "subcommand"}, BadCall{{"pakc"}, "pakc"}, BadCall{{"prepare", "x"}, "--output"},
        BadCall{{"bench"}, "--table"}, BadCall{{"pack"}, "PART"}, BadCall{{"pack", "-rf.stl"}, "-rf.stl"},
        BadCall{{"pack", kPart, "--tray", "480x245"}, "--tray"}, BadCall{{"pack", kPart, "--tray", "0x1x1"}, "--tray"},
        BadCall{{"pack", kPart, "--tray", "nanx1x1"}, "--tray"},
        BadCall{{"pack", kPart, "--tray", "1x1x1", "--voxel", "2"}, "smaller than one voxel"},
        BadCall{{"pack", kPart, "--voxel", "-1"}, "--voxel"}, BadCall{{"pack", kPart, "--voxel", "nan"}, "--voxel"},
        BadCall{{"pack", kPart, "--gap", "-0.5"}, "--gap"}, BadCall{{"pack", kPart, "--gap", "nan"}, "--gap"},
        BadCall{{"pack", kPart, "--detail", "0"}, "--detail"}, BadCall{{"pack", kPart, "--detail", "9"}, "--detail"},
        BadCall{{"pack", kPart, "--wall-gap", "200"}, "--wall-gap"},
        BadCall{{"pack", kPart, "--rotations", "17"}, "divides 360"},
        BadCall{{"pack", kPart, "--rotations", "lots"}, "--rotations"},
        BadCall{{"pack", kPart, "--order", "best"}, "--order"},
        BadCall{{"pack", kPart, "--height-penalty", "4x"}, "--height-penalty"},
        BadCall{{"pack", kPart, "--memory", "lots"}, "--memory"},
        BadCall{{"pack", kPart, "--verify-with", "reference:0"}, "--verify-with"},
        BadCall{{"pack", kPart, "--engine", "cuda"}, "cuda"},
        BadCall{{"pack", kPart, "--interlock", "never"}, "--interlock"},
        BadCall{{"pack", kPart, "--ray-spacing", "0"}, "--ray-spacing"},
        BadCall{{"pack", kPart, "--ray-spacing", "0.01"}, "too fine"},
        BadCall{{"pack", kPart, "--links", "never"}, "--links"}, BadCall{{"pack", kPart, "--trays", "few"}, "--trays"},
        BadCall{{"pack", kPart, "--printer", "typewriter"}, "--printer list"},
        BadCall{{"pack", kPart, "--keep-out", "5,0,0,1,1,1"}, "--keep-out"}, BadCall{{"pack", kPart + ":0"}, "count"},
        BadCall{{"pack", kPart + ":2@-1"}, "scale"}, BadCall{{"pack", kPart, "-o", "build.xyz"}, "ending"},
        BadCall{{"pack", kPart, "-o", "no/such/folder/build.json"}, "no folder"},
        BadCall{{"render", "x.json"}, "output"}, BadCall{{"render", "x.json", "-o", "x.stl"}, ".png"},
        BadCall{{"render", "x.json", "-o", "no/such/folder/x.png"}, "no folder"},
        BadCall{{"plan", "x.json", "-o", "no/such/folder/x.json"}, "no folder"},
        BadCall{{"render", "x.json", "-o", "x.png", "--size", "5"}, "--size"}));

}  // namespace
}  // namespace spectralpack::test
