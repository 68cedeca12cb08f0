#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace spectralpack {
namespace {

class ParallelLoops : public testing::TestWithParam<int> {};

TEST_P(ParallelLoops, VisitEachIndexOnce) {
    const Workers workers(GetParam());
    EXPECT_EQ(workers.threads(), GetParam());
    std::vector<std::atomic<int>> visits(1000);
    workers.for_each(1000, [&](std::int64_t i) { ++visits[static_cast<std::size_t>(i)]; });
    workers.for_ranges(1000, 7, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            ++visits[static_cast<std::size_t>(i)];
        }
    });
    for (const auto& count : visits) {
        EXPECT_EQ(count, 2);
    }
}

TEST_P(ParallelLoops, MayBeNested) {
    const Workers workers(GetParam());
    std::atomic<int> sum = 0;
    workers.for_each(10,
                     [&](std::int64_t) { workers.for_each(10, [&](std::int64_t j) { sum += static_cast<int>(j); }); });
    EXPECT_EQ(sum, 450);
}

TEST_P(ParallelLoops, RethrowWhatATaskThrows) {
    const Workers workers(GetParam());
    EXPECT_THROW(workers.for_each(100,
                                  [](std::int64_t i) {
                                      if (i == 50) throw std::runtime_error("task");
                                  }),
                 std::runtime_error);
}

TEST_P(ParallelLoops, OfNothingDoNothing) {
    const Workers workers(GetParam());
    workers.for_each(0, [](std::int64_t) { FAIL(); });
    workers.for_ranges(-1, 4, [](std::int64_t, std::int64_t) { FAIL(); });
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelLoops, testing::Values(1, 2, 3));

}  // namespace
}  // namespace spectralpack
