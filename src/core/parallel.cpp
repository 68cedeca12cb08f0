#include "core/parallel.hpp"

#include <sys/resource.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <future>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/stopped.hpp"
#ifdef SPECTRALPACK_TSAN
#include <sanitizer/tsan_interface.h>
#endif

namespace spectralpack {
namespace {

/// Tasks come after what their caller did before, and before what he does once he has waited for them. TBB sees to
/// that; ThreadSanitizer cannot see into TBB, so it is told here. Nothing in other builds.
class TaskOrder {
  public:
    TaskOrder() { release(); }
    ~TaskOrder() { acquire(); }
    TaskOrder(const TaskOrder&) = delete;
    TaskOrder& operator=(const TaskOrder&) = delete;

    template <class Task>
    void run(const Task& task) {
        acquire();
        task();
        release();
    }

#ifdef SPECTRALPACK_TSAN
    void acquire() { __tsan_acquire(this); }
    void release() { __tsan_release(this); }
#else
    void acquire() {}
    void release() {}
#endif
};

/// What is left of a thread's share of a loop: its own thread takes the first, others the last.
class alignas(64) Share {
  public:
    void set(std::int64_t begin, std::int64_t end) {
        begin_ = begin;
        end_ = end;
    }
    std::int64_t left() {
        const std::lock_guard lock(mutex_);
        return end_ - begin_;
    }
    std::optional<std::int64_t> take_first() {
        const std::lock_guard lock(mutex_);
        return begin_ < end_ ? std::optional(begin_++) : std::nullopt;
    }
    std::optional<std::int64_t> take_last() {
        const std::lock_guard lock(mutex_);
        return begin_ < end_ ? std::optional(--end_) : std::nullopt;
    }

  private:
    std::mutex mutex_;  // guards what follows
    std::int64_t begin_ = 0, end_ = 0;
};

/// Where addresses are limited (ulimit -v), the stacks of threads may take this share of them.
constexpr rlim_t kShareOfStacks = 4;
constexpr rlim_t kStack = 8 << 20;

/// Of so many threads, those that the system starts beside each other: where it starts fewer than TBB asks for, TBB
/// ends the program.
int threads_that_start(int wanted) {
    rlimit addresses{};
    if (getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY) {
        wanted = static_cast<int>(std::min(static_cast<rlim_t>(wanted), addresses.rlim_cur / kShareOfStacks / kStack));
    }
    std::promise<void> all_there;
    const std::shared_future<void> wait = all_there.get_future().share();
    std::vector<std::thread> started;
    try {
        while (static_cast<int>(started.size()) < wanted) {
            started.emplace_back([wait] { wait.wait(); });
        }
    } catch (const std::system_error&) {  // no more
    } catch (const std::bad_alloc&) {     // the same
    }
    all_there.set_value();
    for (std::thread& thread : started) {
        thread.join();
    }
    return static_cast<int>(started.size());
}

}  // namespace

struct Workers::Pool {
    explicit Pool(int threads)
        : wanted(threads > 0 ? threads : tbb::info::default_concurrency()),
          arena(1 + threads_that_start(wanted - 1)),
          spare(arena.max_concurrency(), 1, tbb::task_arena::priority::low) {
        if (arena.max_concurrency() < wanted || wanted > tbb::info::default_concurrency()) {
            allowed.emplace(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(arena.max_concurrency()));
        }
        arena.initialize();
    }

    /// What nobody has begun never will be.
    ~Pool() {
        if (arena.max_concurrency() == 1) return;
        spare.execute([&] {
            spare_tasks.cancel();
            spare_tasks.wait();
        });
        spare_order.acquire();
    }

    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// Runs the first task that waits. False where none does.
    bool run_next() {
        std::function<void()> task;
        {
            const std::lock_guard lock(mutex);
            if (waiting.empty()) return false;
            task = std::move(waiting.front());
            waiting.pop_front();
        }
        task();
        return true;
    }

