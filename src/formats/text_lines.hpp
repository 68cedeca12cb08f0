#pragma once
/// Reading text formats line by line, with errors that name the line.

#include <string>
#include <string_view>
#include <vector>

#include "core/stopped.hpp"

namespace spectralpack {

/// The lines of a text; LF, CRLF or CR ends one. A byte-order mark at the start is skipped.
class TextLines {
  public:
    explicit TextLines(std::string_view text, StopToken stop = {});

    /// Moves to the next line; false at the end. Throws Stopped once `stop` is requested.
    bool next();
    std::string_view line() const { return line_; }
    int number() const { return number_; }  ///< 1-based
    /// What follows the current line.
    std::string_view rest() const { return text_.substr(end_); }

    /// `word` as a coordinate. Throws InputError naming the line for what is not a finite number.
    double coordinate(const std::string& file, std::string_view word) const;

    [[noreturn]] void fail(const std::string& file, const std::string& cause) const;

  private:
    std::string_view text_;
    StopPoll poll_;
    std::size_t end_ = 0;  ///< of the current line and its line end
    std::string_view line_;
    int number_ = 0;
};

[[noreturn]] void fail_at_line(const std::string& file, long long line, const std::string& cause);

/// The words of a line, separated by spaces and tabs.
void split_words(std::string_view line, std::vector<std::string_view>& words);

/// ASCII letters only.
bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace spectralpack
