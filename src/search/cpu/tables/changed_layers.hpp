#pragma once
/// Where something of a grid changed, layer by layer: what spreads from an object is a hull in each layer, half of the
/// hull of all.

#include <algorithm>
#include <vector>

#include "voxel/voxel_box.hpp"

namespace spectralpack {

class ChangedLayers {
  public:
    ChangedLayers() = default;
    /// Nothing yet, of a grid with that many layers.
    explicit ChangedLayers(int layers) : layers_(static_cast<std::size_t>(layers)) {}

    bool empty() const { return hull_.empty(); }
    /// Of all layers; above and below it nothing changed.
    const VoxelBox& hull() const { return hull_; }
    /// Of layer z, one layer high, or empty.
    const VoxelBox& at(int z) const { return layers_[static_cast<std::size_t>(z)]; }

    /// `box` changed as well; it lies in the grid.
    void add(const VoxelBox& box) {
        if (box.empty()) return;
        hull_ = spectralpack::hull(hull_, box);
        for (int z = box.lo.z; z < box.hi.z; ++z) {
            VoxelBox& layer = layers_[static_cast<std::size_t>(z)];
            layer = spectralpack::hull(layer, layer_of(box, z));
        }
    }
    void add(const ChangedLayers& other) {
        for (int z = other.hull_.lo.z; z < other.hull_.hi.z; ++z) {
            add(other.at(z));
        }
    }
    void clear() {
        for (int z = hull_.lo.z; z < hull_.hi.z; ++z) {
            layers_[static_cast<std::size_t>(z)] = {};
        }
        hull_ = {};
    }

  private:
    VoxelBox hull_;
    std::vector<VoxelBox> layers_;
};

}  // namespace spectralpack
