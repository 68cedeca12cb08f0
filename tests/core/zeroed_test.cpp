#include "core/zeroed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace spectralpack {
namespace {

/// Sizes on both sides of those that huge pages begin at and end on.
constexpr std::size_t kSizes[] = {
    1, 100, kHugePage - 1, kHugePage, kHugePage + 1, 3 * kHugePage, 3 * kHugePage + 8, 5 * kHugePage - 4096};

TEST(Zeroed, ArraysAreZeroFromEndToEndAlsoWhereOthersWereBefore) {
    for (int round = 0; round < 3; ++round) {
        for (const std::size_t size : kSizes) {
            ZeroedVector<std::uint8_t> bytes(size);
            ASSERT_TRUE(std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; })) << size;
            std::ranges::fill(bytes, std::uint8_t{255});
        }
    }
}

TEST(Zeroed, SeveralArraysStandBesideEachOther) {
    std::vector<ZeroedVector<std::uint8_t>> arrays;
    for (const std::size_t size : kSizes) {
        arrays.emplace_back(size);
        std::ranges::fill(arrays.back(), static_cast<std::uint8_t>(arrays.size()));
    }
    arrays.erase(arrays.begin() + 5);  // what is around it stays
    for (const ZeroedVector<std::uint8_t>& array : arrays) {
        const std::uint8_t own = array.front();
        EXPECT_TRUE(std::ranges::all_of(array, [&](std::uint8_t byte) { return byte == own; }));
        EXPECT_EQ(std::ranges::count(arrays, own, [](const auto& other) { return other.front(); }), 1);
    }
}

TEST(Zeroed, LargeOnesBeginOnAHugePage) {
#ifndef __linux__
    GTEST_SKIP() << "huge pages are asked for on Linux only";
#endif
    const ZeroedVector<std::uint64_t> array(kHugePage);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % kHugePage, 0u);
}

TEST(Zeroed, SizesCountWholePages) {
    EXPECT_EQ(zeroed_size(0), 0u);
    EXPECT_EQ(zeroed_size(kHugePage - 1), kHugePage - 1);
    EXPECT_EQ(zeroed_size(kHugePage), kHugePage);
    EXPECT_EQ(zeroed_size(kHugePage + 1), 2 * kHugePage);
}

TEST(Zeroed, MoreThanThereIsIsRefused) {
    EXPECT_THROW(ZeroedVector<std::uint8_t>(std::numeric_limits<std::ptrdiff_t>::max() - 4 * kHugePage),
                 std::bad_alloc);
}

}  // namespace
}  // namespace spectralpack
