#pragma once
/// Turns Ctrl-C, SIGTERM and a time limit into a stop request.

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// While it lives, a thread waits for SIGINT and SIGTERM (blocked in the whole process, so make it before any
/// other thread) and for the time limit. The first signal asks the work to stop; the second ends the process.
class Interrupts {
  public:
    explicit Interrupts(std::optional<double> time_limit_seconds);
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    StopToken token() const { return source_.token(); }

    /// From here on files are written: the second signal cannot say that none was.
    void begin_writing() { writing_ = true; }

    /// For what may take half of the time limit; stops with token(), too.
    StopToken half_time() const { return half_.token(); }

  private:
    void wait();
    [[noreturn]] void stop_at_once() const;
    void request(StopReason reason);

    StopSource source_, half_;
    std::optional<std::chrono::steady_clock::time_point> deadline_, half_time_;
    std::atomic<bool> done_{false}, writing_{false};
    std::thread thread_;
};

}  // namespace spectralpack::cli
