#pragma once
/// The files that a run writes: those of each finished tray while the next is packed, and all of them at its end.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

#include "progress_display.hpp"
#include "summary.hpp"

namespace spectralpack::cli {

class RunOutputs {
  public:
    /// Both outlive it.
    RunOutputs(const JobSettings& settings, ProgressDisplay& display) : settings_(settings), display_(display) {}

    /// Of the trays that were not written before, but for pictures, which `render` draws from a .json as well. A run
    /// that is killed later has them.
    void write_trays(const Scene& finished);

    /// Writes every output and report; one that fails does not keep the others from being written. False: one did. What
    /// write_trays() wrote and the packing no longer has is removed. Pictures that are left out for time are named.
    bool write(const Scene& scene, const DrawingTime& time, RunFacts& facts);

  private:
    template <class Write>
    bool attempt(const std::string& file, const Write& write);
    ReportDetails report_details() const;

    const JobSettings& settings_;
    ProgressDisplay& display_;
    std::size_t trays_ = 0;                     ///< that are written
    std::set<std::filesystem::path> of_trays_;  ///< files
};

}  // namespace spectralpack::cli
