/// The command render, end to end.

#include "cli/packed_cubes.hpp"

namespace spectralpack::test {
namespace {

namespace fs = std::filesystem;

class Render : public PackedCubes {
  protected:
    Render() { save(); }

    void save() {
        measure();
        write();
    }

    Ran render(const std::vector<std::string>& options, const std::string& name) {
        return spectralpack(std::vector<std::string>{"render", file(), "-o", picture(name).string()} + sized(options));
    }

    static std::vector<std::string> sized(std::vector<std::string> options) {
        if (options.empty() || options.front() != "--size")
            options = std::vector<std::string>{"--size", "120x90"} + options;
        return options;
    }

    fs::path picture(const std::string& name) const { return folder_ / name; }
};

TEST_F(Render, DrawsThePackingInTheSizeThatIsAskedFor) {
    const Ran ran = render({}, "b.png");
    EXPECT_EQ(ran.status, 0) << ran.err;
    const std::string png = read_text(picture("b.png"));
    EXPECT_GT(png.size(), 500u);
    // Behind the signature and the head of the first chunk: width and height, 4 bytes each.
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\x78\0\0\0\x5a", 8));
}

TEST_F(Render, DrawsHowItComesApart) {
    const Ran without = render({"--step", "1"}, "none.png");
    EXPECT_EQ(without.status, 2);
    EXPECT_TRUE(names(without.err, {"plan"}));
    EXPECT_FALSE(fs::exists(picture("none.png")));
    plan() = {true, {{{2}, {{10, 0, 0}}}, {{1}, {{10, 0, 0}}}, {{0}, {}}}, {}};
    save();
    EXPECT_EQ(render({}, "whole.png").status, 0);
    EXPECT_EQ(render({"--step", "0"}, "0.png").status, 0);
    EXPECT_EQ(render({"--step", "1"}, "1.png").status, 0);
    EXPECT_EQ(render({"--step", "3", "--tray", "1"}, "3.png").status, 0);
    EXPECT_EQ(render({"--explode", "0.5"}, "apart.png").status, 0);
    const std::string whole = read_text(picture("whole.png"));
    EXPECT_EQ(read_text(picture("0.png")), whole);
    for (const char* other : {"1.png", "3.png", "apart.png"}) {
        EXPECT_NE(read_text(picture(other)), whole) << other;
    }
    EXPECT_EQ(render({"--step", "4"}, "none.png").status, 2);
    EXPECT_EQ(render({"--step", "-1"}, "none.png").status, 2);
    EXPECT_EQ(render({"--explode", "-1"}, "none.png").status, 2);
    EXPECT_EQ(render({"--explode", "1", "--step", "1"}, "none.png").status, 2);
    EXPECT_FALSE(fs::exists(picture("none.png")));
}

TEST_F(Render, LooksInside) {
    EXPECT_EQ(render({}, "whole.png").status, 0);
    EXPECT_EQ(render({"--section", "y=5"}, "cut.png").status, 0);
    EXPECT_NE(read_text(picture("cut.png")), read_text(picture("whole.png")));
    for (const char* wrong : {"5", "y", "w=5", "y=", "y=5mm", "y=-1", "y=51"}) {
        const Ran ran = render({"--section", wrong}, "none.png");
        EXPECT_EQ(ran.status, 2) << wrong;
        EXPECT_TRUE(names(ran.err, {"section"})) << ran.err;
    }
    EXPECT_FALSE(fs::exists(picture("none.png")));
}

TEST_F(Render, WritesNumbersUnlessItIsPlain) {
    EXPECT_EQ(render({"--size", "600x500"}, "numbered.png").status, 0);
    EXPECT_EQ(render({"--size", "600x500", "--plain"}, "plain.png").status, 0);
    EXPECT_NE(read_text(picture("numbered.png")), read_text(picture("plain.png")));
}

}  // namespace
}  // namespace spectralpack::test
