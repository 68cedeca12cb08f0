#pragma once
/// Numbers in text, the same whatever the locale: a decimal point, never a comma.

#include <optional>
#include <string>
#include <string_view>

namespace spectralpack {

/// The whole of `text` as a number ("1", "+2.5", "-3e-2"); none for anything else. May be infinite
/// or NaN where the text says so ("nan", "1e999").
std::optional<double> parse_number(std::string_view text);

/// The whole of `text` as a decimal integer that fits; none for anything else.
std::optional<long long> parse_integer(std::string_view text);

/// At most `length` characters of `text`, in quotes, control and non-ASCII bytes as '?': for error
/// messages.
std::string quoted_excerpt(std::string_view text, std::size_t length = 40);

}  // namespace spectralpack
