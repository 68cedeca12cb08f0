#include "disassembly/ways/closed_region.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "search/random_scene.hpp"

namespace spectralpack::test {
namespace {

VoxelIndex random_place(RandomStream& random, int low, int high) {
    return {between(random, low, high), between(random, low, high), between(random, low, high)};
}

TEST(ClosedRegion, IsTouchedByWhomTheSolidMeetsAtSomePosition) {
    int touched = 0, in_box_only = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const BitGrid solid = random_bits(random, random_extent(random, {1, 1, 1}, {90, 6, 6}), 20);
        VoxelBox positions;
        positions.lo = random_place(random, -6, 5);
        positions.hi = positions.lo + random_place(random, 1, 7);
        const TrayObject object{
            std::make_shared<const BitGrid>(random_bits(random, random_extent(random, {1, 1, 1}, {70, 6, 6}), 20)),
            random_place(random, -8, 7)};
        bool meets = false;
        for (int z = positions.lo.z; z < positions.hi.z; ++z) {
            for (int y = positions.lo.y; y < positions.hi.y; ++y) {
                for (int x = positions.lo.x; x < positions.hi.x; ++x) {
                    meets = meets || intersects(solid, *object.solid, object.position - VoxelIndex{x, y, z});
                }
            }
        }
        ASSERT_EQ(ClosedRegion(solid, positions).touches(object), meets);
        const Extent& e = solid.extent();
        const VoxelBox box{positions.lo, positions.hi + VoxelIndex{e.x - 1, e.y - 1, e.z - 1}};
        const bool in_box = !intersection(box, object.box()).empty();
        ASSERT_EQ(ClosedRegion(box).touches(object), in_box);
        touched += meets;
        in_box_only += in_box && !meets;
    }
    EXPECT_GT(touched, 200);
    EXPECT_GT(in_box_only, 200);
}

TEST(ClosedRegion, OfAWideRangeIsTheBoxAround) {
    BitGrid corner({2, 2, 2});
    corner.set(0, 0, 0);
    const ClosedRegion region(corner, {{0, 0, 0}, {100, 1, 1}});
    BitGrid die({1, 1, 1});
    die.fill(true);
    const auto solid = std::make_shared<const BitGrid>(die);
    EXPECT_TRUE(region.touches({solid, {99, 0, 0}}));
    EXPECT_TRUE(region.touches({solid, {100, 1, 1}}));
    EXPECT_FALSE(region.touches({solid, {101, 0, 0}}));
}

}  // namespace
}  // namespace spectralpack::test
