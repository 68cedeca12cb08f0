#pragma once
/// How one part is let into a plan: by going through the plan's steps (docs/algorithm/interlocking.md, step 4). For
/// PlanRepair.

#include <optional>
#include <vector>

#include "disassembly/plan_repair.hpp"
#include "disassembly/standing_hull.hpp"

namespace spectralpack {

/// Whose subassembly each part is in while steps are made.
class Subassemblies {
  public:
    explicit Subassemblies(std::size_t parts) : of_(parts, 0) {}

    int of(std::size_t part) const { return of_[part]; }
    int of(const RemovalStep& step) const { return of_[static_cast<std::size_t>(step.placements.front())]; }
    void make(const RemovalStep& step) {
        constexpr int kLeft = -1;
        const int to = step.placements.size() > 1 ? founded_++ : kLeft;
        for (const int part : step.placements) {
            of_[static_cast<std::size_t>(part)] = to;
        }
    }

  private:
    std::vector<int> of_;
    int founded_ = 1;
};

/// Lets one part in: goes through the steps of its subassembly from when it was discarded on.
class PlanRepair::Letting {
  public:
    Letting(PlanRepair& plan, std::size_t part);
    /// Changes the plan if it is true.
    bool run(std::size_t most, bool instead);

  private:
    bool member(std::size_t i) const { return subassemblies_.of(i) == subassembly_; }
    void keep(Step step);
    std::optional<Path> past(const Members& movers, Path path) const;
    bool leaves_before(const Step& planned);
    void go_on(const Step& planned, const Members& movers, std::optional<Path> path);
    bool still_stuck();
    bool take_apart_those_waiting(bool instead);

    PlanRepair& plan_;
    const std::size_t part_;
    std::size_t next_ = 0;             // of the plan's steps
    std::vector<Step> steps_;          // the new plan, so far
    Subassemblies subassemblies_;      // after those
    int subassembly_ = 0;              // the part's
    Members waiting_;                  // go last
    std::vector<bool> waits_;          // by part
    StandingHull standing_;            // those waiting included
    StandingHull going_;               // those not, but those that are out: they may come in again
    std::vector<Since> unknown_from_;  // of those that are out: steps from that number on know nothing of them any more
    std::vector<Since> discarded_;     // instead of the part
};

}  // namespace spectralpack
