#include "packing/off_grid/box_room.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace spectralpack {
namespace {

const BoxRoom::Accepts kAny = [](const Vec3&) { return true; };

TEST(BoxRoom, BoxesStandBesideEachOtherAtTheLargerGap) {
    BoxRoom room({{1, 1, 1}, {24, 11, 11}});
    EXPECT_EQ(room.lowest({10, 10, 10}, 1, kAny), (Vec3{1, 1, 1}));
    room.add({{{1, 1, 1}, {11, 11, 11}}, 3});
    EXPECT_EQ(room.lowest({10, 10, 10}, 1, kAny), (Vec3{14, 1, 1}));
    EXPECT_FALSE(room.lowest({10.1, 10, 10}, 1, kAny));
    EXPECT_FALSE(room.lowest({10, 10, 10}, 3.1, kAny));
    room.add({{{14, 0, 0}, {15, 1, 30}}, 2, true});  // of a wall the wall's gap counts
    EXPECT_FALSE(room.lowest({10, 9, 10}, 9, kAny));
    EXPECT_EQ(room.lowest({10, 8, 10}, 1, kAny), (Vec3{14, 3, 1}));
}

TEST(BoxRoom, WhatIsTurnedDownIsAskedAboutBeyond) {
    BoxRoom room({{0, 0, 0}, {30, 10, 10}});
    room.add({{{0, 0, 0}, {10, 10, 10}}, 0});
    room.add({{{15, 0, 0}, {20, 10, 10}}, 0});
    EXPECT_EQ(room.lowest({5, 10, 10}, 0, [](const Vec3& at) { return at.x > 12; }), (Vec3{20, 0, 0}));
}

TEST(BoxRoom, WorkIsBounded) {
    BoxRoom room({{0, 0, 0}, {30, 10, 10}}, 1);
    room.add({{{0, 0, 0}, {10, 10, 10}}, 0});
    EXPECT_FALSE(room.lowest({5, 10, 10}, 0, kAny));
}

TEST(BoxRoom, ALatticeLeavesOutWhatIsTaken) {
    BoxRoom room({{0, 0, 0}, {20.2, 20.2, 10}});
    EXPECT_EQ(room.lattice({10, 10, 10}, 0.2, 100).size(), 4u);
    EXPECT_EQ(room.lattice({10, 10, 10}, 0.2, 3).size(), 3u);
    EXPECT_EQ(room.lattice({10, 10, 10}, 0.3, 100).size(), 1u);
    room.add({{{1, 1, 1}, {2, 2, 2}}, 0});
    const std::vector<Vec3> corners = room.lattice({10, 10, 10}, 0.2, 100);
    ASSERT_EQ(corners.size(), 3u);
    EXPECT_EQ(corners.front(), (Vec3{10.2, 0, 0}));
}

/// Whatever whole numbers the boxes have: the least place among all whole numbers is found, and none where there is
/// none.
TEST(BoxRoom, FindsTheLowestPlaceThereIs) {
    int found = 0, full = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        RandomStream random(seed);
        const auto any = [&](int low, int high) {
            return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low + 1)));
        };
        const auto point = [&](int low, int high) {
            const int x = any(low, high), y = any(low, high), z = any(low, high);
            return Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        };
        const Box all{{}, {9, 9, 9}};
        BoxRoom room(all);
        std::vector<StandingBox> standing;
        for (int i = any(0, 12); i > 0; --i) {
            const Vec3 low = point(-2, 8);
            standing.push_back({{low, low + point(1, 5)}, static_cast<double>(any(0, 2)), any(0, 3) == 0});
            room.add(standing.back());
        }
        const Vec3 size = point(1, 5);
        const double gap = any(0, 2);
        const auto is_free = [&](const Vec3& corner) {
            for (const StandingBox& other : standing) {
                const double kept = other.wall ? other.gap : std::max(gap, other.gap);
                bool apart = false;
                for (int axis = 0; axis < 3; ++axis) {
                    apart = apart || corner[axis] >= other.box.max[axis] + kept ||
                            corner[axis] + size[axis] + kept <= other.box.min[axis];
                }
                if (!apart) return false;
            }
            return true;
        };
        std::optional<Vec3> least;
        for (int z = 0; z + size.z <= 9 && !least; ++z)
            for (int y = 0; y + size.y <= 9 && !least; ++y)
                for (int x = 0; x + size.x <= 9 && !least; ++x) {
                    const Vec3 corner{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                    if (is_free(corner)) least = corner;
                }
        EXPECT_EQ(room.lowest(size, gap, kAny), least) << seed;
        ++(least ? found : full);
    }
    EXPECT_GT(found, 50);
    EXPECT_GT(full, 50);
}

}  // namespace
}  // namespace spectralpack
