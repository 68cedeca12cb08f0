#include "packing/tray/shape_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "core/stopped.hpp"
#include "packing/first_fit.hpp"
#include "support/eventually.hpp"

namespace spectralpack {
namespace {

std::vector<Copy> one_each(int parts) {
    std::vector<Copy> copies;
    for (int part = 0; part < parts; ++part) {
        copies.push_back({part, 0});
    }
    return copies;
}

std::shared_ptr<const Shape> box_part(int part, int side, std::atomic<int>& made) {
    return test::box_shape(static_cast<std::uint64_t>(part), side, &made);
}

TEST(ShapeStore, MakesSoManyPartsAheadAndNoMore) {
    std::atomic<int> made{0};
    ShapeStore shapes([&](int part, const Workers&) { return box_part(part, 2, made); }, Workers(2), 0, 3);
    shapes.start_tray(one_each(7));
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(shapes.at(i).id, i);
        const int ahead = std::min(static_cast<int>(i) + 3, 7);
        EXPECT_LE(made, ahead);
        ASSERT_TRUE(test::eventually([&] { return made == ahead; }));
        shapes.release(i, true);
    }
    EXPECT_EQ(made, 7);
}

TEST(ShapeStore, MakesAgainWhatWasStoppedForWorkThatIsGivenUp) {
    for (const int threads : {1, 2}) {
        StopSource placing, planning;
        std::atomic<int> made{0}, stopped{0};
        ShapeStore shapes(
            [&](int part, const Workers& workers) {
                try {
                    workers.check();
                } catch (...) {
                    ++stopped;
                    throw;
                }
                return box_part(part, 2, made);
            },
            Workers(threads), 0, 2);
        shapes.stop_with(placing.token());
        shapes.start_tray(one_each(3));
        EXPECT_EQ(shapes.at(0).id, 0u);
        ASSERT_TRUE(threads == 1 || test::eventually([&] { return made == 2; }));
        placing.request(StopReason::time_limit);
        EXPECT_EQ(shapes.at(0).id, 0u) << "it is there";
        if (threads > 1) {
            EXPECT_EQ(shapes.at(1).id, 1u) << "it is there, too";
            ASSERT_TRUE(test::eventually([&] { return stopped == 1; })) << "of the next, begun now";
        } else {
            EXPECT_THROW(shapes.at(1), Stopped);
        }
        shapes.stop_with(planning.token());
        EXPECT_EQ(shapes.at(2).id, 2u);
        planning.request(StopReason::cancelled);
    }
}

TEST(ShapeStore, MakesFewerAheadInATrayThatWantsFewer) {
    std::atomic<int> made{0};
    ShapeStore shapes([&](int part, const Workers&) { return box_part(part, 2, made); }, Workers(2), 0, 4);
    shapes.start_tray(one_each(7), 2);
    for (std::size_t i = 0; i < 7; ++i) {
        shapes.at(i);
        EXPECT_LE(made, static_cast<int>(i) + 2);
        shapes.release(i, true);
    }
    made = 0;
    shapes.start_tray(one_each(7));
    shapes.at(0);
    EXPECT_TRUE(test::eventually([&] { return made == 4; })) << "the next tray as many as ever";
}

TEST(ShapeStore, MakesNothingAheadOnOneThreadOrForPartsOfManyOrientations) {
    for (const auto& [threads, ahead] : {std::pair{1, 3}, {2, 1}}) {
        std::atomic<int> made{0};
        ShapeStore shapes([&](int part, const Workers&) { return box_part(part, 2, made); }, Workers(threads), 0,
                          ahead);
        shapes.start_tray(one_each(3));
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(shapes.at(i).id, i);
            EXPECT_EQ(made, static_cast<int>(i) + 1);
            shapes.release(i, true);
        }
    }
}

TEST(ShapeStore, WhatWasBegunServesTheNextTray) {
    std::atomic<int> made{0};
    ShapeStore shapes([&](int part, const Workers&) { return box_part(part, 2, made); }, Workers(2), 0, 3);
    shapes.start_tray(one_each(3));
    shapes.at(0);
    ASSERT_TRUE(test::eventually([&] { return made == 3; }));
    shapes.release(0, true);
    shapes.start_tray({{1, 0}});
    EXPECT_EQ(shapes.at(0).id, 1u);
    EXPECT_EQ(made, 3);
    shapes.start_tray({{2, 0}});
    EXPECT_EQ(shapes.at(0).id, 2u);
    EXPECT_EQ(made, 4) << "anew, for the tray before had no use for it";
}

TEST(ShapeStore, WhatNobodyAsksForLeavesRoomForOthers) {
    std::atomic<bool> last_made = false;
    ShapeStore shapes(
        [&](int part, const Workers&) {
            if (part == 6) last_made = true;
            return test::box_shape(static_cast<std::uint64_t>(part), 2);
        },
        Workers(2), 0, 3);
    shapes.start_tray(one_each(7));
    for (std::size_t i = 0; i < 5; ++i) {
        if (i == 0 || i == 4) {
            EXPECT_EQ(shapes.at(i).id, i);
        }
        shapes.release(i, false);
    }
    ASSERT_TRUE(test::eventually([&] { return last_made.load(); }));
}

TEST(ShapeStore, SaysWhatMakingAPartThrew) {
    ShapeStore shapes(
        [](int part, const Workers&) -> std::shared_ptr<const Shape> {
            if (part == 2) throw std::runtime_error("part 2");
            return test::box_shape(static_cast<std::uint64_t>(part), 2);
        },
        Workers(2), 0, 3);
    shapes.start_tray(one_each(3));
    EXPECT_NO_THROW(shapes.at(0));
    EXPECT_NO_THROW(shapes.at(1));
    EXPECT_THROW(shapes.at(2), std::runtime_error);
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
    const auto shape = [&](int part, const Workers&) {
        auto made_shape = std::make_shared<Shape>(*test::box_shape(static_cast<std::uint64_t>(part), 8, &made));
        // Finer voxels count as well.
        made_shape->orientations.front().fine = LazyGrid(BitGrid({16, 16, 16}));
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
