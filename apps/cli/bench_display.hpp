#pragma once
/// What bench says while it runs: on standard error which run of how many, and where that is, as rows may take minutes;
/// on standard output the tables.

#include <string>

#include <spectralpack/tools/bench.hpp>

#include "status_line.hpp"

namespace spectralpack::cli {

/// On a terminal the run going on has a line of its own, which moves; else it is named as it begins.
class BenchDisplay : public tools::BenchListener {
  public:
    BenchDisplay();

    void on_run(const tools::BenchRun& run) override;
    void on_progress(const tools::BenchProgress& progress) override;
    void on_done(const tools::BenchDone& done) override;
    void on_failure(const std::string& why) override;
    void on_table(const std::string& markdown) override;

  private:
    void tell(const std::string& line);

    bool terminal_;
    std::string run_;
    StatusLine line_;
};

}  // namespace spectralpack::cli
