#pragma once
/// The greatest rho that can still win, in each layer of a brick layer, and what that makes bounds of whole blocks.
///
/// Each layer of a block has a limit of its own, since height costs. So what is kept of a block is a bound of rho and
/// its layer's rise together, the rise being what height adds since the lowest layer of the brick layer, in whole
/// numbers. Nothing of the block can win if that is above reach(), the greatest limit and rise together: then rho is
/// above the limit in each of its layers, whatever the rises are. While bounds are kept they have to stay what they
/// are.

#include <algorithm>
#include <cstdint>
#include <optional>

#include "search/cpu/scan/orientation_search.hpp"
#include "search/cpu/shapes/loads.hpp"
#include "search/cpu/tuning.hpp"

namespace spectralpack {

/// rho + rise, or what lanes hold of it.
inline std::uint32_t raised(std::uint32_t rho, std::uint32_t rise) {
    return static_cast<std::uint32_t>(std::min(std::uint64_t{rho} + rise, std::uint64_t{kSumLimit}));
}

/// As the incumbent stood when they were last looked at; below 0 where nothing can win any more, or nothing may stand.
class LayerLimits {
  public:
    explicit LayerLimits(const OrientationTask& task) : task_(task) {}

    /// Those of brick layer bz from here on. O(1) where nothing has changed.
    void look(int bz) {
        const std::uint64_t generation = task_.context.incumbent.generation();
        if (bz == brick_layer_ && generation == generation_) return;
        if (bz != brick_layer_ && task_.state.keeps()) work_out_rises(bz);
        brick_layer_ = bz;
        generation_ = generation;
        work_out();
    }

    std::int64_t of(int layer) const { return limits_[layer]; }  ///< counted from the lowest of the brick layer
    std::int64_t most() const { return most_; }
    std::uint32_t rise(int layer) const { return rises_[layer]; }  ///< counted likewise
    std::uint32_t reach() const { return reach_; }
    /// What sums of a layer with this limit have to be above to be given up. Copies are likely to be followed by
    /// copies, for which limits are a little higher: sums that go on beyond theirs leave bounds that still rule out
    /// then.
    std::uint32_t stop_above(std::int64_t limit) const {
        const std::int64_t beyond = task_.for_copy ? lane_limit(most_) / tuning::kPartsBeyondLimit : 0;
        return lane_limit(lane_limit(limit) + beyond);
    }
    /// Nothing can win from this one on, counted likewise.
    int layers() const { return layers_; }
    /// Of the layers that can win, the highest can with less than half the rho of a lower one: so much would do there
    /// that hardly anything can be free.
    bool steep() const { return layers_ > 0 && limits_[layers_ - 1] < most_ / 2; }

  private:
    void work_out() {
        const SearchContext& context = task_.context;
        const std::optional<ScoredPosition> best = context.incumbent.get();
        most_ = -1;
        layers_ = 0;
        reach_ = 0;
        for (int i = 0; i < kBrickZ; ++i) {
            const int z = kBrickZ * brick_layer_ + i;
            const bool any = z < task_.state.count().z && (task_.state.dead_layers(brick_layer_) >> i & 1) == 0;
            limits_[i] =
                any && context.model.allows(task_.index, z)
                    ? proximity_limit(context.model, z, task_.layers, context.reference_layers, best, task_.index)
                    : -1;
            if (limits_[i] < 0) continue;
            most_ = std::max(most_, limits_[i]);
            layers_ = i + 1;
            reach_ = std::max(reach_, raised(lane_limit(limits_[i]), rises_[i]));
        }
    }

    void work_out_rises(int bz) {
        const SearchContext& context = task_.context;
        const auto height = [&](int i) {
            return cost_of(context.model, kBrickZ * bz + i, task_.layers, context.reference_layers, 0).primary;
        };
        // Where the top decides before rho does, a layer is worth more than any rho; these need not know how much.
        constexpr double kLayer = 1 << 28;
        const double unit = context.model.height_at == HeightAt::top ? kLayer : 1;
        for (int i = 1; i < kBrickZ; ++i) {
            rises_[i] = static_cast<std::uint32_t>(std::clamp<double>(unit * (height(i) - height(0)), 0, kSumLimit));
        }
    }

    const OrientationTask& task_;
    int brick_layer_ = -1;
    std::uint64_t generation_ = 0;
    std::int64_t limits_[kBrickZ] = {};
    std::uint32_t rises_[kBrickZ] = {};  // 0 where nothing is kept: there each layer's own limit serves
    std::uint32_t reach_ = 0;
    std::int64_t most_ = -1;
    int layers_ = 0;
};

}  // namespace spectralpack
