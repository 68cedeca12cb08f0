#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "spectralpack/option_table.hpp"
#include "support/data.hpp"
#include "support/process.hpp"

namespace spectralpack::test {
namespace {

namespace fs = std::filesystem;

std::string written(const std::string& kind) {
    const Ran ran = run({SPECTRALPACK_DOCS, kind});
    EXPECT_EQ(ran.status, 0) << ran.err;
    return ran.out;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool is_there(const std::string& program) {
    return run({"/bin/sh", "-c", "command -v " + program + " >/dev/null"}).status == 0;
}

fs::path file_with(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
}

class Kept : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Kept, IsWhatTheTableMakesOfIt) {
    const auto& [kind, name] = GetParam();
    const std::string kept = read_text(fs::path(SPECTRALPACK_SOURCE_DIR) / "docs" / name);
    EXPECT_TRUE(kept == written(kind)) << "docs/" << name
                                       << " is old; write it anew with: cmake --build build --target write_docs";
}

INSTANTIATE_TEST_SUITE_P(Documents, Kept,
                         testing::Values(std::pair("schema", "job.schema.json"), std::pair("cli", "cli.md")),
                         [](const auto& document) { return std::string(document.param.first); });

TEST(Documents, NameEveryOptionWithItsHelp) {
    const std::string reference = written("cli"), man = written("man");
    for (const Option& option : option_table()) {
        EXPECT_TRUE(contains(reference, "### " + std::string(option.name) + "\n")) << option.name;
        EXPECT_TRUE(option.help.empty() || contains(reference, std::string(option.help))) << option.name;
        std::string escaped;
        for (const char c : "--" + std::string(option.name)) {
            escaped += c == '-' ? std::string("\\-") : std::string(1, c);
        }
        EXPECT_TRUE(contains(man, "\\fB" + escaped + "\\fR")) << option.name;
    }
    EXPECT_TRUE(contains(man, "no\\-refine"));
}

TEST(Documents, TheManPageHasNoFaults) {
    const TemporaryFolder folder;
    const fs::path page = file_with(folder, "spectralpack.1", written("man"));
    if (!is_there("groff")) GTEST_SKIP() << "groff is not here";
    const Ran ran = run({"/usr/bin/env", "groff", "-man", "-Tutf8", "-ww", page.string()});
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err, "");
    EXPECT_TRUE(contains(ran.out, "NAME")) << ran.out.substr(0, 500);
}

/// What bash offers after `line`, whose last word is being typed.
std::vector<std::string> offers(const std::vector<std::string>& line) {
    static const TemporaryFolder folder;
    std::ofstream(folder / "completion.bash") << written("bash");
    std::string words;
    for (const std::string& word : line) {
        words += " '" + word + "'";
    }
    const std::string script =
        "cd '" + folder.path().string() + "'; . ./completion.bash; COMP_WORDS=(" + words +
        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _spectralpack; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const Ran ran = run({"/usr/bin/env", "bash", "-c", script});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    std::vector<std::string> found;
    std::istringstream lines(ran.out);
    for (std::string text; std::getline(lines, text);) {
        if (!text.empty()) found.push_back(text);
    }
    return found;
}

using Texts = std::vector<std::string>;

TEST(Documents, BashOffersCommandsOptionsAndWords) {
    if (!is_there("bash")) GTEST_SKIP() << "bash is not here";
    EXPECT_EQ(offers({"spectralpack", "rend"}), Texts{"render"});
    EXPECT_EQ(offers({"spectralpack", "pack", "--wall"}), Texts{"--wall-gap"});
    EXPECT_EQ(offers({"spectralpack", "pack", "a.stl", "--no-"}), (Texts{"--no-refine", "--no-config", "--no-resume"}));
    EXPECT_EQ(offers({"spectralpack", "pack", "--interlock", ""}), (Texts{"off", "place", "post"}));
    EXPECT_EQ(offers({"spectralpack", "pack", "--height-at", "a"}), Texts{"auto"});
    EXPECT_EQ(offers({"spectralpack", "pack", "--printer", "hp-mjf-52"}), Texts{"hp-mjf-5200"});
    EXPECT_EQ(offers({"spectralpack", "pack", "--gap", ""}), Texts{}) << "nobody can guess it";
    EXPECT_EQ(offers({"spectralpack", "pack", "-o", "compl"}), Texts{"completion.bash"});
    EXPECT_EQ(offers({"spectralpack", "check", "compl"}), Texts{"completion.bash"});
    EXPECT_EQ(offers({"spectralpack", "prepare", "--unit", "in"}), Texts{"inch"});
    EXPECT_EQ(offers({"spectralpack", "help", "wall"}), Texts{"wall-gap"});
}

TEST(Documents, OtherShellsCanReadTheirCompletions) {
    const TemporaryFolder folder;
    const std::string zsh = written("zsh"), fish = written("fish");
    for (const std::string& text : {zsh, fish}) {
        EXPECT_TRUE(contains(text, "pack") && contains(text, "icosahedron"));
    }
    const bool has_zsh = is_there("zsh"), has_fish = is_there("fish");
    if (has_zsh) {
        const Ran ran = run({"/usr/bin/env", "zsh", "-n", file_with(folder, "_spectralpack", zsh).string()});
        EXPECT_EQ(ran.status, 0) << ran.err;
    }
    if (has_fish) {
        const Ran ran = run({"/usr/bin/env", "fish", "-n", file_with(folder, "spectralpack.fish", fish).string()});
        EXPECT_EQ(ran.status, 0) << ran.err;
    }
    if (!has_zsh || !has_fish) {
        GTEST_SKIP() << (has_zsh ? "" : "zsh is not here ") << (has_fish ? "" : "fish is not here");
    }
}

TEST(Documents, AnUnknownKindIsRefused) { EXPECT_EQ(run({SPECTRALPACK_DOCS, "poem"}).status, 2); }

}  // namespace
}  // namespace spectralpack::test
