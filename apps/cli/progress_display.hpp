#pragma once
/// Progress and warnings on standard error: a bar for people, lines of JSON for programs, or nothing.

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

#include "status_line.hpp"

namespace spectralpack::cli {

/// automatic: a bar where standard error is a terminal, else nothing.
class ProgressDisplay : public Listener {
  public:
    explicit ProgressDisplay(ProgressStyle style);

    /// Lines of JSON only.
    void on_event(const Event& event) override;
    void on_progress(const Progress& progress) override;
    void on_warning(const std::string& message) override;

    /// Something that went wrong; the run goes on with the rest.
    void on_error(const std::string& message);

    /// Files that cannot be used, in one list; the run goes on with the rest.
    void on_unusable(const std::vector<InputError>& errors);

    /// Ends the bar's line, and sets off what was told from the result that follows.
    void end();

    /// Phase::improve, which begins, ends so many seconds from now.
    void limit_improvement(double seconds);

    /// Ends the bar's line, so that other output starts on a fresh one.
    void finish() { line_.clear(); }

  private:
    using Clock = std::chrono::steady_clock;

    void draw(const Progress& progress, double left);

    ProgressStyle style_;
    /// Since when the work of a phase has been going on, other phases in between included: each tray is searched, then
    /// taken apart, and the search's work goes on with the next.
    struct Run {
        Clock::time_point start;
        double work = 0;
    };

    std::map<Phase, Run> runs_;
    std::optional<Phase> phase_;
    Clock::time_point last_ = {};
    Clock::time_point improving_since_ = {};
    std::optional<Clock::time_point> improving_until_;  // none: nobody said
    StatusLine line_;
    bool told_ = false;  ///< a remark or an error, to people
};

}  // namespace spectralpack::cli
