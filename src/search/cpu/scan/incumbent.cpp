#include "search/cpu/scan/incumbent.hpp"
#include "search/cpu/tuning.hpp"

#include <algorithm>
#include <tuple>

namespace spectralpack {

bool better(const ScoredPosition& a, const ScoredPosition& b) {
    const auto rank = [](const ScoredPosition& p) {
        return std::make_tuple(p.index, p.position.z, p.position.y, p.position.x);
    };
    if (a.cost != b.cost) return a.cost < b.cost;
    return rank(a) < rank(b);
}

void Incumbent::offer(const ScoredPosition& found) {
    const std::lock_guard lock(mutex_);
    if (best_) beaten_.push_back(better(found, *best_) ? *best_ : found);
    if (beaten_.size() == 2 * tuning::kSeeds) {
        std::ranges::nth_element(beaten_, beaten_.begin() + tuning::kSeeds, better);
        beaten_.resize(tuning::kSeeds);
    }
    if (best_ && !better(found, *best_)) return;
    best_ = found;
    generation_.fetch_add(1, std::memory_order_release);
}

bool Incumbent::improved_by(const ScoredPosition& found) const {
    const std::lock_guard lock(mutex_);
    return !best_ || better(found, *best_);
}

std::optional<ScoredPosition> Incumbent::get() const {
    const std::lock_guard lock(mutex_);
    return best_;
}

std::vector<ScoredPosition> Incumbent::beaten() const {
    const std::lock_guard lock(mutex_);
    std::vector<ScoredPosition> best = beaten_;
    std::ranges::sort(best, better);
    best.resize(std::min(best.size(), tuning::kSeeds));
    return best;
}

std::int64_t proximity_limit(const CostModel& model, int z, int layers, int reference_layers,
                             const std::optional<ScoredPosition>& best, int index) {
    if (!best) return kNoLimit;
    const auto could_win = [&](std::int64_t rho) {
        const Cost cost = cost_of(model, z, layers, reference_layers, rho);
        return index > best->index ? cost < best->cost : cost <= best->cost;
    };
    constexpr std::int64_t kMost = std::int64_t{1} << 52;  // above any rho: 2^31 voxels of 16 bits each
    if (!could_win(0)) return -1;
    if (could_win(kMost)) return kNoLimit;
    // Rounding disjoint, the limit is the difference of the costs: look there first.
    std::int64_t yes = 0, no = kMost;
    const std::int64_t guess = std::clamp(
        model.height_at == HeightAt::top
            ? best->cost.secondary
            : static_cast<std::int64_t>(best->cost.primary - cost_of(model, z, layers, reference_layers, 0).primary),
        std::int64_t{1}, kMost - 2);
    for (const std::int64_t guessed : {guess - 1, guess, guess + 1}) {
        (could_win(guessed) ? yes : no) = guessed;
        if (no == guessed) break;
    }
    while (no - yes > 1) {
        const std::int64_t middle = yes + (no - yes) / 2;
        (could_win(middle) ? yes : no) = middle;
    }
    return yes;
}

}  // namespace spectralpack
