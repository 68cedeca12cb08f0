#include "status_line.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "tell.hpp"

namespace spectralpack::cli {
namespace {

constexpr const char* kEmptyLine = "\r\033[K";

}  // namespace

void StatusLine::draw(const std::string& line) {
    tell("{}{}", kEmptyLine, line);
    std::fflush(stderr);
    drawn_ = true;
}

void StatusLine::clear() {
    if (drawn_) tell("{}", kEmptyLine);
    drawn_ = false;
}

}  // namespace spectralpack::cli
