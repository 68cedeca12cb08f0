#include "disassembly/ways/tile_map.hpp"

#include <gtest/gtest.h>

namespace spectralpack {
namespace {

struct Tile {
    int i, y, z;
    std::uint64_t words[24]{};
};

constexpr Extent kExtent{300, 50, 20};  // tiles: 5 x 7 x 20

Tile& at(TileMap<Tile>& map, int i, int y, int z) {
    return map.at(i, y, z, [&] { return Tile{i, y, z}; });
}

TEST(TileMap, MakesATileWhenItIsFirstTouched) {
    TileMap<Tile> map(kExtent);
    EXPECT_EQ(map.words(), 5);
    EXPECT_EQ(map.find(4, 49, 19), nullptr);
    Tile& tile = at(map, 4, 49, 19);
    EXPECT_EQ(tile.y, 49);
    EXPECT_EQ(&at(map, 4, 48, 19), &tile) << "eight rows are one tile";
    EXPECT_EQ(map.find(4, 50, 19), &tile);
    EXPECT_EQ(map.find(4, 47, 19), nullptr);
    EXPECT_EQ(map.find(3, 49, 19), nullptr);
}

TEST(TileMap, UsesTheRoomOfThoseGivenBackAgain) {
    TileMap<Tile> map(kExtent);
    Tile one_for_all{};
    std::int64_t bytes = 0;
    for (int z = 0; z < kExtent.z; ++z) {
        for (int y = 0; y < kExtent.y; y += FreeTileReader::kRows) {
            for (int i = 0; i < map.words(); ++i) {
                Tile& tile = at(map, i, y, z);
                ASSERT_EQ(tile.i, i);
                ASSERT_EQ(tile.words[0], 0u) << "made anew";
                tile.words[0] = 1;
                map.replace(i, y, z, one_for_all);
                ASSERT_EQ(map.find(i, y, z), &one_for_all);
            }
        }
        if (z == 0) bytes = map.bytes();
    }
    // Rows of pointers, but of tiles no more than one.
    EXPECT_LT(map.bytes() - bytes, 2 * 7 * 20 * 5 * static_cast<std::int64_t>(sizeof(Tile*)) + 4096);
    EXPECT_EQ(one_for_all.words[0], 0u);
}

TEST(TileMap, TilesStayWhereTheyAreAsMoreAreMade) {
    TileMap<Tile> map(kExtent);
    std::vector<Tile*> tiles;
    const auto each = [&](const auto& visit) {
        for (int z = 0; z < kExtent.z; ++z) {
            for (int y = 0; y < kExtent.y; y += FreeTileReader::kRows) {
                for (int i = 0; i < map.words(); ++i) {
                    visit(i, y, z);
                }
            }
        }
    };
    each([&](int i, int y, int z) { tiles.push_back(&at(map, i, y, z)); });
    std::size_t k = 0;
    each([&](int i, int y, int z) {
        ASSERT_EQ(map.find(i, y, z), tiles[k]);
        ASSERT_EQ(tiles[k]->i, i);
        ASSERT_EQ(tiles[k]->y, y);
        ASSERT_EQ(tiles[k]->z, z);
        ++k;
    });
    EXPECT_GE(map.bytes(), static_cast<std::int64_t>(tiles.size() * sizeof(Tile)));
    EXPECT_LT(map.bytes(), static_cast<std::int64_t>(tiles.size() * sizeof(Tile)) + 100'000);
}

}  // namespace
}  // namespace spectralpack
