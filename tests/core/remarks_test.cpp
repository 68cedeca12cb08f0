#include "core/remarks.hpp"

#include "support/names.hpp"

namespace spectralpack {
namespace {

TEST(Remarks, TellACauseOnceHoweverManyItIsTrueOf) {
    Remarks remarks;
    remarks.add("cup", {"has 3 holes", "have holes"});
    remarks.add("lid", {"is flat", "are flat"});
    for (int i = 0; i < 20; ++i) {
        remarks.add("part-" + std::to_string(i), {"has " + std::to_string(i) + " holes", "have holes"});
    }
    const std::vector<std::string> texts = remarks.texts();
    ASSERT_EQ(texts.size(), 2u);
    EXPECT_TRUE(test::names(texts[0], {21, "parts have holes", "cup", "part-0", "more"}));
    EXPECT_FALSE(test::names(texts[0], {"part-19"})) << "not all of them";
    EXPECT_EQ(texts[1], "lid is flat");
}

TEST(Remarks, NamesAreCutOnlyWhereThatIsShorter) {
    EXPECT_EQ(listed({"a", "b", "c"}, 2), "a, b, c");
    EXPECT_EQ(listed({"a", "b", "c", "d"}, 2), "a, b and 2 more");
    EXPECT_EQ(listed({}, 2), "");
}

}  // namespace
}  // namespace spectralpack
