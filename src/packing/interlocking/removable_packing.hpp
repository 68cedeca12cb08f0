#pragma once
/// A packing that comes apart, copy after copy: whoever comes may stand only if there is a plan for all with it.

#include <optional>
#include <vector>

#include "disassembly/plan_repair.hpp"
#include "disassembly/subassembly.hpp"
#include "packing/interlocking/placed_bodies.hpp"

namespace spectralpack {

class RemovablePacking {
  public:
    /// What stands comes apart by `steps`. `bodies` and what it refers to outlive it.
    RemovablePacking(PlacedBodies& bodies, const std::vector<RemovalStep>& steps);

    /// Whether all still comes apart with the last of what is placed, which would be `object` in the tray and is not
    /// yet: at once, or in its turn, after others. If so it is in the plan, else the packing is without it. When the
    /// context's token stops it, there is no way.
    bool admit(const PlacedCopy& last, const TrayObject& object);

    /// By index into what is placed.
    std::vector<RemovalStep> steps() const { return plan_->steps(); }
    int fills() const { return fills_ + plan_->fills(); }

  private:
    void make(const std::vector<Body>& placed, const std::vector<RemovalStep>& steps);

    PlacedBodies& bodies_;
    int copies_ = 0;
    int fills_ = 0;
    // Of all that stands; what the plan keeps for itself lacks those that have left before the step it looks at.
    std::optional<Subassembly> subassembly_;
    std::optional<PlanRepair> plan_;
};

}  // namespace spectralpack
