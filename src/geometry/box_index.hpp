#pragma once
/// Which of many boxes meet a given one: a uniform grid of cells over a region.

#include <cstdint>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

class BoxIndex {
  public:
    /// Boxes may stick out of `region`; it only says where cells are worth having.
    explicit BoxIndex(const Box& region);

    void add(std::int64_t id, const Box& box);
    /// `box` as it was added.
    void remove(std::int64_t id, const Box& box);

    /// Ids in the cells that `box` meets: every id whose box meets `box`, and some that do not;
    /// ascending, each once. Time grows with their number and the cells met.
    std::vector<std::int64_t> near(const Box& box) const;

  private:
    static constexpr int kCells = 16;  ///< along the longest side of the region

    template <class Visit>
    void for_cells(const Box& box, Visit visit) const;

    Vec3 origin_;
    double cell_ = 1;
    int count_[3] = {1, 1, 1};
    std::vector<std::vector<std::int64_t>> cells_;
};

}  // namespace spectralpack
