#include "support/names.hpp"

namespace spectralpack::test {
namespace {

TEST(Names, FindsWordsWhateverTheirCaseButNotInsideOfOthers) {
    const std::string text = "spectralpack: /tmp/a1/Bracket.stl: --gap must be less; INTERLOCKED, see cube #12";
    EXPECT_TRUE(names(text, {"bracket.stl", "/tmp/a1/Bracket.stl", "--gap", "interlock", "cube #12"}));
    EXPECT_FALSE(names(text, {"racket.stl"}));
    EXPECT_FALSE(names(text, {"locked"}));
    EXPECT_FALSE(names(text, {"cube #1"}));
    EXPECT_FALSE(names(text, {"bracket.stl", "--wall-gap"})) << "all facts are needed";
}

TEST(Names, FindsNumbersByTheirValue) {
    const std::string text = "placed 12 of 12.50 at (-3, 0, 7): 83.3 %, 1e+08, part7 x2, 3mm, v1.2.3";
    EXPECT_TRUE(names(text, {12, 12.5, -3, 0, 7, 83.333, 1e8}));
    EXPECT_FALSE(names(text, {3}));
    EXPECT_FALSE(names(text, {2}));
    EXPECT_FALSE(names(text, {13}));
    EXPECT_FALSE(names(text, {84.0}));
    EXPECT_FALSE(names("1001 copies", {1000})) << "counts are exact";
}

TEST(Names, QuantitiesHaveTheirUnits) {
    const auto found = quantities_in("about 14 min 25 s, 3.8 GB, 19.7%; 4.");
    ASSERT_EQ(found.size(), 5u);
    const std::string units[] = {"min", "s", "GB", "%", ""};
    const double values[] = {14, 25, 3.8, 19.7, 4};
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].value, values[i]);
        EXPECT_EQ(found[i].unit, units[i]);
    }
}

TEST(Names, AnyTextMayNameThem) {
    EXPECT_TRUE(any_names({"2 facets dropped", "3 facets turned"}, {3, "facets"}));
    EXPECT_FALSE(any_names({"2 facets dropped", "3 vertices merged"}, {3, "facets"})) << "not one text each";
}

}  // namespace
}  // namespace spectralpack::test
