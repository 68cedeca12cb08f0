#pragma once
/// Text inside XML.

#include <string>
#include <string_view>

namespace spectralpack {

/// `text` as it stands in a quoted attribute: markup and line ends as references; bytes that are
/// not UTF-8 and characters that XML cannot hold become U+FFFD.
std::string xml_attribute(std::string_view text);

}  // namespace spectralpack
