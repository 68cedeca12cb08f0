#pragma once
/// How long something takes, for the record: nothing that is decided depends on it.

#include <chrono>

namespace spectralpack {

/// Runs from when it is made.
class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace spectralpack
