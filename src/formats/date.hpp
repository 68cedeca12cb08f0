#pragma once
/// Calendar dates as files have them.

#include <string_view>

namespace spectralpack {

/// "2026-12-01", and there is such a day. Dates of this form sort as text.
bool is_date(std::string_view text);

}  // namespace spectralpack
