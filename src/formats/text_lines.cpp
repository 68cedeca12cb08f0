#include "formats/text_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formats/number_text.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {

TextLines::TextLines(std::string_view text, StopToken stop) : text_(text), poll_(std::move(stop)) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
}

bool TextLines::next() {
    poll_.step();
    if (end_ >= text_.size()) return false;
    const std::size_t stop = std::min(text_.find_first_of("\r\n", end_), text_.size());
    line_ = text_.substr(end_, stop - end_);
    end_ = stop + (text_.substr(stop, 2) == "\r\n" ? 2 : stop < text_.size() ? 1 : 0);
    ++number_;
    return true;
}

double TextLines::coordinate(const std::string& file, std::string_view word) const {
    const auto value = parse_number(word);
    if (!value) {
        fail(file, quoted_excerpt(word) + " is not a number" +
                       (word.find(',') != std::string_view::npos ? " (decimals need a point, not a comma)" : ""));
    }
    if (!std::isfinite(*value)) fail(file, "coordinate " + quoted_excerpt(word) + " is not finite");
    return *value;
}

void TextLines::fail(const std::string& file, const std::string& cause) const { fail_at_line(file, number_, cause); }

void fail_at_line(const std::string& file, long long line, const std::string& cause) {
    throw InputError(file, "line " + std::to_string(line), cause);
}

void split_words(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; };
    for (auto at = line.begin();;) {
        at = std::find_if_not(at, line.end(), is_space);
        if (at == line.end()) return;
        const auto end = std::find_if(at, line.end(), is_space);
        words.emplace_back(at, end);
        at = end;
    }
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace spectralpack
