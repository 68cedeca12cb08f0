#pragma once
/// The definition of the placement search, written as loops over voxels with nothing clever and
/// nothing shared with an engine but the cost's one function: what every engine is compared with.
/// Occupancy is recomputed from the list of objects, so the tray's own book-keeping is under test
/// as well.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "search/placement_search.hpp"

namespace spectralpack::test {

class BruteForceSearch : public PlacementSearch {
  public:
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        if (stop.stopped()) return {std::nullopt, true};
        const Scenery scenery(tray);
        std::optional<BestPlacement> best;
        for (int index = 0; index < static_cast<int>(shape.orientations.size()); ++index) {
            const Figure figure(shape.orientations[static_cast<std::size_t>(index)]);
            const Extent count = tray.candidates(figure.shape.reach);
            for_each_index(count, [&](const VoxelIndex& q) {
                if (!model.allows(index, q.z) || scenery.collides(figure, q)) return;
                if (shape.admits && !shape.admits(index, q)) return;
                const std::int64_t rho = scenery.rho(figure, q);
                const Cost cost = scenery.cost(model, figure, q.z, rho);
                if (!best || cost < best->cost) best = BestPlacement{index, q, rho, cost, {}};
            });
        }
        if (best) {
            const Figure figure(shape.orientations[static_cast<std::size_t>(best->index)]);
            for (int i = 0; i < 6; ++i) {
                VoxelIndex q = best->position;
                q[i / 2] += i % 2 == 0 ? -1 : 1;
                best->neighbours[static_cast<std::size_t>(i)] =
                    scenery.cost(model, figure, q.z, scenery.rho(figure, q));
            }
        }
        return {best, false};
    }

    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        const BitGrid& a = *shape.orientations[static_cast<std::size_t>(index)].solid;
        const Extent& n = tray.extent();
        FreePositions result;
        Extent extent;
        for (int axis = 0; axis < 3; ++axis) {
            result.origin[axis] = -(a.extent()[axis] - 1) - query.padding;
            extent[axis] = n[axis] + a.extent()[axis] - 1 + 2 * query.padding;
        }
        result.free = BitGrid(extent);
        const BitGrid omega = occupied_by_objects(tray, 1, query.without, std::nullopt);
        const bool walls = tray.setup().blocked_is_physical;
        const std::vector<VoxelIndex> voxels = set_voxels(a);
        for_each_index(extent, [&](const VoxelIndex& i) {
            const bool meets = std::ranges::any_of(voxels, [&](const VoxelIndex& x) {
                const VoxelIndex v = x + result.origin + i;
                return n.contains(v) && (omega.get(v.x, v.y, v.z) || (walls && blocked(tray, v)));
            });
            result.free.set(i.x, i.y, i.z, !meets);
        });
        return result;
    }

    const char* name() const override { return "brute force"; }
    std::int64_t memory() const override { return 0; }

  private:
    /// By ascending (z, y, x).
    template <class Visit>
    static void for_each_index(const Extent& e, const Visit& visit) {
        for (int z = 0; z < e.z; ++z) {
            for (int y = 0; y < e.y; ++y) {
                for (int x = 0; x < e.x; ++x) {
                    visit(VoxelIndex{x, y, z});
                }
            }
        }
    }

    static std::vector<VoxelIndex> set_voxels(const BitGrid& bits, const VoxelIndex& offset = {}) {
        std::vector<VoxelIndex> voxels;
        for_each_index(bits.extent(), [&](const VoxelIndex& v) {
            if (bits.get(v.x, v.y, v.z)) voxels.push_back(v + offset);
        });
        return voxels;
    }

    static bool blocked(const Tray& tray, const VoxelIndex& v) {
        return !tray.blocked().extent().empty() && tray.blocked().get(v.x, v.y, v.z);
    }

    /// In voxels of dx / detail, where detail is 1 or the tray's.
    static BitGrid occupied_by_objects(const Tray& tray, int detail, std::optional<ObjectId> without,
                                       std::optional<int> gap_class) {
        const Extent& n = tray.extent();
        BitGrid bits({detail * n.x, detail * n.y, detail * n.z});
        const int pooled = tray.detail() / detail;
        for (ObjectId id = 0; id < tray.object_count(); ++id) {
            const TrayObject* object = tray.find(id);
            if (!object || id == without) continue;
            if (gap_class && object->gap_class != *gap_class) continue;
            const bool fine = tray.detail() > 1;
            for (VoxelIndex v :
                 set_voxels(fine ? *object->fine : *object->solid, fine ? object->fine_position : object->position)) {
                for (int axis = 0; axis < 3; ++axis) {
                    v[axis] = static_cast<int>(std::floor(static_cast<double>(v[axis]) / pooled));
                }
                if (bits.extent().contains(v)) bits.set(v.x, v.y, v.z);
            }
        }
        return bits;
    }

    /// An orientation as lists of voxels: A, and A+g(c), in fine voxels, for every gap class c.
    struct Figure {
        const OrientedShape& shape;
        std::vector<VoxelIndex> a;
        std::vector<std::vector<VoxelIndex>> widened;

        explicit Figure(const OrientedShape& oriented) : shape(oriented), a(set_voxels(*oriented.solid)) {
            for (const auto& wide : oriented.widened) {
                widened.push_back(set_voxels(*wide.voxels, wide.offset));
            }
        }
    };

    /// What stands in the tray, recomputed from the objects for every question.
    struct Scenery {
        const Tray& tray;
        std::vector<BitGrid> objects;  ///< per gap class
        std::vector<BitGrid> fine;     ///< the same in voxels of dx / s
        Grid<std::int32_t> phi;

        explicit Scenery(const Tray& t) : tray(t), phi(t.extent()) {
            for (int c = 0; c < tray.gap_classes(); ++c) {
                objects.push_back(occupied_by_objects(tray, 1, std::nullopt, c));
                fine.push_back(occupied_by_objects(tray, tray.detail(), std::nullopt, c));
            }
            for_each_index(tray.extent(), [&](const VoxelIndex& v) { phi.at(v.x, v.y, v.z) = distance_at(v); });
        }

        bool in_omega_place(const VoxelIndex& v) const {
            return blocked(tray, v) ||
                   std::ranges::any_of(objects, [&](const BitGrid& occupied) { return occupied.get(v.x, v.y, v.z); });
        }

        /// Equation (3): Manhattan distance to Omega_place, everything outside the grid included.
        std::int32_t distance_at(const VoxelIndex& v) const {
            const Extent& n = tray.extent();
            int nearest = std::min({v.x + 1, n.x - v.x, v.y + 1, n.y - v.y, v.z + 1});
            if (tray.setup().ceiling == Ceiling::closed) nearest = std::min(nearest, n.z - v.z);
            // Nothing farther than `nearest` can change the answer.
            for (int z = std::max(0, v.z - nearest); z < std::min(n.z, v.z + nearest); ++z) {
                for (int y = std::max(0, v.y - nearest); y < std::min(n.y, v.y + nearest); ++y) {
                    for (int x = std::max(0, v.x - nearest); x < std::min(n.x, v.x + nearest); ++x) {
                        const int d = std::abs(x - v.x) + std::abs(y - v.y) + std::abs(z - v.z);
                        if (d < nearest && in_omega_place({x, y, z})) nearest = d;
                    }
                }
            }
            return nearest;
        }

        /// Equation (2), zeta > 0: A against walls, A+g(c) against the objects of class c.
        bool collides(const Figure& figure, const VoxelIndex& q) const {
            const Extent& n = tray.extent();
            for (const VoxelIndex& x : figure.a) {
                if (!n.contains(x + q) || blocked(tray, x + q)) return true;
            }
            const int s = tray.detail();
            for (std::size_t c = 0; c < fine.size(); ++c) {
                for (const VoxelIndex& x : figure.widened[c]) {
                    const VoxelIndex v = x + VoxelIndex{s * q.x, s * q.y, s * q.z};
                    if (fine[c].extent().contains(v) && fine[c].get(v.x, v.y, v.z)) return true;
                }
            }
            return false;
        }

        /// Equation (4), phi = 0 outside the grid.
        std::int64_t rho(const Figure& figure, const VoxelIndex& q) const {
            std::int64_t sum = 0;
            for (const VoxelIndex& x : figure.a) {
                const VoxelIndex v = x + q;
                if (tray.extent().contains(v)) sum += phi.at(v.x, v.y, v.z);
            }
            return sum;
        }

        Cost cost(const CostModel& model, const Figure& figure, int z, std::int64_t rho_at) const {
            return cost_of(model, z, figure.shape.solid.extent().z, tray.reference_layers(), rho_at);
        }
    };
};

}  // namespace spectralpack::test
