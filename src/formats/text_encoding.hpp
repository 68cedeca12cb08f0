#pragma once
/// Codes of text: UTF-8, and Windows-1252, in which spreadsheets of Western Europe write.

#include <string>
#include <string_view>

namespace spectralpack {

bool is_utf8(std::string_view text);

/// Windows-1252 as UTF-8. The five bytes that it leaves open become the control characters of Latin-1.
std::string from_windows_1252(std::string_view text);

}  // namespace spectralpack
