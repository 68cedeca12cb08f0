#include "status_line.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace spectralpack::cli {
namespace {

constexpr const char* kEmptyLine = "\r\033[K";

}  // namespace

void StatusLine::draw(const std::string& line) {
    fmt::print(stderr, "{}{}", kEmptyLine, line);
    std::fflush(stderr);
    drawn_ = true;
}

void StatusLine::clear() {
    if (drawn_) fmt::print(stderr, "{}", kEmptyLine);
    drawn_ = false;
}

}  // namespace spectralpack::cli
