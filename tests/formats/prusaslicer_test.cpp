/// What another program makes of a 3MF written here.

#include <algorithm>
#include <array>
#include <utility>

#include "files.hpp"
#include "geometry/mesh_shells.hpp"
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

using Boxes = std::vector<std::array<double, 6>>;

std::array<double, 6> numbers(const Box& box) {
    return {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
}

/// The boxes of the solids in a mesh file, sorted.
Boxes solids_in(const std::filesystem::path& file) {
    Boxes boxes;
    for (const LoadedMesh& loaded : read_meshes(file)) {
        for (const Shell& shell : shell_groups(loaded.mesh, MeshEdges(loaded.mesh)).shells) {
            boxes.push_back(numbers(shell.box));
        }
    }
    std::sort(boxes.begin(), boxes.end());
    return boxes;
}

void expect_near(const Boxes& found, const Boxes& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (std::size_t k = 0; k < 6; ++k) {
            EXPECT_NEAR(found[i][k], expected[i][k], 1e-4) << "copy " << i;
        }
    }
}

/// As seen from the lower corner of all.
Boxes from_their_corner(Boxes boxes) {
    std::array<double, 3> corner{Box::kInfinity, Box::kInfinity, Box::kInfinity};
    for (const std::array<double, 6>& box : boxes) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            corner[axis] = std::min(corner[axis], box[axis]);
        }
    }
    for (std::array<double, 6>& box : boxes) {
        for (std::size_t k = 0; k < 6; ++k) {
            box[k] -= corner[k % 3];
        }
    }
    std::sort(boxes.begin(), boxes.end());
    return boxes;
}

/// A build whose copies all float above the bed.
class PrusaSlicer : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(kSlicer)) GTEST_SKIP() << "PrusaSlicer is not installed";
        packing_.container.size = {100, 100, 100};
        packing_.parts.resize(2);
        packing_.parts[0].name = "box \"&\" <lid>";
        packing_.parts[1].name = "torus";
        packing_.trays.resize(1);
        const Mat3 turned{{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}};
        packing_.trays[0].placements = {{0, 0, 0, false, {turned, {40.25, 5, 1}}},
                                        {0, 1, 0, false, {Mat3{}, {60, 30, 10}}},
                                        {1, 0, 0, false, {2.0 * turned, {45, 50, 20}}}};
        for (const Placement& placement : packing_.trays[0].placements) {
            const Mesh& mesh = *meshes_[static_cast<std::size_t>(placement.part)];
            expected_.push_back(numbers(bounding_box(transformed(mesh, placement.transform))));
        }
        std::sort(expected_.begin(), expected_.end());
        write_3mf(packing_, meshes_, folder_ / "p.3mf");
    }

    test::Ran slicer(const std::vector<std::string>& arguments, const char* build = "p.3mf") const {
        std::vector<std::string> all{
            "/usr/bin/env",         "HOME=" + folder_.path().string(), "timeout", "60", kSlicer, "--datadir",
            folder_.path().string()};
        all.insert(all.end(), arguments.begin(), arguments.end());
        all.push_back((folder_ / build).string());
        return test::run(all);
    }

    /// The solids that `--export-stl` writes.
    Boxes exported(std::vector<std::string> arguments, const char* build = "p.3mf") const {
        const std::string file = (folder_ / "out.stl").string();
        arguments.insert(arguments.end(), {"--export-stl", "-o", file});
        const test::Ran ran = slicer(arguments, build);
        EXPECT_EQ(ran.status, 0) << ran.err;
        return solids_in(file);
    }

    const test::TemporaryFolder folder_;
    Packing packing_;
    const PartMeshes meshes_{std::make_shared<Mesh>(test::box_mesh({1, 2, 3}, {11, 22, 33})),
                             std::make_shared<Mesh>(test::torus_mesh(10, 3))};
    Boxes expected_;  ///< of the copies
};

TEST_F(PrusaSlicer, FindsEveryCopyWhereItWasPlaced) {
    const test::Ran ran = slicer({"--info"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    expect_near(boxes_in(ran.out), expected_);
    EXPECT_FALSE(test::contains(ran.out, "manifold = no"));
}

/// What docs/guide.md says to add.
TEST_F(PrusaSlicer, KeepsCopiesWhereTheyArePlacedWhereItIsTold) {
    expect_near(exported({"--no-ensure-on-bed", "--dont-arrange"}), expected_);
}

/// Why. The day that this fails, docs/guide.md need no longer say so.
TEST_F(PrusaSlicer, DropsCopiesToTheBedOtherwise) {
    Boxes dropped = expected_;
    for (std::array<double, 6>& box : dropped) {
        box[5] -= std::exchange(box[2], 0);
    }
    std::sort(dropped.begin(), dropped.end());
    expect_near(exported({"--dont-arrange"}), dropped);
}

/// What docs/guide.md points to instead: all of it is moved as one.
TEST_F(PrusaSlicer, KeepsTheMergedStlInOnePiece) {
    write_stl(packing_, meshes_, folder_ / "p.stl");
    expect_near(from_their_corner(exported({}, "p.stl")), from_their_corner(expected_));
}

}  // namespace
}  // namespace spectralpack
