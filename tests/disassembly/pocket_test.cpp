#include "disassembly/pocket.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/random.hpp"

namespace spectralpack {
namespace {

int below(RandomStream& random, int end) { return static_cast<int>(random.below(static_cast<std::uint64_t>(end))); }

VoxelIndex place(RandomStream& random, int end) { return {below(random, end), below(random, end), below(random, end)}; }

BitGrid random_solid(RandomStream& random, const VoxelIndex& most) {
    BitGrid solid({1 + below(random, most.x), 1 + below(random, most.y), 1 + below(random, most.z)});
    for (int voxels = 1 + below(random, 40); voxels > 0; --voxels) {
        solid.set(below(random, solid.extent().x), below(random, solid.extent().y), below(random, solid.extent().z));
    }
    return solid;
}

TEST(Pocket, IsTouchedByWhomTheSolidMeetsAtSomePosition) {
    int touched = 0, in_box_only = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const BitGrid solid = random_solid(random, {90, 6, 6});
        VoxelBox positions;
        positions.lo = place(random, 12) - VoxelIndex{6, 6, 6};
        positions.hi = positions.lo + VoxelIndex{1, 1, 1} + place(random, 7);
        const TrayObject object{std::make_shared<const BitGrid>(random_solid(random, {70, 6, 6})),
                                place(random, 16) - VoxelIndex{8, 8, 8}};
        bool meets = false;
        for (int z = positions.lo.z; z < positions.hi.z; ++z) {
            for (int y = positions.lo.y; y < positions.hi.y; ++y) {
                for (int x = positions.lo.x; x < positions.hi.x; ++x) {
                    meets = meets || intersects(solid, *object.solid, object.position - VoxelIndex{x, y, z});
                }
            }
        }
        ASSERT_EQ(Pocket(solid, positions).touches(object), meets);
        const Extent& e = solid.extent();
        const VoxelBox box{positions.lo, positions.hi + VoxelIndex{e.x - 1, e.y - 1, e.z - 1}};
        const bool in_box = !intersection(box, object.box()).empty();
        ASSERT_EQ(Pocket(box).touches(object), in_box);
        touched += meets;
        in_box_only += in_box && !meets;
    }
    EXPECT_GT(touched, 200);
    EXPECT_GT(in_box_only, 200);
}

TEST(Pocket, OfAWideRangeIsTheBoxAround) {
    BitGrid corner({2, 2, 2});
    corner.set(0, 0, 0);
    const Pocket pocket(corner, {{0, 0, 0}, {100, 1, 1}});
    BitGrid die({1, 1, 1});
    die.fill(true);
    const auto solid = std::make_shared<const BitGrid>(die);
    EXPECT_TRUE(pocket.touches({solid, {99, 0, 0}}));
    EXPECT_TRUE(pocket.touches({solid, {100, 1, 1}}));
    EXPECT_FALSE(pocket.touches({solid, {101, 0, 0}}));
}

}  // namespace
}  // namespace spectralpack
