#pragma once
/// Turns Ctrl-C, SIGTERM, SIGHUP and a time limit into stop requests.

#include <signal.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// How a run spends a time limit: the ends of its parts, as shares of it.
struct TimeShares {
    double placing = 1;   ///< then what stands is made to come apart
    double planning = 1;  ///< then files are written
    double drawing = 1;   ///< then pictures are drawn plainly
    double drawn = 1;     ///< then those that are not done are left out
};

/// While it lives, signals ask the work to stop; only a third within one second ends the process. SIGHUP counts unless
/// it was ignored before (nohup). The end of who reads the output (SIGPIPE) does not end the work. One at a time.
///
/// There is no thread for it, which might not start: timers and handlers set the tokens, which is safe in them.
class Interrupts {
  public:
    using Clock = std::chrono::steady_clock;

    /// The limit counts from `start`.
    explicit Interrupts(std::optional<double> time_limit_seconds, const TimeShares& shares = {},
                        Clock::time_point start = Clock::now());
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    /// Ends all work but writing.
    StopToken token() const { return ends_[kPlanned].token(); }
    /// Ends placing; stops with token(), too.
    StopToken placed() const { return ends_[kPlaced].token(); }
    /// For what may take half of the time for placing; stops with placed(), too.
    StopToken half_placed() const { return ends_[kHalf].token(); }
    /// Ends what makes the packing better; stops with placed(), too.
    StopToken improved() const { return ends_[kImproved].token(); }
    /// It does so many seconds from now on.
    void improve_for(double seconds);
    /// For a try beforehand, which takes no longer than so many seconds from now on; stops with all others.
    StopSource& trial(double most_seconds);
    /// Signals do not end it.
    DrawingTime drawing() const { return {ends_[kHurry].token(), ends_[kDrawn].token()}; }

    /// From here on files are written: who ends the process cannot say that none was.
    void begin_writing() { writing_ = true; }

  private:
    enum End { kTrial, kHalf, kImproved, kPlaced, kPlanned, kHurry, kDrawn, kEnds };

    static void handle(int signal, siginfo_t* info, void*);
    void set_timer(End end, Clock::time_point when);
    void time_is_over(int end);
    void ask_to_stop();
    [[noreturn]] void stop_at_once() const;

    StopSource ends_[kEnds];
    std::vector<timer_t> timers_;
    std::vector<struct sigaction> before_;  // what the signals did
    std::atomic<bool> writing_{false};
    std::atomic<std::int64_t> last_{0}, last_but_one_{0};  // when signals came, ns
};

}  // namespace spectralpack::cli
