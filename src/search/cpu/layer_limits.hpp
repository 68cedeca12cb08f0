#pragma once
/// The greatest rho that can still win, in each layer of a brick layer.

#include <algorithm>
#include <cstdint>
#include <optional>

#include "search/cpu/orientation_search.hpp"

namespace spectralpack {

/// As the incumbent stood when they were last looked at; below 0 where nothing can win any more, or nothing may stand.
class LayerLimits {
  public:
    explicit LayerLimits(const OrientationTask& task) : task_(task) {}

    /// Those of brick layer bz from here on. O(1) where nothing has changed.
    void look(int bz) {
        const std::uint64_t generation = task_.context.incumbent.generation();
        if (bz == brick_layer_ && generation == generation_) return;
        brick_layer_ = bz;
        generation_ = generation;
        work_out();
    }

    std::int64_t of(int layer) const { return limits_[layer]; }  ///< counted from the lowest of the brick layer
    std::int64_t most() const { return most_; }

  private:
    void work_out() {
        const SearchContext& context = task_.context;
        const std::optional<Placed> best = context.incumbent.get();
        most_ = -1;
        for (int i = 0; i < kBrickZ; ++i) {
            const int z = kBrickZ * brick_layer_ + i;
            limits_[i] =
                z < task_.state.count().z && context.model.allows(task_.index, z)
                    ? proximity_limit(context.model, z, task_.layers, context.reference_layers, best, task_.index)
                    : -1;
            most_ = std::max(most_, limits_[i]);
        }
    }

    const OrientationTask& task_;
    int brick_layer_ = -1;
    std::uint64_t generation_ = 0;
    std::int64_t limits_[kBrickZ] = {};
    std::int64_t most_ = -1;
};

}  // namespace spectralpack
