#include "time_probe.hpp"

#include <chrono>

namespace spectralpack::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A few copies at least are wanted; for them the run may take this many times as long.
constexpr std::int64_t kEnoughCopies = 8;

/// Stops the run once it has searched for long enough; remembers how far it came.
class Probe : public Listener {
  public:
    Probe(double seconds, StopSource& stop) : seconds_(seconds), stop_(stop) {}

    void on_progress(const Progress& progress) override {
        if (progress.phase != Phase::search) return;
        last_ = {seconds_since(begin_), progress.work};
        if (progress.done == 0) start_ = last_;
        if (progress.done <= 1) first_ = last_;
        const double searching = last_.at - start_.at;
        if (searching > (progress.done < kEnoughCopies ? kProbePatience * seconds_ : seconds_)) {
            stop_.request(StopReason::time_limit);
        }
    }

    /// The first copy waits for the voxels of many, so it says nothing of how long the others take.
    ProbedTime time() const {
        if (last_.work == 1) return {last_.at, 1};
        if (last_.work == first_.work) return {seconds_since(begin_), 0};
        return {first_.at + (last_.at - first_.at) * (1 - first_.work) / (last_.work - first_.work), last_.work};
    }

  private:
    struct Point {
        double at = 0;    ///< seconds since the beginning
        double work = 0;  ///< 0..1
    };

    Clock::time_point begin_ = Clock::now();
    double seconds_;
    StopSource& stop_;
    Point start_, first_, last_;
};

}  // namespace

std::optional<ProbedTime> probe_time(const Job& job, double seconds, StopSource& stop) {
    Probe probe(seconds, stop);
    Job probed = job;
    probed.enough_orders.reset();
    probed.enough_placed.reset();
    probed.enough_improved.reset();
    probed.options.improve.reset();
    probed.options.improve_steps = 0;
    try {
        pack(probed, {&probe, stop.token()});
    } catch (const ResourceError&) {
        return std::nullopt;
    }
    return probe.time();
}

}  // namespace spectralpack::cli
