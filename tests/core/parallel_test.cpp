#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/ahead.hpp"
#include "core/stopped.hpp"
#include "support/eventually.hpp"

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
    workers.for_each_in_order(1000, [&](std::int64_t i) { ++visits[static_cast<std::size_t>(i)]; });
    workers.for_each_apart(1000, [&](std::int64_t i) { ++visits[static_cast<std::size_t>(i)]; });
    for (const auto& count : visits) {
        EXPECT_EQ(count, 4);
    }
}

TEST_P(ParallelLoops, InOrderBeginWhatComesBeforeFirst) {
    const Workers workers(GetParam());
    std::atomic<int> begun = 0;
    workers.for_each_in_order(1000, [&](std::int64_t i) {
        // Of those before it none is left but what other threads have just taken.
        EXPECT_GE(++begun, i + 2 - GetParam());
    });
    EXPECT_EQ(begun, 1000);
}

TEST_P(ParallelLoops, ApartEachShareIsTakenFromItsEnds) {
    const Workers workers(GetParam());
    for (const std::int64_t count : {0, 1, 3, 1000}) {
        std::vector<std::atomic<bool>> begun(static_cast<std::size_t>(count));
        const std::int64_t shares = std::min<std::int64_t>(GetParam(), count);
        workers.for_each_apart(count, [&](std::int64_t i) {
            begun[static_cast<std::size_t>(i)] = true;
            const auto not_begun = [&](std::int64_t from, std::int64_t to) {
                return std::count(begun.begin() + from, begun.begin() + to, false);
            };
            std::int64_t share = 0;
            while (count * (share + 1) / shares <= i)
                ++share;
            // On one side of it none is left but what other threads have just taken.
            EXPECT_LE(std::min(not_begun(count * share / shares, i), not_begun(i, count * (share + 1) / shares)),
                      GetParam() - 1);
        });
        EXPECT_EQ(std::count(begun.begin(), begun.end(), true), count);
    }
}

TEST_P(ParallelLoops, FirstIsTheLeastAndAllBeforeItAreTested) {
    const Workers workers(GetParam());
    for (const std::int64_t answer : {0, 1, 7, 499, 999, 1000}) {
        std::vector<std::atomic<int>> tested(1000);
        const std::int64_t first = workers.first(1000, [&](std::int64_t i) {
            ++tested[static_cast<std::size_t>(i)];
            return i >= answer && (i - answer) % 3 == 0;
        });
        EXPECT_EQ(first, answer);
        for (std::int64_t i = 0; i < 1000; ++i) {
            EXPECT_LE(tested[static_cast<std::size_t>(i)], 1);
            if (i <= answer) {
                EXPECT_EQ(tested[static_cast<std::size_t>(i)], 1) << i;
            }
        }
    }
    EXPECT_EQ(workers.first(0, [](std::int64_t) { return true; }), 0);
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
    workers.for_each_in_order(0, [](std::int64_t) { FAIL(); });
    workers.for_ranges(-1, 4, [](std::int64_t, std::int64_t) { FAIL(); });
}

TEST(Workers, DropWhatNoneHasBegunWhenTheyGo) {
    const auto held = std::make_shared<int>(0);
    for (int round = 0; round < 20; ++round) {
        const Workers workers(2);
        for (int i = 0; i < 100; ++i) {
            workers.spare([held] {});
        }
    }
    EXPECT_EQ(held.use_count(), 1);
}

TEST(Ahead, IsMadeWhileWhoWaitsForItDoesOtherSpareWork) {
    const Workers two(2);
    std::atomic<bool> begun = false, done = false;
    Ahead<bool> value(two, [&] {
        begun = true;
        return test::eventually([&] { return done.load(); });
    });
    ASSERT_TRUE(test::eventually([&] { return begun.load(); }));
    two.spare([&] { done = true; });  // the one spare thread is making the value
    EXPECT_EQ(value.take(), true);
    EXPECT_FALSE(two.run_spare());
}

TEST(Ahead, IsMadeByASpareThreadOrNotAtAll) {
    std::atomic<int> made = 0;
    const auto make = [&made] { return ++made; };
    Ahead<int> alone(Workers(1), make);
    EXPECT_EQ(alone.take(), std::nullopt);
    EXPECT_EQ(made, 0);
    const Workers two(2);
    Ahead<int> spare(two, make);
    ASSERT_TRUE(test::eventually([&] { return made == 1; }));
    EXPECT_EQ(spare.take(), 1);
}

TEST(Ahead, IsNeverMadeTwiceOrAfterItsEnd) {
    const Workers two(2);
    for (int i = 0; i < 1000; ++i) {
        auto made = std::make_unique<std::atomic<int>>(0);
        Ahead<int> value(two, [&made] { return ++*made; });
        if (i % 2 == 0) {
            const std::optional<int> taken = value.take();
            EXPECT_EQ(taken.value_or(0), *made);
        }
        // Whoever runs it after this would write where nothing is.
        {
            const Ahead<int> dropped(two, [&made] { return ++*made; });
        }
        EXPECT_LE(*made, 2);
        if (i % 2 == 1) value.take();
    }
}

TEST(Ahead, RethrowsWhatMakingThrew) {
    const Workers two(2);
    std::atomic<bool> begun = false;
    Ahead<int> value(two, [&begun]() -> int {
        begun = true;
        throw std::runtime_error("made");
    });
    ASSERT_TRUE(test::eventually([&] { return begun.load(); }));
    EXPECT_THROW(value.take(), std::runtime_error);
}

TEST_P(ParallelLoops, ThatMayStopDoSoBeforeTheNextTask) {
    StopSource stop;
    const Workers all(GetParam()), workers = all.stopping_with(stop.token());
    EXPECT_EQ(workers.threads(), GetParam());
    workers.check();
    std::atomic<int> begun = 0;
    const auto task = [&](std::int64_t) {
        ++begun;
        stop.request(StopReason::cancelled);
    };
    EXPECT_THROW(workers.for_each(100'000, task), Stopped);
    EXPECT_LE(begun, GetParam());
    EXPECT_THROW(workers.for_each_in_order(10, task), Stopped);
    EXPECT_THROW(workers.for_each_apart(10, task), Stopped);
    EXPECT_THROW(workers.for_ranges(10, 1, [&](std::int64_t, std::int64_t) { ++begun; }), Stopped);
    EXPECT_THROW(workers.alone().for_each(1, task), Stopped);
    EXPECT_THROW(workers.check(), Stopped);
    EXPECT_LE(begun, GetParam());
    all.for_each(10, task);  // which may not stop
    EXPECT_GE(begun, 10);
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelLoops, testing::Values(1, 2, 3));

}  // namespace
}  // namespace spectralpack
