#pragma once
/// What a run says at its end, on standard output: the verdict, then what is in the tray, what is not and why, and what
/// was written, on one screen.

#include <optional>
#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

#include "pack_arguments.hpp"
#include "time_probe.hpp"

namespace spectralpack::cli {

/// What one -o came to.
struct WrittenFile {
    std::string file;
    std::vector<std::string> trays;  ///< a file for each, where there are several
};

/// What a summary says besides the packing.
struct RunFacts {
    std::vector<WrittenFile> written;
    std::vector<std::string> reports;
    bool files_named = false;
    TakenOver taken;                    ///< from the build that was topped up
    std::optional<double> onto_height;  ///< of that build
    std::vector<Printer> own_printers;  ///< known besides those of the table
    std::optional<double> seconds;      ///< that all of it took, files included; none: as long as packing
    bool details = false;
    bool require_all = false;
    bool skip_unusable = false;  ///< a file that cannot be used decides the exit status, unless it is
    bool keep_journal = false;   ///< also of a run that is done
};

/// The copies that this run placed: those that stood there before aside.
std::int64_t newly_placed(const Packing& packing);

std::string summary_text(const PackResult& result, const RunFacts& facts);
std::string estimate_text(const Estimate& estimate, const PackOptions& options, const std::optional<ProbedTime>& time);

}  // namespace spectralpack::cli
