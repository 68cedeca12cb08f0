/// Equal boxes that just fit, as a person sees at once, and blocks of them that fill a tray exactly.

#include <algorithm>

#include "cli/whole_job.hpp"
#include "core/random.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

class Blocks : public WholeJob {
  protected:
    /// Packs with these options into build.json.
    json packed(const std::vector<std::string>& arguments) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack"} + arguments +
                                     std::vector<std::string>{"-o", at("build.json")});
        EXPECT_EQ(ran.status, 0) << ran.err;
        return ran.status == 0 ? build() : json();
    }
};

std::string number(double value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
}

TEST_F(Blocks, EightCubesOfAHundredIn201) {
    stl("hundred.stl", cube_mesh(100));
    const std::vector<std::string> tray{"--tray", "201x201x201"};
    EXPECT_EQ(packed(tray + std::vector<std::string>{at("hundred.stl") + ":8"})["metrics"]["placed"], 8);
    expect_sound();
    EXPECT_EQ(packed(tray + std::vector<std::string>{at("hundred.stl"), "--fill"})["metrics"]["placed"], 8);
    expect_sound();
    // Positions on the grid are what --no-refine asks for.
    EXPECT_EQ(packed(tray + std::vector<std::string>{at("hundred.stl") + ":8", "--no-refine"})["metrics"]["placed"], 1);
    // In each of several trays, and round what stands in the way.
    const json trays = packed(tray + std::vector<std::string>{at("hundred.stl") + ":20", "--trays", "all"});
    EXPECT_EQ(trays["trays"].size(), 3u);
    expect_sound();
    EXPECT_EQ(packed(tray + std::vector<std::string>{at("hundred.stl") + ":8", "--keep-out",
                                                     "150,150,150,160,160,160"})["metrics"]["placed"],
              7);
    expect_sound();
}

/// Fills with boxes of two kinds that have the same size: people who number their parts have those.
TEST_F(Blocks, OfSeveralPartsOfOneSize) {
    std::vector<std::string> parts;
    for (int i = 0; i < 8; ++i) {
        const std::string name = "cube" + std::to_string(i) + ".stl";
        stl(name, cube_mesh(33));
        parts.push_back(at(name));
    }
    EXPECT_EQ(packed(parts + std::vector<std::string>{"--tray", "67x67x67", "--gap", "1"})["metrics"]["placed"], 8);
    expect_sound();
}

TEST_F(Blocks, FillATrayExactly) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        RandomStream random(seed);
        const auto between = [&](double low, double high) { return low + (high - low) * random.unit(); };
        const auto rounded = [](double mm) { return std::round(mm * 1000) / 1000; };
        // A file has single precision.
        const auto side = [&] { return static_cast<double>(static_cast<float>(between(5, 40))); };
        const double x = side(), y = side(), z = side();
        const Vec3 size{x, y, z};
        const double gap = seed % 3 == 0 ? 0 : rounded(between(0.1, 5));
        const double wall = seed % 2 == 0 ? 0 : rounded(between(0.1, 5));
        const double slack = seed % 5 < 3 ? 0 : between(0, 2);
        std::string tray;
        int count = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const int along = 1 + static_cast<int>(random.below(4));
            tray += (axis > 0 ? "x" : "") + number(along * size[axis] + (along - 1) * gap + 2 * wall + slack);
            count *= along;
        }
        stl("box.stl", box_mesh({}, size));
        const json packing = packed({at("box.stl") + ":" + std::to_string(count), "--tray", tray, "--gap", number(gap),
                                     "--wall-gap", number(wall)});
        EXPECT_EQ(packing["metrics"]["placed"], count) << "seed " << seed << ": " << x << " x " << y << " x " << z
                                                       << " in " << tray << ", gap " << gap << ", walls " << wall;
        expect_sound();
    }
}

TEST_F(Blocks, AreTheSameForEveryEngine) {
#ifndef SPECTRALPACK_HAS_REFERENCE
    GTEST_SKIP() << "this build has no reference engine";
#endif
    stl("die.stl", cube_mesh(19.3));
    const std::vector<std::string> call{at("die.stl") + ":8", at("cube.stl") + ":30", "--tray", "42x42x55"};
    const json one = packed(call);
    const json other = packed(call + std::vector<std::string>{"--engine", "reference"});
    EXPECT_EQ(one["trays"][0]["placements"], other["trays"][0]["placements"]);
    EXPECT_GE(one["metrics"]["placed"], 8);
    expect_sound();
}

}  // namespace
}  // namespace spectralpack::test
