#include "voxel/lazy_grid.hpp"

#include <atomic>
#include <mutex>
#include <utility>

namespace spectralpack {

struct LazyGrid::Lazy {
    Extent extent;
    std::function<BitGrid()> make;
    std::once_flag once;
    std::shared_ptr<const BitGrid> grid;
    std::atomic<bool> is_made = false;  ///< `grid` is there to be read
};

LazyGrid::LazyGrid(std::shared_ptr<const BitGrid> grid) {
    if (!grid) return;
    lazy_ = std::make_shared<Lazy>();
    lazy_->extent = grid->extent();
    lazy_->grid = std::move(grid);
    lazy_->is_made = true;
}

LazyGrid::LazyGrid(const Extent& extent, std::function<BitGrid()> make) : lazy_(std::make_shared<Lazy>()) {
    lazy_->extent = extent;
    lazy_->make = std::move(make);
}

const Extent& LazyGrid::extent() const { return lazy_->extent; }

const BitGrid& LazyGrid::made() const {
    Lazy& lazy = *lazy_;
    if (!lazy.is_made.load(std::memory_order_acquire)) {
        std::call_once(lazy.once, [&] {
            lazy.grid = std::make_shared<const BitGrid>(lazy.make());
            lazy.make = nullptr;
            lazy.is_made.store(true, std::memory_order_release);
        });
    }
    return *lazy.grid;
}

std::shared_ptr<const BitGrid> LazyGrid::share() const {
    if (!lazy_) return nullptr;
    made();
    return lazy_->grid;
}

std::int64_t LazyGrid::bytes() const {
    return lazy_ && lazy_->is_made.load(std::memory_order_acquire) ? lazy_->grid->bytes() : 0;
}

LazyGrid turned(const LazyGrid& grid, const AxisTurn& turn) {
    return {turned(grid.extent(), turn), [grid, turn] { return turned(*grid, turn); }};
}

}  // namespace spectralpack
