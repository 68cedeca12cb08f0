#pragma once
/// The layout of summaries: a verdict, then labelled lines of at most 80 columns.

#include <string>
#include <vector>

#include "text.hpp"

namespace spectralpack::cli {

inline constexpr std::size_t kScreenLines = 22;  ///< at most, as far as can be: the command stays in sight
inline constexpr std::size_t kLabelWidth = 11;
inline constexpr std::size_t kValueWidth = kScreenWidth - 4 - 2 - kLabelWidth;  ///< a little short of the edge

class SummaryLines {
  public:
    /// A sentence by itself.
    void sentence(const std::string& text);
    void blank() { lines_.emplace_back(); }
    /// As it is, for tables.
    void row(const std::string& text) { lines_.push_back(text); }
    /// `label`, and beside it each of `paragraphs` on lines of its own. Nothing where there are none.
    void labelled(const std::string& label, const std::vector<std::string>& paragraphs);
    void labelled(const std::string& label, const std::string& text);

    std::size_t count() const { return lines_.size(); }
    std::string text() const;

  private:
    std::vector<std::string> lines_;
};

}  // namespace spectralpack::cli
