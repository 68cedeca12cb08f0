#include <algorithm>
#include <set>

#include "cli/program.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack::test {
namespace {

using Words = std::vector<std::string>;

/// The input hash of a packing of two sample boxes.
std::string hash_with(const Words& options) {
    const TemporaryFolder folder;
    const std::string file = (folder / "p.json").string();
    const Words job{"pack", (samples() / "box.stl").string() + ":2", "-o", file};
    const Ran ran = spectralpack(job + options);
    EXPECT_EQ(ran.status, 0) << ran.err;
    return ran.status == 0 ? read_json(file)["input_hash"].get<std::string>() : "";
}

const Words kCoarse{"--tray", "90x80x70", "--voxel", "8"};

TEST(InputHash, IsThatOfEarlierVersions) {
    EXPECT_EQ(hash_with(kCoarse), "d02836c95594fcd9eadca59add48c71f");
    const Words many{"--order",
                     "random",
                     "--seed",
                     "7",
                     "--trays",
                     "2",
                     "--gap",
                     "1",
                     "--try-per-tray",
                     "5",
                     "--height-at",
                     "bottom",
                     "--links",
                     "allow",
                     "--rotations",
                     "45+box",
                     "--wall-gap",
                     "0.5",
                     "--detail",
                     "1",
                     "--max-density",
                     "0.9",
                     "--ray-spacing",
                     "2",
                     "--no-refine",
                     "--interlock",
                     "off",
                     "--take-out",
                     "lightest",
                     "--restarts",
                     "2",
                     "--height-penalty",
                     "4",
                     "--max-layer-fill",
                     "0.8"};
    EXPECT_EQ(hash_with(kCoarse + many), "45679795795cfd5d444be27d654fdfac");
}

/// Those with a place in the hash change it, the others do not. The gap and upright count as the parts', a printer sets
/// others, and the seed and the tries per tray count where they are used.
TEST(InputHash, CoversWhatPlacementsDependOn) {
    const std::set<std::string_view> count_elsewhere{"gap", "printer", "upright"}, unused_here{"seed", "try-per-tray"};
    const std::string plain = hash_with(kCoarse);
    for (const Option& option : option_table()) {
        if (!option.in_pack.get || option.type == OptionType::verify) continue;
        std::string value;  // unlike the default
        for (const std::string_view word : option.type == OptionType::word ? option.words : decltype(option.words)()) {
            if (parse_value(option, word) != default_of(option) && word != "cuda" && word != "reference") value = word;
        }
        if (value.empty() && !option.examples.empty()) value = option.examples.back();
        if (option.name == "height-at") value = "top";
        Words options = kCoarse;
        if (option.name == "tray" || option.name == "printer") options = {"--voxel", "8"};
        if (option.name == "tray") value = "90x80x60";
        if (option.name == "voxel") options = {"--tray", "90x80x70"};
        if (option.name == "voxel") value = "9";
        const std::string name = "--" + std::string(option.name);
        if (option.type != OptionType::flag) options = options + Words{name, value};
        if (option.type == OptionType::flag)
            options.push_back(option.off_line.empty() ? name : "--no-" + name.substr(2));
        const bool counts =
            (option.hash_place > 0 || count_elsewhere.contains(option.name)) && !unused_here.contains(option.name);
        EXPECT_EQ(hash_with(options) != plain, counts) << name << " " << value;
    }
    const Words random{"--order", "random"}, trays{"--trays", "2"};
    EXPECT_NE(hash_with(kCoarse + random + Words{"--seed", "7"}), hash_with(kCoarse + random));
    EXPECT_NE(hash_with(kCoarse + trays + Words{"--try-per-tray", "7"}), hash_with(kCoarse + trays));
}

TEST(Help, ExplainsAnOption) {
    for (const char* topic : {"wall-gap", "--wall-gap"}) {
        const Ran ran = spectralpack({"help", topic});
        EXPECT_EQ(ran.status, 0) << ran.err;
        const Option& option = *find_option("wall-gap");
        std::string told = ran.out;
        std::ranges::replace(told, '\n', ' ');  // it is wrapped
        EXPECT_TRUE(names(told, {"--wall-gap", "MM", std::string(option.line), std::string(option.help), 1.5}));
    }
    EXPECT_TRUE(names(spectralpack({"help", "no-refine"}).out, {"--no-refine"}));
    for (const Option& option : option_table()) {
        EXPECT_EQ(spectralpack({"help", std::string(option.name)}).status, 0) << option.name;
    }
}

TEST(Help, ExplainsACommandAndWhatThereIs) {
    EXPECT_EQ(spectralpack({"help", "check"}).out, spectralpack({"check", "--help"}).out);
    EXPECT_EQ(spectralpack({"help"}).out, spectralpack({"--help"}).out);
    EXPECT_EQ(spectralpack({"help", "-o"}).out, spectralpack({"help", "output"}).out);
    EXPECT_EQ(spectralpack({"help", "-y"}).status, 2);
    const Ran near = spectralpack({"help", "gp"});
    EXPECT_EQ(near.status, 2);
    EXPECT_TRUE(names(near.err, {"'gp'", "did you mean 'gap'?"}));
    EXPECT_TRUE(names(spectralpack({"help", "keep-out"}).out, {"takes     a box", "mesh file"}));
    const Ran nothing = spectralpack({"help", "gravity"});
    EXPECT_EQ(nothing.status, 2);
    EXPECT_TRUE(names(nothing.err, {"gravity"}));
}

TEST(Help, OfAllNamesEveryOptionWithItsDefault) {
    const std::string help = spectralpack({"pack", "--help-all"}).out;
    for (const Option& option : option_table()) {
        EXPECT_TRUE(names(help, {"--" + std::string(option.name)}));
    }
    EXPECT_TRUE(names(help, {"480x245x200", "--no-refine"}));
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream rest(text);
    for (std::string line; std::getline(rest, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// The options that people use, in the order of a job, each on a line of 80 columns.
TEST(Help, FitsAScreenAndFollowsAJob) {
    const Ran ran = spectralpack({"pack", "--help"});
    const std::vector<std::string> help = lines_of(ran.out);
    EXPECT_LE(help.size(), 40u);
    std::vector<std::string> headings;
    std::size_t options = 0, wanted = 0;
    for (const std::string& line : help) {
        EXPECT_LE(line.size(), 80u) << line;
        const std::size_t dashes = line.find("-");
        if (dashes != 9) continue;
        ++options;
        if (line[0] != ' ') headings.push_back(line.substr(0, line.find(' ')));
    }
    EXPECT_EQ(headings, (std::vector<std::string>{"Parts", "Tray", "Gap", "Packing", "Result"}));
    std::set<int> places;
    for (const Option& option : option_table()) {
        if (option.help_place == 0) {
            EXPECT_FALSE(contains(ran.out, "--" + std::string(option.name) + " ")) << option.name;
            continue;
        }
        ++wanted;
        EXPECT_TRUE(places.insert(option.help_place).second) << option.name << " has the place of another";
        EXPECT_TRUE(contains(ran.out, "--" + std::string(option.name))) << option.name;
    }
    EXPECT_EQ(options, wanted);
    EXPECT_LE(wanted, 20u);
    // `pack` alone prints its beginning.
    const Ran alone = spectralpack({"pack"});
    EXPECT_EQ(alone.status, 2);
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(lines_of(alone.err).at(i), help.at(i));
    }
    for (const std::string& line : lines_of(spectralpack({"pack", "--help-all"}).out)) {
        EXPECT_LE(line.size(), 80u) << line;
    }
}

}  // namespace
}  // namespace spectralpack::test
