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
        draw("");
    } else {
        tell(what_);
    }
}

void RunDisplay::at(const PackProgress& progress) {
    if (!terminal_) return;
    std::string where = fmt::format("  {} {}/{}", progress.phase, progress.done, progress.total);
    if (progress.left && *progress.left > 0) where += fmt::format("  about {} left", duration_text(*progress.left));
    draw(where);
}

void RunDisplay::tell(const std::string& line) {
    clear();
    fmt::print(stderr, "{}\n", printable(line));
}

void RunDisplay::draw(const std::string& where) {
    fmt::print(stderr, "\r\033[K{}{}", printable(what_), where);
    std::fflush(stderr);
    drawn_ = true;
}

void RunDisplay::clear() {
    if (drawn_) fmt::print(stderr, "\r\033[K");
    drawn_ = false;
}

}  // namespace spectralpack::cli
