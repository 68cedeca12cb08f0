/// Of a 3MF with several objects, those that a job names.

#include <gtest/gtest.h>
#include <spectralpack/spectralpack.hpp>

#include "support/process.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

class Objects : public ::testing::Test {
  protected:
    /// A 3MF of two objects: a cube, twice, and a bar.
    void SetUp() override {
        Job job;
        job.parts = {{.name = "cube", .mesh = test::cube_mesh(10), .count = 2},
                     {.name = "bar", .mesh = test::box_mesh({0, 0, 0}, {30, 5, 4}), .count = 1}};
        job.options.tray = {60, 60, 40};
        const PackResult result = pack(job);
        file_ = (folder_.path() / "both.3mf").string();
        write_output({result.packing, result.meshes}, file_, 1);
    }

    Packing packing_of(std::vector<Part> parts) {
        Job job;
        job.parts = std::move(parts);
        job.options.tray = {60, 60, 40};
        PackResult result = pack(job);
        unusable_ = result.unusable;
        return result.packing;
    }

    test::TemporaryFolder folder_;
    std::string file_;
    std::vector<InputError> unusable_;
};

TEST_F(Objects, WithoutAWordAllArePackedAsOftenAsTheFileHoldsThem) {
    const Packing packing = packing_of({{.mesh = file_, .count = 2}});
    ASSERT_EQ(packing.parts.size(), 2u);
    EXPECT_EQ(packing.parts[0].count + packing.parts[1].count, 6);
}

TEST_F(Objects, EachMayHaveCountsOfItsOwn) {
    const Packing both = packing_of({{.mesh = file_}});
    const Packing packing = packing_of({{.name = "few", .mesh = file_, .object = both.parts[0].object, .count = 3},
                                        {.name = "many", .mesh = file_, .object = both.parts[1].object, .count = 5}});
    ASSERT_EQ(packing.parts.size(), 2u);
    EXPECT_EQ(packing.parts[0].name, "few");
    EXPECT_EQ(packing.parts[0].count, 3);
    EXPECT_EQ(packing.parts[1].count, 5);
    EXPECT_NEAR(packing.parts[0].volume, both.parts[0].volume, 1e-6);
    EXPECT_NEAR(packing.parts[1].volume, both.parts[1].volume, 1e-6);
    EXPECT_TRUE(unusable_.empty());
}

TEST_F(Objects, OneThatIsNotThereIsNamedAndTheOthersArePacked) {
    const Packing both = packing_of({{.mesh = file_}});
    const Packing packing = packing_of(
        {{.mesh = file_, .object = both.parts[0].object, .count = 3}, {.mesh = file_, .object = "99", .count = 5}});
    ASSERT_EQ(unusable_.size(), 1u);
    EXPECT_EQ(unusable_[0].place(), "object 99");
    EXPECT_EQ(packing.metrics.placed, 3);
    EXPECT_THROW(packing_of({{.mesh = file_, .object = "99"}}), InputError);
}

}  // namespace
}  // namespace spectralpack
