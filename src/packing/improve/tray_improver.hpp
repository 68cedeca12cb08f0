#pragma once
/// Order local search in one tray: greedy packings in orders near to the best so far, over and over, each on the grid
/// and compacted where it promises to be the best.
///
/// A step packs in one order and compares. Steps belong to starts. A start begins with an order that only its number
/// and the seed decide (the first with the job's own), goes on from its best order so far, and ends when that has long
/// found nothing better; what it finds does not depend on other starts, threads or time.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "packing/improve/layout_value.hpp"
#include "packing/improve/prefix_packing.hpp"
#include "packing/job/started_tray.hpp"

namespace spectralpack {

struct TrayImproverOptions {
    std::vector<Copy> copies;  ///< in the job's order
    std::vector<int> ranks;    ///< by part, urgency_ranks(): copies of different rank keep their order
    LayoutJudge::Measures measures;
    /// Whether a copy may be tried before another one that the job's order puts before it; of equal ranks.
    std::function<bool(const Copy&, const Copy&)> may_pass;
    /// Of layouts that miss copies of the same worth, the one of which this is least is best: mm or mm^3.
    std::function<double(const std::vector<PlacedCopy>&)> size_of;
    std::uint64_t seed = 0;
    bool compact = true;  ///< copies may leave the grid
};

/// A layout that may be the best.
struct ImprovedLayout {
    std::vector<PlacedCopy> placed;  ///< compacted, where that is allowed
    LayoutValue value;               ///< on the grid
    double size = 0;                 ///< as TrayImproverOptions::size_of has it
};

struct ImproverStops {
    StopToken enough;  ///< ends steps
    StopToken stop;    ///< ends all
};

class TrayImprover {
  public:
    /// `started`, whose copies stand on the grid, outlives it.
    TrayImprover(StartedTray& started, const RefineOptions& refining, PrefixPacking::ShapeOf shape_of,
                 TrayImproverOptions options, const Workers& workers, const ImproverStops& stops);

    /// One more step. A layout where one was found that is better than all before; none also when stopped. As long as
    /// steps find better ones, none of them is compacted but the last.
    std::optional<ImprovedLayout> step();

    /// What the last steps promised, likewise, where nobody looked at it so far.
    std::optional<ImprovedLayout> compare();

    /// Of the best layout so far, where it turned out otherwise: layouts smaller than that are better from now on.
    void set_best_size(double size) {
        if (best_) best_->size = size;
    }

    /// The next step begins this start.
    void begin_start(int number);

    std::int64_t steps() const { return steps_; }  ///< that were not cut off
    int starts() const { return start_ + 1; }
    std::int64_t searches() const { return packing_.searches(); }

  private:
    std::vector<Copy> next_order();
    void accept(const std::vector<Copy>& order);

    StartedTray& started_;
    RefineOptions refining_;
    Workers workers_;
    TrayImproverOptions options_;
    StopToken stop_;
    LayoutJudge judge_;
    PrefixPacking packing_;
    RandomStream random_{0};
    int start_ = 0;
    bool fresh_ = true;               // nothing is packed in this start so far
    std::vector<Copy> order_;         // of the start's best layout
    std::vector<PackedStep> layout_;  // that
    LayoutValue value_;               // its
    std::int64_t last_gain_ = 0;      // searches by then
    std::int64_t steps_ = 0;
    std::optional<ImprovedLayout> promising_;  // on the grid
    std::int64_t promised_at_ = 0;             // steps by then
    std::optional<ImprovedLayout> best_;       // of all starts
};

}  // namespace spectralpack
