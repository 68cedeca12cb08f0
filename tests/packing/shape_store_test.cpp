#include "packing/shape_store.hpp"

#include <gtest/gtest.h>

#include "packing/first_fit.hpp"

namespace spectralpack {
namespace {

std::vector<PackItem> one_each(int parts) {
    std::vector<PackItem> items;
    for (int part = 0; part < parts; ++part) {
        items.push_back({part, 0});
    }
    return items;
}

TEST(ShapeStore, MakesSoManyPartsAheadAndNoMore) {
    std::atomic<int> made{0};
    ShapeStore shapes([&](int part) { return test::box_shape(static_cast<std::uint64_t>(part), 2, &made); }, Workers(2),
                      0, 3);
    shapes.start_tray(one_each(7));
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(shapes.at(i).id, i);
        EXPECT_EQ(made, std::min<int>(3 * (static_cast<int>(i) / 3 + 1), 7));
        shapes.release(i, true);
    }
}

TEST(ShapeStore, TheMoreOrientationsTheFewerPartsAtATime) {
    EXPECT_EQ(ShapeStore::ahead(1), ShapeStore::kAhead);
    EXPECT_EQ(ShapeStore::ahead(24), ShapeStore::kAhead);
    EXPECT_EQ(ShapeStore::ahead(208), 3);
    EXPECT_EQ(ShapeStore::ahead(744), 1);
    EXPECT_EQ(ShapeStore::ahead(5000), 1);
}

TEST(ShapeStore, KeepsWhatATrayLeftOverAsFarAsItsBytesGo) {
    std::atomic<int> made{0};
    const auto shape = [&](int part) {
        auto made_shape = std::make_shared<Shape>(*test::box_shape(static_cast<std::uint64_t>(part), 8, &made));
        // Finer voxels count as well.
        auto fine = std::make_shared<BitGrid>(Extent{16, 16, 16});
        made_shape->orientations.front().fine = fine;
        return made_shape;
    };
    const std::int64_t bytes = BitGrid(Extent{16, 16, 16}).bytes();
    ShapeStore shapes(shape, Workers(1), 2 * bytes, 1);  // one part's, less than two's
    shapes.start_tray(one_each(2));
    for (std::size_t i = 0; i < 2; ++i) {
        shapes.at(i);
        shapes.release(i, false);
    }
    shapes.start_tray(one_each(2));
    shapes.at(0);
    EXPECT_EQ(made, 2) << "the first was kept";
    shapes.at(1);
    EXPECT_EQ(made, 3) << "the second was not";
}

}  // namespace
}  // namespace spectralpack
