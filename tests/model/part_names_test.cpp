#include "model/part_names.hpp"

#include <gtest/gtest.h>

namespace spectralpack {
namespace {

using Names = std::vector<std::string>;

NameSource file(const std::string& path, const std::string& stem, double scale = 1) {
    return {stem, path, false, false, scale};
}

NameSource object(const std::string& path, const std::string& name) { return {name, path, true, false, 1}; }

TEST(PartNames, AreShortWhereTheyAreApart) {
    EXPECT_EQ(names_apart({file("left/bracket.stl", "bracket"), file("right/knob.stl", "knob", 1.02)}),
              (Names{"bracket", "knob"}));
    EXPECT_EQ(names_apart({}), Names{});
}

TEST(PartNames, HaveAsManyFoldersAsTellThemApart) {
    EXPECT_EQ(names_apart({file("left/bracket.stl", "bracket"), file("right/bracket.stl", "bracket")}),
              (Names{"left/bracket", "right/bracket"}));
    EXPECT_EQ(names_apart({file("a/left/b.stl", "b"), file("c/left/b.stl", "b"), file("d/right/b.stl", "b")}),
              (Names{"a/left/b", "c/left/b", "right/b"}));
    EXPECT_EQ(names_apart({file("b.stl", "b"), file("left/b.stl", "b")}), (Names{"b", "left/b"}));
}

TEST(PartNames, OfTheSameMeshAreTheSame) {
    EXPECT_EQ(names_apart({file("left/b.stl", "b"), file("./left/b.stl", "b")}), (Names{"b", "b"}));
}

TEST(PartNames, ShowScalesWhereTheyDiffer) {
    EXPECT_EQ(names_apart({file("b.stl", "b"), file("b.stl", "b", 1.02), file("c.stl", "c", 2)}),
              (Names{"b", "b x 1.02", "c"}));
}

TEST(PartNames, ShowTheFileOfObjectsAndEndingsThatDiffer) {
    EXPECT_EQ(names_apart({object("one.3mf", "Body"), object("two.3mf", "Body")}), (Names{"one/Body", "two/Body"}));
    EXPECT_EQ(names_apart({file("in/b.stl", "b"), file("in/b.obj", "b")}), (Names{"in/b.stl", "in/b.obj"}));
    EXPECT_EQ(names_apart({file("b.stl", "b"), file("b.obj", "b")}), (Names{"b.stl", "b.obj"}));
}

TEST(PartNames, ThatPeopleGaveStay) {
    const NameSource lid{"lid", "left/b.stl", true, true, 1}, other{"lid", "right/b.stl", true, true, 2};
    EXPECT_EQ(names_apart({lid, other}), (Names{"lid", "lid"}));
    EXPECT_EQ(names_apart({lid, file("new/lid.stl", "lid")}), (Names{"lid", "new/lid"}));
}

}  // namespace
}  // namespace spectralpack
