#pragma once
/// What became of one tray.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "packing/tray/placed_copy.hpp"
#include "spectralpack/disassembly.hpp"

namespace spectralpack {

struct GreedyResult {
    std::vector<PlacedCopy> placed;  ///< in the order placed
    std::vector<Copy> left_over;     ///< no free candidate was left for them, in the order tried
    std::vector<Copy> untried;       ///< the stop token came first
    std::int64_t searches = 0;       ///< copies really searched for
    std::map<int, std::string> why;  ///< by part, of what a cap left over
};

/// What was done about interlocking, for the record.
struct InterlockReport {
    InterlockCounts counts;
    bool changed = false;             ///< copies were removed, or all packed anew
    std::optional<double> least_gap;  ///< between two copies, mm, in the end; where changed and asked for
    double disassemble_seconds = 0;
    double reinsert_seconds = 0;  ///< without making voxels
};

struct FilledTray : GreedyResult {
    std::vector<Copy> interlocked;    ///< taken out again: they could not be taken out of the finished packing
    std::optional<Disassembly> plan;  ///< by index into `placed`; none where interlocking was not looked at
    InterlockReport report;
    HeightAt height_at = HeightAt::bottom;  ///< where it counted
    bool cut_short = false;                 ///< placing was ended before it was done
    /// Least distance between two copies, mm, as refined; none without refinement or with fewer than two.
    std::optional<double> least_gap;
};

}  // namespace spectralpack
