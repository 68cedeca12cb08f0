#pragma once
/// A placement search simple enough to see through, and shapes for it.

#include <atomic>
#include <memory>
#include <stdexcept>

#include "search/placement_search.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {

/// A cube in voxels of 1 mm; `made` counts.
inline std::shared_ptr<const Shape> box_shape(std::uint64_t id, int side, std::atomic<int>* made = nullptr) {
    if (made) ++*made;
    BitGrid filled({side, side, side});
    filled.fill(true);
    const LazyGrid solid(std::move(filled));
    OrientedShape oriented;
    const double mm = side;
    oriented.reach = {mm, mm, mm};
    oriented.solid = solid;
    oriented.widened = {{solid, {}}};
    auto shape = std::make_shared<Shape>();
    shape->id = id;
    shape->orientations = {oriented};
    return shape;
}

/// Takes the first free candidate in (z, y, x) order, and counts how often it is asked.
class FirstFit : public PlacementSearch {
  public:
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel&,
                                const StopToken& stop) override {
        ++asked;
        if (stop.stopped()) return {{}, true};
        if (asked == fail_at) throw std::runtime_error("engine failed");
        return first_free(tray, shape, false);
    }
    FreePositions free_positions(const Tray&, const Shape&, int, const FreeQuery&) override { return {}; }
    const char* name() const override { return "first fit"; }
    std::int64_t memory() const override { return 0; }

    int asked = 0;
    int fail_at = -1;

  protected:
    /// In (z, y, x) order, z counted from the ceiling where `downwards`.
    static SearchResult first_free(const Tray& tray, const Shape& shape, bool downwards) {
        const OrientedShape& oriented = shape.orientations.front();
        const Extent count = tray.candidates(oriented.reach);
        const BitGrid taken = tray.omega_place();
        for (int layer = 0; layer < count.z; ++layer)
            for (int y = 0; y < count.y; ++y)
                for (int x = 0; x < count.x; ++x) {
                    BestPlacement best;
                    best.position = {x, y, downwards ? count.z - 1 - layer : layer};
                    if (!intersects(taken, *oriented.solid, best.position)) return {best, false};
                }
        return {};
    }
};

}  // namespace spectralpack::test