    int wanted;
    // More threads than the machine has are asked for here: once another library has started TBB with as many as it
    // has, TBB would warn on standard error and give no more. And no more than start.
    std::optional<tbb::global_control> allowed;
    tbb::task_arena arena;
    tbb::task_arena spare;        // one place of it is for who asks
    tbb::task_group spare_tasks;  // each runs the first that waits, if somebody else has not yet
    TaskOrder spare_order;
    std::mutex mutex;  // guards what waits
    std::deque<std::function<void()> > waiting;
};

Workers::Workers(int threads) : pool_(std::make_shared<Pool>(threads)) {}

int Workers::threads() const { return pool_->arena.max_concurrency(); }

int Workers::missing() const { return pool_->wanted - threads(); }

Workers Workers::stopping_with(StopToken stop) const {
    Workers workers = *this;
    workers.stop_ = std::move(stop);
    return workers;
}

Workers Workers::alone() const { return Workers(1).stopping_with(stop_); }

void Workers::check() const { throw_if_stopped(stop_); }

void Workers::for_each(std::int64_t count, const std::function<void(std::int64_t)>& task) const {
    if (count <= 0) return;
    if (threads() == 1 || count == 1) {
        for (std::int64_t i = 0; i < count; ++i) {
            check();
            task(i);
        }
        return;
    }
    TaskOrder order;
    pool_->arena.execute([&] {
        tbb::parallel_for(std::int64_t{0}, count, [&](std::int64_t i) {
            order.run([&] {
                check();
                task(i);
            });
        });
    });
}

void Workers::for_each_in_order(std::int64_t count, const std::function<void(std::int64_t)>& task) const {
    std::atomic<std::int64_t> next = 0;
    for_each(std::min<std::int64_t>(threads(), count), [&](std::int64_t) {
        for (std::int64_t i = next++; i < count; i = next++) {
            check();
            task(i);
        }
    });
}

void Workers::for_each_apart(std::int64_t count, const std::function<void(std::int64_t)>& task) const {
    const std::int64_t threads = std::min<std::int64_t>(this->threads(), count);
    if (threads <= 0) return;
    std::vector<Share> shares(static_cast<std::size_t>(threads));
    for (std::int64_t k = 0; k < threads; ++k) {
        shares[static_cast<std::size_t>(k)].set(count * k / threads, count * (k + 1) / threads);
    }
    const auto take_from_largest = [&]() -> std::optional<std::int64_t> {
        for (;;) {
            Share* largest = nullptr;
            std::int64_t most = 0;
            for (Share& share : shares) {
                const std::int64_t left = share.left();
                if (left > most) largest = &share;
                most = std::max(most, left);
            }
            if (largest == nullptr) return std::nullopt;
            if (const auto i = largest->take_last()) return i;  // else somebody was quicker
        }
    };
    for_each(threads, [&](std::int64_t k) {
        while (const auto i = shares[static_cast<std::size_t>(k)].take_first()) {
            check();
            task(*i);
        }
        while (const auto i = take_from_largest()) {
            check();
            task(*i);
        }
    });
}

std::int64_t Workers::first(std::int64_t count, const std::function<bool(std::int64_t)>& test) const {
    std::atomic<std::int64_t> least = std::max<std::int64_t>(0, count);
    for_each_in_order(count, [&](std::int64_t i) {
        if (i < least && test(i)) lower(least, i);
    });
    return least;
}

void Workers::for_ranges(std::int64_t count, std::int64_t grain,
                         const std::function<void(std::int64_t, std::int64_t)>& task) const {
    if (count <= 0) return;
    if (threads() == 1 || count <= grain) {
        check();
        task(0, count);
        return;
    }
    using Range = tbb::blocked_range<std::int64_t>;
    TaskOrder order;
    pool_->arena.execute([&] {
        tbb::parallel_for(Range(0, count, static_cast<std::size_t>(std::max<std::int64_t>(1, grain))),
                          [&](const Range& range) {
                              order.run([&] {
                                  check();
                                  task(range.begin(), range.end());
                              });
                          });
    });
}

void Workers::spare(std::function<void()> task) const {
    if (threads() == 1) return;
    {
        const std::lock_guard lock(pool_->mutex);
        pool_->waiting.push_back(std::move(task));
    }
    pool_->spare.execute(
        [&] { pool_->spare_tasks.run([pool = pool_.get()] { pool->spare_order.run([pool] { pool->run_next(); }); }); });
}

bool Workers::run_spare() const { return pool_->run_next(); }

}  // namespace spectralpack
