#pragma once
/// Asking a running computation to end early. The library only polls; whoever owns the clock or the signal
/// handler (the command line, a server) calls request(), which is safe in a signal handler.

#include <atomic>
#include <memory>

namespace spectralpack {

enum class StopReason : int { none = 0, cancelled = 1, time_limit = 2 };

class StopToken {
  public:
    StopToken() = default;  ///< never stops
    bool stopped() const { return reason() != StopReason::none; }
    StopReason reason() const {
        return state_ ? static_cast<StopReason>(state_->load(std::memory_order_relaxed)) : StopReason::none;
    }

  private:
    friend class StopSource;
    explicit StopToken(std::shared_ptr<std::atomic<int>> state) : state_(std::move(state)) {}
    std::shared_ptr<std::atomic<int>> state_;
};

class StopSource {
  public:
    StopSource() : state_(std::make_shared<std::atomic<int>>(0)) {}
    StopToken token() const { return StopToken(state_); }

    /// The first reason given stays.
    void request(StopReason reason) {
        int none = 0;
        state_->compare_exchange_strong(none, static_cast<int>(reason));
    }

  private:
    std::shared_ptr<std::atomic<int>> state_;
};

}  // namespace spectralpack
