#include "interrupts.hpp"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <thread>

#include "exit_status.hpp"

namespace spectralpack::cli {
namespace {

constexpr std::chrono::nanoseconds kThriceWithin = std::chrono::seconds(1);
constexpr double kMostSeconds = 1e9;
/// Not SIGALRM, which others use for limits of their own. Not before main(): SIGRTMIN is a call.
int timer_signal() { return SIGRTMIN; }

constexpr std::array kStopSignals{SIGINT, SIGTERM, SIGHUP};

// A handler is given nothing: these lead it to who listens, and tell him who is at it.
std::atomic<Interrupts*> listening{nullptr};
std::atomic<int> handling{0};

std::int64_t nanoseconds_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void say(std::string_view text) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Interrupts::Interrupts(std::optional<double> time_limit_seconds, const TimeShares& shares, Clock::time_point start) {
    listening = this;
    struct sigaction action {};
    action.sa_sigaction = handle;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigemptyset(&action.sa_mask);
    const auto take = [&](int signal, const struct sigaction& wanted) {
        sigaction(signal, &wanted, &before_.emplace_back());
    };
    for (const int signal : kStopSignals) {
        take(signal, action);
    }
    if (before_[2].sa_handler == SIG_IGN) sigaction(SIGHUP, &before_[2], nullptr);
    take(timer_signal(), action);
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    take(SIGPIPE, ignore);
    if (!time_limit_seconds) return;
    const double limit = std::min(*time_limit_seconds, kMostSeconds);
    const auto at = [&](double share) {
        return start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(share * limit));
    };
    set_timer(kHalf, at(shares.placing / 2));
    set_timer(kPlaced, at(shares.placing));
    set_timer(kPlanned, at(shares.planning));
    set_timer(kHurry, at(shares.drawing));
    set_timer(kDrawn, at(shares.drawn));
}

Interrupts::~Interrupts() {
    for (timer_t& timer : timers_) {
        timer_delete(timer);
    }
    std::size_t i = 0;
    for (const int signal : {kStopSignals[0], kStopSignals[1], kStopSignals[2], timer_signal(), SIGPIPE}) {
        if (signal != timer_signal()) sigaction(signal, &before_[i], nullptr);  // one may be on its way still
        ++i;
    }
    listening = nullptr;
    while (handling > 0) {
        std::this_thread::yield();
    }
}

StopSource& Interrupts::trial(double most_seconds) {
    set_timer(kTrial, Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                         std::chrono::duration<double>(std::min(most_seconds, kMostSeconds))));
    return ends_[kTrial];
}

void Interrupts::improve_for(double seconds) {
    set_timer(kImproved, Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                            std::chrono::duration<double>(std::min(seconds, kMostSeconds))));
}

/// `when` may be over.
void Interrupts::set_timer(End end, Clock::time_point when) {
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(when - Clock::now()).count();
    if (left <= 0) return time_is_over(end);
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = timer_signal();
    event.sigev_value.sival_int = end;
    timer_t timer{};
    if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0) {
        throw ResourceError("the time limit cannot be kept: the system has no timer left");
    }
    timers_.push_back(timer);
    const itimerspec once{{0, 0}, {static_cast<time_t>(left / 1'000'000'000), static_cast<long>(left % 1'000'000'000)}};
    timer_settime(timer, 0, &once, nullptr);
}

void Interrupts::handle(int signal, siginfo_t* info, void*) {
    const int error = errno;
    ++handling;
    if (Interrupts* interrupts = listening) {
        if (signal != timer_signal()) {
            interrupts->ask_to_stop();
        } else if (info->si_code == SI_TIMER) {
            interrupts->time_is_over(info->si_value.sival_int);
        }
    }
    --handling;
    errno = error;
}

/// What ends early ends no later than what follows.
void Interrupts::time_is_over(int end) {
    for (int earlier = kTrial; earlier <= end; ++earlier) {
        ends_[earlier].request(StopReason::time_limit);
    }
}

void Interrupts::ask_to_stop() {
    for (int end = kTrial; end <= kPlanned; ++end) {
        ends_[end].request(StopReason::cancelled);
    }
    const std::int64_t now = nanoseconds_now();
    const std::int64_t last = last_.exchange(now), last_but_one = last_but_one_.exchange(last);
    if (last_but_one > 0 && now - last_but_one < kThriceWithin.count()) stop_at_once();
}

void Interrupts::stop_at_once() const {
    say("\nStopped at once.");
    say(writing_ ? "\n" : " Nothing was written.\n");
    _exit(kInterrupted);
}

}  // namespace spectralpack::cli
