#pragma once
/// A voxel grid that is made when its voxels are first asked for. Of the up to 24 orientations of a part that follow
/// from one by turns, the fast engine reads the voxels of few; of the others it wants extents, which are known before.

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "voxel/axis_turn.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// A handle: copies share the grid. Threads may ask at the same time; one of them makes it.
class LazyGrid {
  public:
    LazyGrid() = default;  ///< none
    LazyGrid(std::shared_ptr<const BitGrid> grid);
    explicit LazyGrid(BitGrid grid) : LazyGrid(std::make_shared<const BitGrid>(std::move(grid))) {}
    /// `make` gives a grid of that extent. It is called by who asks first (again by the next where it throws), then
    /// dropped with what it holds.
    LazyGrid(const Extent& extent, std::function<BitGrid()> make);

    explicit operator bool() const { return lazy_ != nullptr; }
    /// The very same grid, not an equal one.
    bool operator==(const LazyGrid&) const = default;

    /// Makes nothing.
    const Extent& extent() const;
    const BitGrid& operator*() const { return made(); }
    const BitGrid* operator->() const { return &made(); }
    std::shared_ptr<const BitGrid> share() const;
    /// Of the grid, 0 until it is made.
    std::int64_t bytes() const;

  private:
    struct Lazy;
    const BitGrid& made() const;

    std::shared_ptr<Lazy> lazy_;
};

/// turned() once it is asked for; holds `grid` until then.
LazyGrid turned(const LazyGrid& grid, const AxisTurn& turn);

}  // namespace spectralpack
