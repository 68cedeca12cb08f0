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
        const OrientedShape& oriented = shape.orientations.front();
        const Extent count = tray.candidates(oriented.reach);
        const BitGrid taken = tray.omega_place();
        for (int z = 0; z < count.z; ++z)
            for (int y = 0; y < count.y; ++y)
                for (int x = 0; x < count.x; ++x)
                    if (!intersects(taken, *oriented.solid, {x, y, z})) {
                        BestPlacement best;
                        best.position = {x, y, z};
                        return {best, false};
                    }
        return {};
    }
    FreePositions free_positions(const Tray&, const Shape&, int, const FreeQuery&) override { return {}; }
    const char* name() const override { return "first fit"; }
    std::int64_t memory() const override { return 0; }

    int asked = 0;
    int fail_at = -1;
};

}  // namespace spectralpack::test
