/// What another program makes of a 3MF written here.

#include <algorithm>
#include <array>

#include "files.hpp"
#include "packings.hpp"

namespace spectralpack {
namespace {

constexpr const char* kSlicer = "/usr/bin/prusa-slicer";

/// The boxes that `prusa-slicer --info` prints, one for each build item, sorted.
std::vector<std::array<double, 6>> boxes_in(const std::string& output) {
    std::vector<std::array<double, 6>> boxes;
    std::istringstream lines(output);
    const char* keys[] = {"min_x", "min_y", "min_z", "max_x", "max_y", "max_z"};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        for (std::size_t i = 0; i < 6 && equals != std::string::npos; ++i) {
            if (line.substr(0, equals) != keys[i]) continue;
            if (i == 0) boxes.emplace_back();
            boxes.back()[i] = std::stod(line.substr(equals + 3));
        }
    }
    std::sort(boxes.begin(), boxes.end());
    return boxes;
}

TEST(PrusaSlicer, FindsEveryCopyWhereItWasPlaced) {
    if (!std::filesystem::exists(kSlicer)) GTEST_SKIP() << "PrusaSlicer is not installed";
    const test::TemporaryFolder folder;
    Packing packing;
    packing.container.size = {100, 100, 100};
    packing.parts.resize(2);
    packing.parts[0].name = "box \"&\" <lid>";
    packing.parts[1].name = "torus";
    const PartMeshes meshes{std::make_shared<Mesh>(test::box_mesh({1, 2, 3}, {11, 22, 33})),
                            std::make_shared<Mesh>(test::torus_mesh(10, 3))};
    packing.trays.resize(1);
    const Mat3 turned{{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}};
    packing.trays[0].placements = {{0, 0, 0, false, {turned, {40.25, 5, 1}}},
                                   {0, 1, 0, false, {Mat3{}, {60, 30, 10}}},
                                   {1, 0, 0, false, {2.0 * turned, {45, 50, 20}}}};
    write_3mf(packing, meshes, folder / "p.3mf");
    const test::Ran ran = test::run({"/usr/bin/env", "HOME=" + folder.path().string(), "timeout", "60", kSlicer,
                                     "--datadir", folder.path().string(), "--info", (folder / "p.3mf").string()});
    ASSERT_EQ(ran.status, 0) << ran.err;
    std::vector<std::array<double, 6>> expected;
    for (const Placement& placement : packing.trays[0].placements) {
        const Box box =
            bounding_box(transformed(*meshes[static_cast<std::size_t>(placement.part)], placement.transform));
        expected.push_back({box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z});
    }
    std::sort(expected.begin(), expected.end());
    const auto found = boxes_in(ran.out);
    ASSERT_EQ(found.size(), expected.size()) << ran.out;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (std::size_t k = 0; k < 6; ++k) {
            EXPECT_NEAR(found[i][k], expected[i][k], 1e-4);
        }
    }
    EXPECT_FALSE(test::contains(ran.out, "manifold = no"));
}

}  // namespace
}  // namespace spectralpack
