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
    /// Nothing can win from this one on, counted likewise.
    int layers() const { return layers_; }
    /// Of the layers that can win, the highest can with less than half the rho of a lower one: so much would do there
    /// that hardly anything can be free.
    bool steep() const { return layers_ > 0 && limits_[layers_ - 1] < most_ / 2; }

  private:
    void work_out() {
        const SearchContext& context = task_.context;
        const std::optional<Placed> best = context.incumbent.get();
        most_ = -1;
        layers_ = 0;
        for (int i = 0; i < kBrickZ; ++i) {
            const int z = kBrickZ * brick_layer_ + i;
            const bool any = z < task_.state.count().z && (task_.state.dead_layers(brick_layer_) >> i & 1) == 0;
            limits_[i] =
                any && context.model.allows(task_.index, z)
                    ? proximity_limit(context.model, z, task_.layers, context.reference_layers, best, task_.index)
                    : -1;
            most_ = std::max(most_, limits_[i]);
            if (limits_[i] >= 0) layers_ = i + 1;
        }
    }

    const OrientationTask& task_;
    int brick_layer_ = -1;
    std::uint64_t generation_ = 0;
    std::int64_t limits_[kBrickZ] = {};
    std::int64_t most_ = -1;
    int layers_ = 0;
};

}  // namespace spectralpack
