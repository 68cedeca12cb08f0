#include "packing/improve/prefix_packing.hpp"

#include <algorithm>
#include <utility>

#include "packing/tray/greedy.hpp"

namespace spectralpack {
namespace {

// Trays remember all that ever stood in them. From so many on a fresh one is worth it.
constexpr ObjectId kMostRemembered = 4000;

/// Steps at the beginning of both that are about the same parts.
std::size_t common_beginning(const std::vector<PackedStep>& steps, const std::vector<Copy>& order) {
    const auto same = [](const PackedStep& step, const Copy& copy) { return step.copy.part == copy.part; };
    const auto [parting, other] = std::ranges::mismatch(steps, order, same);
    return static_cast<std::size_t>(parting - steps.begin());
}

}  // namespace

PrefixPacking::PrefixPacking(StartedTray& started, ShapeOf shape_of, const StopToken& stop)
    : started_(started), shape_of_(std::move(shape_of)), context_(started.context(started.search(), stop)) {}

PrefixPacking::Outcome PrefixPacking::pack(const std::vector<Copy>& order, const std::vector<PackedStep>& known,
                                           const IsHopeless& is_hopeless) {
    undo_to(common_beginning(steps_, order));
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        steps_[i].copy = order[i];
        if (steps_[i].placed) steps_[i].placed->copy = order[i];
    }
    renew();
    const std::size_t as_known = common_beginning(known, order);
    while (steps_.size() < order.size()) {
        const std::size_t i = steps_.size();
        const Copy& copy = order[i];
        if (i < as_known) {
            steps_.push_back({copy, std::nullopt});
            if (!known[i].placed) {
                ++failed_[copy.part];
            } else {
                PlacedCopy placed = *known[i].placed;
                placed.copy = copy;
                stand(placed);
            }
            continue;
        }
        if (context_.stop.stopped()) return Outcome::stopped;
        std::optional<PlacedCopy> placed;
        if (!failed_.contains(copy.part)) {
            GreedyResult result;
            const auto shape_of = [&]() -> const Shape& { return shape_of_(copy.part); };
            const PlaceOutcome outcome = place_copy(started_.tray(), context_, copy, shape_of, result);
            if (outcome == PlaceOutcome::stopped) return Outcome::stopped;
            searches_ += result.searches;
            if (outcome == PlaceOutcome::placed) placed = result.placed.back();
        }
        if (!placed) ++failed_[copy.part];
        steps_.push_back({copy, placed});
        if (is_hopeless(steps_)) return Outcome::hopeless;
    }
    return Outcome::packed;
}

void PrefixPacking::undo_to(std::size_t count) {
    for (; steps_.size() > count; steps_.pop_back()) {
        const auto& [copy, placed] = steps_.back();
        if (!placed) {
            if (--failed_[copy.part] == 0) failed_.erase(copy.part);
            continue;
        }
        started_.tray().remove(placed->object);
        if (Caps* caps = started_.caps()) caps->remove(placed->copy.part, placed->orientation, placed->offset);
    }
}

/// The last step's copy.
void PrefixPacking::stand(const PlacedCopy& placed) {
    PlacedCopy standing = placed;
    standing.object = started_.add_on_grid(placed, shape_of_(placed.copy.part));
    if (Caps* caps = started_.caps()) caps->add(placed.copy.part, placed.orientation, placed.offset);
    steps_.back().placed = standing;
}

void PrefixPacking::renew() {
    Tray& tray = started_.tray();
    if (tray.object_count() < kMostRemembered + 8 * static_cast<ObjectId>(steps_.size())) return;
    Tray fresh(tray.setup());
    for (ObjectId id = 0; id < tray.object_count(); ++id) {
        if (const TrayObject* object = tray.find(id); object && object->fixed) fresh.add(*object);
    }
    for (PackedStep& step : steps_) {
        if (step.placed) step.placed->object = fresh.add(tray.object(step.placed->object));
    }
    tray = std::move(fresh);
}

std::vector<PlacedCopy> placed_of(const std::vector<PackedStep>& steps) {
    std::vector<PlacedCopy> placed;
    for (const PackedStep& step : steps) {
        if (step.placed) placed.push_back(*step.placed);
    }
    return placed;
}

}  // namespace spectralpack
