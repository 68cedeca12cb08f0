#pragma once
/// Pieces of HTML that is well-formed XML, and numbers in words of the sheet.

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

namespace spectralpack {

/// Text that comes from files, as it stands in the page; see xml_attribute().
std::string escaped(const std::string& text);

std::string base64(const std::string& bytes);

/// Of PNG bytes: the value of src or href.
std::string picture_link(const std::string& png);

/// "31.2" and a unit after a narrow space that does not break.
std::string with_unit(double value, int decimals, const char* unit);

/// "4 Dec" of "2026-12-04"; anything else as it is.
std::string day_of(const std::string& date);

/// "1 step", "2 steps".
std::string counted(std::size_t count, const char* one);

class Html {
  public:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace spectralpack
