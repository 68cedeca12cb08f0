#include "progress_display.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "summary_texts.hpp"
#include "tell.hpp"
#include "text.hpp"
#include "unusable_files.hpp"

namespace spectralpack::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenFrames{100};
constexpr int kBarWidth = 28;

/// For people; programs are told the phase's own word.
const char* doing(Phase phase) {
    switch (phase) {
        case Phase::load:
            return "reading";
        case Phase::voxelize:
            return "preparing";
        case Phase::search:
            return "placing";
        case Phase::disassemble:
            return "taking apart";
        case Phase::reinsert:
            return "putting back";
        case Phase::check:
            return "checking";
        case Phase::render:
            return "drawing";
        case Phase::write:
            return "writing";
        case Phase::improve:
            return "improving";
    }
    return "";
}

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

void ProgressDisplay::limit_improvement(double seconds) {
    improving_since_ = Clock::now();
    improving_until_ =
        improving_since_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

ProgressDisplay::ProgressDisplay(ProgressStyle style) : style_(style) {
    if (style == ProgressStyle::automatic) {
        style_ = isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::none;
    }
}

void ProgressDisplay::on_progress(const Progress& progress) {
    if (style_ == ProgressStyle::none) return;
    const auto now = Clock::now();
    if (progress.phase != phase_) last_ = {};
    phase_ = progress.phase;
    Run& run = runs_.try_emplace(progress.phase, Run{now}).first->second;
    if (progress.work < run.work) run.start = now;  // begun anew
    run.work = progress.work;
    const bool last = progress.done == progress.total;
    if (!last && now - last_ < kBetweenFrames) return;
    last_ = now;
    const double elapsed = std::chrono::duration<double>(now - run.start).count();
    // Of work spread as it was so far; -1 while there is too little to tell.
    const double left = progress.improved && improving_until_   ? std::max(0.0, seconds_between(now, *improving_until_))
                        : progress.work > 0.01 && elapsed > 0.5 ? elapsed * (1 - progress.work) / progress.work
                        : last                                  ? 0
                                                                : -1;
    if (style_ == ProgressStyle::json) {
        const std::string orders =
            progress.orders > 0 ? fmt::format(R"(, "order": {}, "orders": {})", progress.order, progress.orders) : "";
        const std::string improved = progress.improved ? fmt::format(R"(, "what": "{}", "before": {}, "now": {})",
                                                                     to_string(progress.improved->what),
                                                                     progress.improved->before, progress.improved->now)
                                                       : "";
        const std::string verified = progress.verified > 0 ? fmt::format(R"(, "verified": {})", progress.verified) : "";
        tell(R"({{"phase": "{}", "done": {}, "total": {}, "density": {}, "seconds": {:.3f}, "left": {}{}{}}})"
             "\n",
             to_string(progress.phase), progress.done, progress.total,
             progress.density ? fmt::format("{}", *progress.density) : "null", elapsed,
             left < 0 ? "null" : fmt::format("{:.3f}", left), verified, orders + improved);
    } else {
        draw(progress, left);
    }
}

void ProgressDisplay::on_event(const Event& event) {
    if (style_ != ProgressStyle::json) return;
    std::string copy;
    if (event.part >= 0) {
        std::string rows;
        for (int row = 0; row < 3; ++row) {
            const Vec3& linear = event.transform.linear.rows[row];
            rows += fmt::format("[{}, {}, {}, {}], ", linear.x, linear.y, linear.z, event.transform.translation[row]);
        }
        copy = fmt::format(R"(, "part": {}, "copy": {}, "orientation": {}, "transform": [{}[0, 0, 0, 1]])", event.part,
                           event.copy, event.orientation, rows);
    }
    tell("{{\"event\": \"{}\", \"tray\": {}{}}}\n", to_string(event.kind), event.tray + 1, copy);
}

void ProgressDisplay::draw(const Progress& progress, double left) {
    double work = progress.work;
    if (progress.improved && improving_until_ && left >= 0) {
        const double all = seconds_between(improving_since_, *improving_until_);
        work = all > 0 ? std::clamp(1 - left / all, 0.0, 1.0) : 1;
    }
    const int filled = static_cast<int>(work * kBarWidth);
    std::string bar(static_cast<std::size_t>(filled), '#');
    bar.resize(kBarWidth, '.');
    std::string line = fmt::format(
        "{:<12} [{}] {}", doing(progress.phase), bar,
        progress.improved ? progress_text(*progress.improved) : fmt::format("{}/{}", progress.done, progress.total));
    if (progress.phase == Phase::search && progress.density) {
        line += fmt::format("  {} filled", percent_text(*progress.density));
    }
    if (progress.verified > 0) line += fmt::format("  {} compared", progress.verified);
    if (progress.orders > 0) line += fmt::format("  order {} of {}", progress.order, progress.orders);
    if (left > 0) line += fmt::format("  about {} left", duration_text(left));
    line_.draw(line);
}

void ProgressDisplay::end() {
    finish();
    if (told_) tell("\n");
    told_ = false;
}

void ProgressDisplay::on_unusable(const std::vector<InputError>& errors) {
    finish();
    if (errors.empty()) return;
    if (style_ == ProgressStyle::json) {
        for (const InputError& error : errors) {
            on_error(error.what());
        }
        return;
    }
    if (told_) tell("\n");
    for (const std::string& line : unusable_lines(errors)) {
        tell("{}\n", line);
    }
    told_ = true;
}

void ProgressDisplay::on_warning(const std::string& message) {
    finish();
    if (style_ == ProgressStyle::json) {
        tell("{{\"warning\": {}}}\n", json_string(message));
    } else {
        const char* end = message.ends_with('?') || message.ends_with('.') ? "" : ".";
        tell("{}\n", wrapped(fmt::format("Remark: {}{}", printable(message), end), kScreenWidth));
        told_ = true;
    }
}

void ProgressDisplay::on_error(const std::string& message) {
    finish();
    if (style_ == ProgressStyle::json) {
        tell("{{\"error\": {}}}\n", json_string(message));
    } else {
        tell("spectralpack: {}\n", printable(message));
        told_ = true;
    }
}

}  // namespace spectralpack::cli
