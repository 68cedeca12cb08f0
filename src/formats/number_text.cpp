#include "formats/number_text.hpp"

#include <fast_float/fast_float.h>

#include <charconv>

namespace spectralpack {
namespace {

/// from_chars knows no plus sign; one may stand before a digit or a point.
std::string_view without_plus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    return plus ? text.substr(1) : text;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    text = without_plus(text);
    const char* end = text.data() + text.size();
    double value = 0;
    const auto parsed = fast_float::from_chars(text.data(), end, value);
    if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
    return value;
}

std::optional<long long> parse_integer(std::string_view text) {
    text = without_plus(text);
    const char* end = text.data() + text.size();
    long long value = 0;
    const auto parsed = std::from_chars(text.data(), end, value);
    if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
    return value;
}

std::string quoted_excerpt(std::string_view text, std::size_t length) {
    std::string excerpt = "'";
    for (const char c : text.substr(0, length)) {
        excerpt += c >= ' ' && c <= '~' ? c : '?';
    }
    return excerpt + (text.size() > length ? "...'" : "'");
}

}  // namespace spectralpack
