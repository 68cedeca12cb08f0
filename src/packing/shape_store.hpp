#pragma once
/// Voxelised parts, made shortly before they are needed and dropped after their last copy, so that thousands of
/// distinct parts do not have to be held at once.

#include <functional>
#include <memory>
#include <vector>

#include "core/parallel.hpp"
#include "packing/order.hpp"
#include "search/shape.hpp"

namespace spectralpack {

class ShapeStore {
  public:
    /// Makes the shape of a part; called from several threads at once for different parts.
    using Make = std::function<std::shared_ptr<const Shape>(int part)>;

    /// Told how long each batch of shapes took to make, for the record.
    using Timed = std::function<void(double seconds)>;

    /// `items`: the order in which shapes will be asked for; fixes what is made ahead and when a shape is dropped.
    ShapeStore(const std::vector<PackItem>& items, Make make, const Workers& workers, Timed timed);

    /// The shape of items[i].part. Calls come with i ascending. On a miss, the next kAhead distinct parts are made
    /// together, in parallel. Throws what `make` throws.
    const Shape& at(std::size_t i);

    /// items[i] is done with; the shape goes with the part's last copy.
    void release(std::size_t i);

    /// Parts made at a time: enough to keep the threads busy, few enough to hold.
    static constexpr int kAhead = 32;

  private:
    std::vector<PackItem> items_;
    Make make_;
    Workers workers_;
    Timed timed_;
    std::vector<std::shared_ptr<const Shape>> shapes_;  // by part
    std::vector<int> remaining_;                        // copies to come, by part
};

}  // namespace spectralpack
