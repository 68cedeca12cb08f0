#pragma once
/// Values made before they are needed, by threads that would have nothing to do.

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/parallel.hpp"

namespace spectralpack {

template <class T>
class Ahead {
  public:
    /// Where there is one thread only, nobody makes it.
    Ahead(const Workers& workers, std::function<T()> make) : workers_(workers), state_(std::make_shared<State>()) {
        state_->make = std::move(make);
        workers_.spare([state = state_] { state->run(); });
    }

    /// Waits where the value is being made; where nobody has begun, nobody will.
    ~Ahead() {
        if (state_->begun.exchange(true)) state_->done.wait(false);
    }

    Ahead(const Ahead&) = delete;
    Ahead& operator=(const Ahead&) = delete;

    /// What has been made, once; while it is being made it does what else waits for a spare thread, and rethrows what
    /// making it threw. Nothing where nobody has begun, and nobody will.
    std::optional<T> take() {
        if (!state_->begun.exchange(true)) {
            state_->done = true;
            return std::nullopt;
        }
        while (!state_->done) {
            if (!workers_.run_spare()) state_->done.wait(false);
        }
        if (state_->error) std::rethrow_exception(state_->error);
        return std::exchange(state_->value, std::nullopt);
    }

  private:
    struct State {
        void run() {
            if (begun.exchange(true)) return;
            try {
                value = make();
            } catch (...) {
                error = std::current_exception();
            }
            done = true;
            done.notify_all();
        }

        std::function<T()> make;
        std::optional<T> value;
        std::exception_ptr error;
        std::atomic<bool> begun = false, done = false;
    };

    Workers workers_;
    std::shared_ptr<State> state_;  // with who makes it
};

}  // namespace spectralpack
