#include "interrupts.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>

#include "exit_status.hpp"

namespace spectralpack::cli {
namespace {

constexpr std::chrono::milliseconds kPoll{50};

sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

}  // namespace

Interrupts::Interrupts(std::optional<double> time_limit_seconds) {
    if (time_limit_seconds) {
        const double seconds = std::min(*time_limit_seconds, 1e9);
        const std::chrono::milliseconds limit(static_cast<std::int64_t>(1000 * seconds));
        deadline_ = std::chrono::steady_clock::now() + limit;
        half_time_ = *deadline_ - limit / 2;
    }
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    thread_ = std::thread([this] { wait(); });
}

Interrupts::~Interrupts() {
    done_ = true;
    thread_.join();
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void Interrupts::request(StopReason reason) {
    source_.request(reason);
    half_.request(reason);
}

void Interrupts::stop_at_once() const {
    fmt::print(stderr, "\nStopped at once.{}\n", writing_ ? "" : " Nothing was written.");
    _exit(kInterrupted);
}

void Interrupts::wait() {
    const sigset_t set = watched_signals();
    bool asked = false;
    while (!done_) {
        const auto now = std::chrono::steady_clock::now();
        auto pause = std::chrono::duration_cast<std::chrono::nanoseconds>(kPoll);
        if (half_time_ && now >= *half_time_) {
            half_.request(StopReason::time_limit);
            half_time_.reset();
        }
        if (deadline_) {
            if (now >= *deadline_) {
                request(StopReason::time_limit);
                deadline_.reset();
            } else {
                pause = std::min(pause, std::chrono::duration_cast<std::chrono::nanoseconds>(*deadline_ - now));
            }
        }
        const timespec timeout{0, static_cast<long>(pause.count())};
        if (sigtimedwait(&set, nullptr, &timeout) > 0) {
            if (asked) stop_at_once();
            asked = true;
            request(StopReason::cancelled);
        }
    }
}

}  // namespace spectralpack::cli
