#include "bench_display.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "tell.hpp"
#include "text.hpp"

namespace spectralpack::cli {

BenchDisplay::BenchDisplay() : terminal_(isatty(STDERR_FILENO) != 0) {}

void BenchDisplay::on_run(const tools::BenchRun& run) {
    run_ = fmt::format("run {} of {}: {}", run.number, run.runs, run.what);
    if (terminal_) {
        line_.draw(printable(run_));
    } else {
        tell(run_);
    }
}

void BenchDisplay::on_progress(const tools::BenchProgress& progress) {
    if (!terminal_) return;
    std::string line = fmt::format("{}  {} {}/{}", printable(run_), progress.phase, progress.done, progress.total);
    if (progress.left && *progress.left > 0) line += fmt::format("  about {} left", duration_text(*progress.left));
    line_.draw(line);
}

void BenchDisplay::on_done(const tools::BenchDone& done) {
    tell(fmt::format("{:>7.1f} s{}  {}", done.seconds, done.cut_off ? ", cut off" : "", done.command));
}

void BenchDisplay::on_failure(const std::string& why) { tell(why); }

void BenchDisplay::on_table(const std::string& markdown) { fmt::print("{}\n", markdown); }

void BenchDisplay::tell(const std::string& line) {
    line_.clear();
    cli::tell("{}\n", printable(line));
}

}  // namespace spectralpack::cli
