#include "spectralpack/typed_text.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace spectralpack {
namespace {

const std::vector<std::string> kWords{"--tray", "--trays", "--try-per-tray", "--gap", "--wall-gap", "--keep-out"};

TEST(TypedText, FindsTheWordThatWasMeant) {
    const std::pair<const char*, const char*> meant[] = {
        {"--try", "--tray"},         {"--tary", "--tray"},        {"--Tray", "--tray"},    {"--gaps", "--gap"},
        {"--wallgap", "--wall-gap"}, {"--keepout", "--keep-out"}, {"--wall", "--wall-gap"}};
    for (const auto& [typed, word] : meant) {
        EXPECT_EQ(nearest_word(typed, kWords).value_or("nothing"), word) << typed;
    }
    EXPECT_EQ(nearest_word("pak", std::vector<std::string>{"plan", "pack"}), "pack");
    EXPECT_EQ(nearest_word("fuse1", std::vector<std::string>{"eos-p396", "formlabs-Fuse1"}), "formlabs-Fuse1");
}

TEST(TypedText, FindsNothingWhereNothingIsNear) {
    for (const char* typed : {"--gravity", "--x", "", "-o"}) {
        EXPECT_FALSE(nearest_word(typed, kWords)) << typed;
    }
    EXPECT_FALSE(nearest_word("pack", std::vector<std::string>{}));
}

TEST(TypedText, TakesTheFirstOfSeveralThatAreAsNear) {
    EXPECT_EQ(nearest_word("bracket3.stl", std::vector<std::string>{"bracket1.stl", "bracket2.stl"}), "bracket1.stl");
}

TEST(TypedText, EndingsAreInLowerCase) {
    EXPECT_EQ(ending_of("folder.d/Build.PNG"), ".png");
    EXPECT_EQ(ending_of("build"), "");
}

}  // namespace
}  // namespace spectralpack
