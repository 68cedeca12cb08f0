#pragma once
/// The last line of a terminal, written over and over, on standard error.

#include <string>

namespace spectralpack::cli {

class StatusLine {
  public:
    StatusLine() = default;
    ~StatusLine() { clear(); }
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    void draw(const std::string& line);
    /// Empties it where something was drawn, so that other output starts on a fresh line.
    void clear();

  private:
    bool drawn_ = false;
};

}  // namespace spectralpack::cli
