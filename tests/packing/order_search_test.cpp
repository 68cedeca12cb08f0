#include "packing/job/order_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace spectralpack {
namespace {

/// Forty copies of as many parts; the "packing" of an order is a pile in which the first half is placed.
class OrderSearching : public testing::Test {
  protected:
    OrderSearching() {
        for (int part = 0; part < 40; ++part) {
            copies_.push_back({part, 0});
        }
        search_.ranks.assign(40, 0);
        search_.measures = {[](int part) { return (part * 17) % 23 + 1.0; }, [](const PlacedCopy&) { return 1.0; }};
    }

    FoundOrder find() {
        return find_order(
            copies_, search_,
            [&](const std::vector<Copy>& copies, bool beam) -> std::optional<TraysResult> {
                orders_.push_back(copies);
                beams_ += beam ? 1 : 0;
                if (static_cast<int>(orders_.size()) == fail_at_) return std::nullopt;
                if (static_cast<int>(orders_.size()) == stop_at_) stop_.request(StopReason::time_limit);
                TraysResult trays;
                FilledTray& tray = trays.trays.emplace_back();
                for (std::size_t i = 0; i < copies.size() / 2; ++i) {
                    PlacedCopy placed;
                    placed.copy = copies[i];
                    tray.placed.push_back(placed);
                }
                tray.searches = 5;
                return trays;
            },
            stop_.token());
    }

    double placed_volume(const std::vector<Copy>& order) const {
        double sum = 0;
        for (std::size_t i = 0; i < order.size() / 2; ++i) {
            sum += search_.measures.volume(order[i].part);
        }
        return sum;
    }

    std::vector<Copy> copies_;
    OrderSearchOptions search_;
    StopSource stop_;
    std::vector<std::vector<Copy>> orders_;
    int beams_ = 0, fail_at_ = -1, stop_at_ = -1;
};

TEST_F(OrderSearching, OneOrderIsTheOneGiven) {
    const FoundOrder found = find();
    EXPECT_EQ(found.copies, copies_);
    EXPECT_EQ(found.packings, 1);
    EXPECT_EQ(orders_.size(), 1u);
}

TEST_F(OrderSearching, TheBestOfSeveralWinsAndIsNeverWorseThanTheFirst) {
    search_.restarts = 12;
    for (const std::uint64_t seed : {0u, 1u, 2u, 3u}) {
        search_.seed = seed;
        orders_.clear();
        const FoundOrder found = find();
        ASSERT_EQ(orders_.size(), 12u);
        EXPECT_EQ(orders_.front(), copies_);
        double most = 0;
        for (const auto& order : orders_) {
            most = std::max(most, placed_volume(order));
        }
        EXPECT_EQ(placed_volume(found.copies), most);
        EXPECT_GT(most, placed_volume(copies_)) << "no other order was better: the test tells nothing";
        EXPECT_EQ(found.packings, 12);
        EXPECT_EQ(found.trays.searches(), 60);
        const auto before = orders_;
        orders_.clear();
        EXPECT_EQ(find().copies, found.copies);
        EXPECT_EQ(orders_, before) << "the orders follow from the seed";
    }
}

TEST_F(OrderSearching, ABeamComesAfterTheOrderGiven) {
    search_.beam = 3;
    EXPECT_EQ(find().packings, 2);
    EXPECT_EQ(beams_, 1);
    EXPECT_EQ(orders_, (std::vector<std::vector<Copy>>{copies_, copies_}));
}

TEST_F(OrderSearching, AStopLeavesTheBestSoFar) {
    search_.restarts = 1000;
    stop_at_ = 7;
    EXPECT_EQ(find().packings, 7);
    EXPECT_EQ(orders_.size(), 7u);
}

TEST_F(OrderSearching, WhatCannotBePackedIsPassedOver) {
    search_.restarts = 4;
    fail_at_ = 2;
    EXPECT_EQ(find().packings, 3);
}

}  // namespace
}  // namespace spectralpack
