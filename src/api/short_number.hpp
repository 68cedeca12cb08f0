#pragma once
/// Numbers in messages.

#include <cstdio>
#include <string>

namespace spectralpack {

/// Six digits, and no more than are needed: 0.2, 480, 1e+08.
inline std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

}  // namespace spectralpack
