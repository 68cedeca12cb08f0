#include "packing/interlocking/removable_packing.hpp"

#include <numeric>
#include <utility>

#include "disassembly/ways_out.hpp"

namespace spectralpack {
RemovablePacking::RemovablePacking(PlacedBodies& bodies, const std::vector<RemovalStep>& steps) : bodies_(bodies) {
    make(bodies_.placed(), steps);
}

void RemovablePacking::make(const std::vector<Body>& placed, const std::vector<RemovalStep>& steps) {
    std::vector<Body> parts = placed;
    copies_ = static_cast<int>(parts.size());
    std::vector<int> names(parts.size());
    std::iota(names.begin(), names.end(), 0);
    bodies_.add_what_stays(parts);
    names.resize(parts.size(), -1);
    plan_.emplace(bodies_.disassembly(), parts, steps, std::vector<std::size_t>(parts.size(), PlanRepair::kStayed));
    subassembly_.emplace(bodies_.disassembly(), std::move(names), std::move(parts));
}

bool RemovablePacking::admit(const PlacedCopy& last, const TrayObject& object) {
    if (bodies_.follow_tray()) {
        fills_ = fills();
        const std::vector<RemovalStep> steps = plan_->steps();
        make(bodies_.placed(static_cast<std::size_t>(copies_)), steps);
    }
    Body part = bodies_.of(last, object);
    const std::size_t i = subassembly_->add(copies_, part);
    if (std::optional<Subassembly::Path> path = any_way_out(*subassembly_, i)) {
        plan_->put_first(copies_, std::move(part), std::move(*path));
    } else if (!plan_->let_in(copies_, std::move(part))) {
        subassembly_->remove(i);
        return false;
    }
    ++copies_;
    return true;
}

}  // namespace spectralpack
