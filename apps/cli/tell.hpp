#pragma once
/// What is said on standard error.

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace spectralpack::cli {

/// Formats as fmt::print does. That nobody can read it any more does not end the work.
template <class... Args>
void tell(fmt::format_string<Args...> format, Args&&... args) {
    const std::string text = fmt::format(format, std::forward<Args>(args)...);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace spectralpack::cli
