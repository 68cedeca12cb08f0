#pragma once
/// How long work that answers nothing yet is left half done.

#include <cstdint>
#include <exception>
#include <utility>

#include "spectralpack/stop.hpp"

namespace spectralpack {

/// Thrown by who sees in the midst of such work that the stop token was requested. Never leaves the library: whoever
/// began the work takes it for not begun.
class Stopped : public std::exception {
  public:
    const char* what() const noexcept override { return "stopped"; }
};

/// Costs next to nothing.
inline void throw_if_stopped(const StopToken& stop) {
    if (stop.stopped()) throw Stopped();
}

/// For loops whose steps take less than looking: looks once in some thousand steps.
class StopPoll {
  public:
    explicit StopPoll(StopToken stop) : stop_(std::move(stop)) {}

    void step() {
        if (++steps_ % kSteps == 0) throw_if_stopped(stop_);
    }

  private:
    static constexpr std::uint32_t kSteps = 4096;

    StopToken stop_;
    std::uint32_t steps_ = 0;
};

}  // namespace spectralpack
