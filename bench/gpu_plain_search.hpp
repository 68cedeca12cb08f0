#pragma once
/// GpuPlain as it is asked by search_bench: one tray, detail 1, no keep-out, one gap class, heights at the bottom.

#include <algorithm>
#include <optional>
#include <vector>

#include "gpu_plain.hpp"
#include "search/placement_search.hpp"
#include "search/reference/transform.hpp"
#include "spectralpack/error.hpp"
#include "voxel/distance_field.hpp"

namespace spectralpack {

class GpuPlainSearch final : public PlacementSearch {
  public:
    /// What is not part of the method's time: transforms' plans and, on the CPU, the distance field.
    void prepare(const Tray& tray, const Shape& shape) {
        if (tray.detail() != 1 || tray.gap_classes() != 1 || !tray.blocked().none()) {
            throw UsageError("the GPU's plain method knows detail 1 only, one gap, and no keep-out");
        }
        if (!gpu_) {
            grid_ = transform_extent(tray.extent(), VoxelIndex{kOverhang, kOverhang, kOverhang});
            gpu_.emplace(grid_.x, grid_.y, grid_.z, kMostOrientations);
        }
        gpu_->plan(static_cast<int>(shape.orientations.size()));
        if (tray.version() == version_) return;
        phi_ = manhattan_distance(tray.omega_place(), tray.setup().ceiling);
    }

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken&) override {
        if (tray.version() != version_) gpu_->set_tray(voxels(tray.occupied_part(0, 0), {}), phi_.data());
        version_ = tray.version();
        std::vector<GpuOrientation> orientations;
        for (const OrientedShape& oriented : shape.orientations) {
            const WidenedVoxels& wide = oriented.widened.front();
            const Extent count = tray.candidates(oriented.reach);
            for (int axis = 0; axis < 3; ++axis) {
                const int beyond = std::max(
                    -wide.offset[axis], wide.voxels.extent()[axis] + wide.offset[axis] - oriented.solid.extent()[axis]);
                if (beyond > kOverhang) throw UsageError("the gap is too wide for the GPU's plain method");
            }
            orientations.push_back({voxels(*oriented.solid, {}),
                                    voxels(*wide.voxels, wide.offset),
                                    wide.offset == VoxelIndex{} && *wide.voxels == *oriented.solid,
                                    {count.x, count.y, count.z}});
        }
        std::vector<double> penalties;
        for (int z = 0; z < grid_.z; ++z) {
            penalties.push_back(height_penalty_at(model, z, tray.reference_layers()));
        }
        const std::optional<GpuBest> found = gpu_->best(orientations, penalties);
        if (!found) return {};
        BestPlacement best;
        best.index = found->index;
        best.position = {found->position[0], found->position[1], found->position[2]};
        best.proximity = found->proximity;
        best.cost = {found->cost, 0};
        return {best, false};
    }
    FreePositions free_positions(const Tray&, const Shape&, int, const FreeQuery&) override {
        throw InternalError("the GPU's plain method is not asked for free positions");
    }
    const char* name() const override { return "GPU, plain"; }
    std::int64_t memory() const override { return 0; }

  private:
    static constexpr int kOverhang = 1;  // voxels by which A+g may reach beyond A
    static constexpr int kMostOrientations = 24;

    static GpuVoxels voxels(const BitGrid& bits, const VoxelIndex& offset) {
        const Extent& e = bits.extent();
        return {bits.words().data(), bits.words_per_row(), {e.x, e.y, e.z}, {offset.x, offset.y, offset.z}};
    }

    Extent grid_;
    std::optional<GpuPlain> gpu_;
    Grid<std::int32_t> phi_;
    std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace spectralpack
