#pragma once
/// The best placement found so far in a search, shared by its threads, and what it rules out.

#include <atomic>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include "search/cost.hpp"
#include "spectralpack/grid.hpp"

namespace spectralpack {

struct ScoredPosition {
    Cost cost;
    int index = 0;  ///< in Shape::orientations
    VoxelIndex position;
    std::int64_t proximity = 0;
};

/// The order of "best": (cost, orientation index, z, y, x), lexicographically.
bool better(const ScoredPosition& a, const ScoredPosition& b);

class Incumbent {
  public:
    /// Keeps `found` if it is better than what is there. The result after all offers does not
    /// depend on their order.
    void offer(const ScoredPosition& found);

    bool improved_by(const ScoredPosition& found) const;

    /// Grows with every change: a copy taken at this generation is still current.
    std::uint64_t generation() const { return generation_.load(std::memory_order_acquire); }
    std::optional<ScoredPosition> get() const;
    /// The best of those that were offered and lost, at most tuning::kSeeds, best first.
    std::vector<ScoredPosition> beaten() const;

  private:
    mutable std::mutex mutex_;
    std::optional<ScoredPosition> best_;
    std::vector<ScoredPosition> beaten_;
    std::atomic<std::uint64_t> generation_{0};
};

inline constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

/// The greatest rho with which orientation `index` in layer z could still win against `best` (by
/// cost, or by orientation index where costs are equal; positions of the same orientation are left
/// to better()); -1 when none could, kNoLimit when all could. A position with rho above it cannot
/// be the answer, whatever else is found: pruning by it is exact. Decided with cost_of() itself,
/// which grows with rho, so that rounding is the cost's own.
std::int64_t proximity_limit(const CostModel& model, int z, int layers, int reference_layers,
                             const std::optional<ScoredPosition>& best, int index);

}  // namespace spectralpack
