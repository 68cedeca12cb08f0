#pragma once
/// Fields of CSV files.

#include <string>

namespace spectralpack::tools {

/// `text` as a field of a row, quoted whether it need be or not (unlike csv_field): runs are known again by their set
/// file's bytes.
inline std::string quoted(const std::string& text) {
    std::string inner;
    for (const char c : text) {
        inner += c == '"' ? "\"\"" : std::string(1, c);
    }
    return '"' + inner + '"';
}

}  // namespace spectralpack::tools
