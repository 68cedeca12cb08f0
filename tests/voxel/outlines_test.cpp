#include "voxel/outlines.hpp"

#include <gtest/gtest.h>

#include "search/random_scene.hpp"

namespace spectralpack::test {
namespace {

/// Step by step, as far as it takes.
bool plainly_leaves(const BitGrid& moving, const BitGrid& still, const VoxelIndex& at) {
    for (int move = 0; move < 6; ++move) {
        const int axis = move / 2, step = move % 2 == 0 ? 1 : -1;
        VoxelIndex q = at;
        bool free = true;
        for (int i = 0; i < moving.extent()[axis] + still.extent()[axis] && free; ++i, q[axis] += step) {
            free = !intersects(still, moving, q);
        }
        if (free) return true;
    }
    return false;
}

TEST(Outlines, TellWhatCanBeDrawnStraightApart) {
    int asked = 0, held = 0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Extent most{7, 6, 5};
        most[static_cast<int>(seed % 3)] = seed % 5 == 0 ? 140 : 9;  // rows of several words
        const BitGrid a = random_solid(random, random_extent(random, {1, 1, 1}, most));
        const BitGrid b = random_solid(random, random_extent(random, {1, 1, 1}, most));
        const Outlines moving(a), still(b);
        for (int i = 0; i < 30; ++i) {
            VoxelIndex at;
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = between(random, -a.extent()[axis], b.extent()[axis]);
            }
            if (intersects(b, a, at)) continue;
            const bool leaves = plainly_leaves(a, b, at);
            ASSERT_EQ(moving.leave(still, at), leaves) << at.x << " " << at.y << " " << at.z;
            ++asked;
            held += !leaves;
        }
    }
    EXPECT_GT(asked, 20000);
    EXPECT_GT(held, 30);
}

TEST(Outlines, JoinThoseOfWhatIsPutIntoAGrid) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        BitGrid all(random_extent(random, {1, 1, 1}, {seed % 5 == 0 ? 140 : 9, 8, 7}));
        Outlines joined(all.extent());
        for (int i = 0; i < 4; ++i) {
            const BitGrid some = random_solid(random, random_extent(random, {1, 1, 1}, all.extent()));
            VoxelIndex at;
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = between(random, 0, all.extent()[axis] - some.extent()[axis]);
            }
            unite(all, some, at);
            joined.join(Outlines(some), at);
            ASSERT_EQ(joined, Outlines(all));
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
