#include "run_display.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "../text.hpp"

namespace spectralpack::cli {

std::optional<PackProgress> parse_progress(const std::string& line) {
    PackProgress progress;
    char phase[16];
    double left = 0;
    const int read = std::sscanf(
        line.c_str(),
        R"({"phase": "%15[a-z]", "done": %lld, "total": %lld, "density": %*[^,], "seconds": %lf, "left": %lf)", phase,
        &progress.done, &progress.total, &progress.seconds, &left);
    if (read < 4) return std::nullopt;
    progress.phase = phase;
    if (read == 5) progress.left = left;  // else it is null
    return progress;
}

RunDisplay::RunDisplay(int runs) : runs_(runs), terminal_(isatty(STDERR_FILENO) != 0) {}

void RunDisplay::begins(const std::string& what) {
    ++run_;
    what_ = fmt::format("run {} of {}: {}", run_, runs_, what);
    if (terminal_) {
        line_.draw(printable(what_));
    } else {
        tell(what_);
    }
}

void RunDisplay::at(const PackProgress& progress) {
    if (!terminal_) return;
    std::string line = fmt::format("{}  {} {}/{}", printable(what_), progress.phase, progress.done, progress.total);
    if (progress.left && *progress.left > 0) line += fmt::format("  about {} left", duration_text(*progress.left));
    line_.draw(line);
}

void RunDisplay::tell(const std::string& line) {
    line_.clear();
    fmt::print(stderr, "{}\n", printable(line));
}

}  // namespace spectralpack::cli
