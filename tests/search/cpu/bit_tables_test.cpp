/// Bit tables and crowd tables against their definition voxel by voxel.

#include <gtest/gtest.h>

#include "search/cpu/forms.hpp"
#include "search/cpu/tables/crowd_tables.hpp"

namespace spectralpack::test {
namespace {

/// Where a piece lies in bit tables.
BitTables::Place place_of(const BitTables& bits, int layer, const Form& form, const VoxelIndex& d) {
    return bits.place(BitTables::SpotsOf(bits, layer, form)(d));
}

TEST(BitTables, AreDilationsByRunsPlatesAndCubes) {
    RandomStream random(2);
    for (int i = 0; i < 24; ++i) {
        const int s = between(random, 1, 3);
        const Extent n = random_extent(random, {1, 1, 1}, i % 3 == 0 ? Extent{70, 12, 90} : Extent{130, 12, 10});
        const int margin = between(random, 0, 3);
        BitGrid occupied = random_bits(random, {s * n.x, s * n.y, s * n.z}, 60);
        BitTables tables({n, margin, s, 2, 0});
        const auto refresh = [&](const VoxelBox& changed) {
            const SplitVoxels split_up = split(occupied, {}, s);
            std::vector<const BitGrid*> parts;
            for (const BitGrid& part : split_up.parts) {
                parts.push_back(&part);
            }
            tables.refresh(1, parts, changed);
        };
        refresh(whole(n));
        VoxelBox box;
        for (int a = 0; a < 3; ++a) {
            box.lo[a] = between(random, 0, n[a] - 1);
            box.hi[a] = between(random, box.lo[a] + 1, n[a]);
        }
        const VoxelIndex size = box.hi - box.lo;
        for_each_voxel({s * size.x, s * size.y, s * size.z}, [&](int x, int y, int z) {
            occupied.set(s * box.lo.x + x, s * box.lo.y + y, s * box.lo.z + z, one_in(random, 90));
        });
        refresh(box);
        for (int question = 0; question < 1000; ++question) {
            const Form form = random_form(random, BitTables::forms_for(s));
            VoxelIndex at;
            for (int a = 0; a < 3; ++a) {
                at[a] = between(random, -s * margin, s * (n[a] + margin) - 1);
            }
            bool expected = false;
            for_each_voxel_of(form, at, [&](const VoxelIndex& v) {
                expected |= occupied.extent().contains(v) && occupied.get(v.x, v.y, v.z);
            });
            const BitTables::Place place = place_of(tables, 1, form, at);
            const std::uint64_t word = tables.tile(0, 0, 0)[place.offset];
            ASSERT_EQ((word >> place.shift & 1) != 0, expected);
            ASSERT_EQ(tables.tile(0, 0, 0)[place_of(tables, 0, form, at).offset], 0u);
        }
    }
}

TEST(BitTables, FollowChangesAsIfMadeAfresh) {
    RandomStream random(3);
    const Extent n{140, 17, 23};
    const Workers one(1);
    for (int s = 1; s <= 3; ++s) {
        BitGrid occupied({s * n.x, s * n.y, s * n.z});
        BitTables tables({n, 2, s, 1, 0});
        CrowdTables crowd(tables);
        for (int i = 0; i < 30; ++i) {
            const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {70, 9, 9}));
            const Extent& e = solid.extent();
            const VoxelIndex at{between(random, -5, s * n.x), between(random, -5, s * n.y),
                                between(random, -5, s * n.z)};
            one_in(random, 3) ? subtract(occupied, solid, at) : unite(occupied, solid, at);
            const SplitVoxels split_up = split(occupied, {}, s);
            std::vector<const BitGrid*> parts;
            for (const BitGrid& part : split_up.parts) {
                parts.push_back(&part);
            }
            VoxelBox changed;
            for (int a = 0; a < 3; ++a) {
                changed.lo[a] = floor_div(at[a], s);
                changed.hi[a] = ceil_div(at[a] + e[a], s);
            }
            tables.refresh(0, parts, changed);
            crowd.refresh(tables, 0, changed, one);
            BitTables fresh({n, 2, s, 1, 0});
            fresh.refresh(0, parts, whole(n));
            EXPECT_TRUE(fresh == tables);
            CrowdTables fresh_crowd(fresh);
            fresh_crowd.refresh(fresh, 0, whole(n), one);
            EXPECT_TRUE(fresh_crowd == crowd);
        }
    }
}

TEST(CrowdTables, TellWhatCollidesWhereverInABlock) {
    RandomStream random(4);
    const Workers one(1);
    constexpr int b = CrowdTables::kBlock;
    int crowded = 0, open = 0;
    for (int i = 0; i < 24; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {300, 50, 20});
        const int margin = between(random, 0, 3);
        const BitGrid occupied = random_bits(random, n, between(random, 1, 40));
        BitTables bits({n, margin, 1, 1, 0});
        bits.refresh(0, {&occupied}, whole(n));
        CrowdTables crowd(bits);
        crowd.refresh(bits, 0, whole(n), one);
        for (int question = 0; question < 1000; ++question) {
            const Form form = random_form(random, BitTables::kForms);
            if (!crowd.holds(0, form)) continue;
            // A piece at displacement d, of a block of positions that begins at 4 B.
            VoxelIndex block, d;
            for (int a = 0; a < 3; ++a) {
                block[a] = between(random, 0, (n[a] - 1) / b);
                d[a] = between(random, -margin, n[a] + margin - 1 - b * block[a]);
            }
            bool all = true, all_within_reach = true;
            for_each_voxel({2 * b - 1, 2 * b - 1, 2 * b - 1}, [&](int x, int y, int z) {
                VoxelIndex at;
                const VoxelIndex step{x, y, z};
                for (int a = 0; a < 3; ++a) {
                    at[a] = (b * block[a] + d[a] + margin) / b * b - margin + step[a];
                    if (at[a] >= n[a] + margin) return;
                }
                const BitTables::Place place = place_of(bits, 0, form, at);
                const bool meets = bits.tile(0, 0, 0)[place.offset] >> place.shift & 1;
                all_within_reach = all_within_reach && meets;
                const VoxelIndex within = at - d - VoxelIndex{b * block.x, b * block.y, b * block.z};
                if (Extent{b, b, b}.contains(within)) all = all && meets;
            });
            const BitTables::Place place = crowd.place(BitTables::SpotsOf(bits, 0, form)(d));
            const std::uint64_t* tile =
                crowd.tile(block.x / CrowdTables::kTileX, block.y / CrowdTables::kTileY, block.z);
            const std::uint64_t* word = tile + place.offset + block.y % CrowdTables::kTileY;
            const int bit = block.x % CrowdTables::kTileX + place.shift;
            const bool told = bit_from(word, crowd.next(), bit);
            ASSERT_EQ(told, all_within_reach);
            ASSERT_TRUE(all || !told);
            ++(told ? crowded : open);
        }
    }
    EXPECT_GT(crowded, 300);
    EXPECT_GT(open, 300);
}

TEST(Forms, AreNumberedInTheirOrder) {
    for (const Forms& forms : {BitTables::kForms, BitTables::kFineForms}) {
        const std::vector<Form> all = in_order(forms);
        EXPECT_EQ(forms.count(), std::ssize(all));
        for (int i = 0; i < forms.count(); ++i) {
            EXPECT_EQ(forms.index(all[static_cast<std::size_t>(i)]), i);
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
