#pragma once
/// What bench says while it runs, on standard error: which run of how many, and where that is, as rows may take
/// minutes.

#include <optional>
#include <string>

#include "../status_line.hpp"

namespace spectralpack::cli {

/// A line of `pack --progress json`; others are none.
struct PackProgress {
    std::string phase;
    long long done = 0, total = 0;
    double seconds = 0;          ///< since the phase began
    std::optional<double> left;  ///< seconds
};
std::optional<PackProgress> parse_progress(const std::string& line);

/// On a terminal the run going on has a line of its own, which moves; else it is named as it begins.
class RunDisplay {
  public:
    explicit RunDisplay(int runs);

    void begins(const std::string& what);  ///< the next of the runs
    void passed() { ++run_; }              ///< the next had been run before
    void at(const PackProgress& progress);
    void tell(const std::string& line);

  private:
    int runs_;
    int run_ = 0;
    bool terminal_;
    std::string what_;
    StatusLine line_;
};

}  // namespace spectralpack::cli
