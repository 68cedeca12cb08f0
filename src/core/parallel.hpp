#pragma once
/// Parallel loops. Results must not depend on the number of threads: tasks write to places of their own.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

#include "spectralpack/stop.hpp"

namespace spectralpack {

/// A pool of worker threads; copies share it. Loops may be nested.
class Workers {
  public:
    /// `threads` <= 0: as many as the machine has. Where the system starts fewer, there are fewer.
    explicit Workers(int threads = 0);

    int threads() const;
    /// Threads that were asked for and could not be started.
    int missing() const;

    /// The same threads for work that may be given up: check() throws Stopped once `stop` is requested, and so do all
    /// loops before they begin another task.
    Workers stopping_with(StopToken stop) const;
    const StopToken& stop() const { return stop_; }
    /// This thread alone, with the same stop token.
    Workers alone() const;
    /// In the midst of long tasks, ten times a second at least. Costs next to nothing.
    void check() const;

    /// Calls task(i) once for each i in [0, count), in any order, and returns when all are done. An exception
    /// from a task ends the loop and is rethrown here.
    void for_each(std::int64_t count, const std::function<void(std::int64_t)>& task) const;

    /// The same, each i begun before those after it: where what is known by then spares the rest work.
    void for_each_in_order(std::int64_t count, const std::function<void(std::int64_t)>& task) const;

    /// The same in any order, for tasks that read what those next to them read: each thread goes through a share of its
    /// own, and then takes the last of the largest that is left, so that no two ask for the same lines of memory.
    void for_each_apart(std::int64_t count, const std::function<void(std::int64_t)>& task) const;

    /// The first i in [0, count) of which test(i) is true; count where there is none. All before it are tested; of
    /// those after it some, where threads are ahead, with no effect on the answer.
    std::int64_t first(std::int64_t count, const std::function<bool(std::int64_t)>& test) const;

    /// Splits [0, count) into ranges of at least `grain` and calls task(begin, end) for each.
    void for_ranges(std::int64_t count, std::int64_t grain,
                    const std::function<void(std::int64_t, std::int64_t)>& task) const;

    /// Has a thread that no loop needs run `task` some time, which must not throw; what none has begun when the last of
    /// these workers goes is dropped. Where there is one thread only, nobody does.
    void spare(std::function<void()> task) const;

    /// Runs one of the tasks that wait for a spare thread here and now, the first of them: for who would have to wait
    /// for such a thread. False where none waits.
    bool run_spare() const;

  private:
    struct Pool;
    std::shared_ptr<Pool> pool_;
    StopToken stop_;  // never stops, but for those of stopping_with()
};

/// `least` becomes `value` where that is less, whoever else lowers it meanwhile.
template <class T>
void lower(std::atomic<T>& least, T value) {
    T known = least;
    while (value < known && !least.compare_exchange_weak(known, value)) {
    }
}

}  // namespace spectralpack
