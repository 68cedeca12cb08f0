#include "summary_lines.hpp"

#include <fmt/format.h>

#include <sstream>

namespace spectralpack::cli {
namespace {

std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
    std::vector<std::string> lines;
    std::istringstream rest(wrapped(text, width));
    for (std::string line; std::getline(rest, line);) {
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

void SummaryLines::sentence(const std::string& text) {
    for (const std::string& line : lines_of(text, kScreenWidth)) {
        lines_.push_back(line);
    }
}

void SummaryLines::labelled(const std::string& label, const std::vector<std::string>& paragraphs) {
    std::string left = label;
    for (const std::string& paragraph : paragraphs) {
        for (const std::string& line : lines_of(paragraph, kValueWidth)) {
            lines_.push_back(fmt::format("  {:<{}}{}", left, kLabelWidth, line));
            left.clear();
        }
    }
}

void SummaryLines::labelled(const std::string& label, const std::string& text) {
    labelled(label, std::vector<std::string>{text});
}

std::string SummaryLines::text() const {
    std::string text;
    for (const std::string& line : lines_) {
        text += line + "\n";
    }
    return text;
}

}  // namespace spectralpack::cli
