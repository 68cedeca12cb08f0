#include "packing/interlocking/final_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spectralpack {

Disassembly final_plan(const FinalPlanOptions& options, const Tray& tray, const std::vector<PlacedCopy>& placed,
                       const TrayContext& context, Disassembly plan, InterlockCounts& counts) {
    if (placed.empty() || context.stop.stopped()) return plan;
    BodyOptions standing = options;
    std::optional<PhysicalWalls> walls;
    if (options.unpack == Unpack::top && options.walls == nullptr) {
        Container container = options.container;
        if (std::isinf(container.size.z)) {
            container.size.z = 0;  // under an open ceiling they are as high as what stands
            for (const Body& body : PlacedBodies(options, tray, placed, context).placed()) {
                container.size.z = std::max(container.size.z, body.box().max.z);
            }
            for (const Body& body : options.fixed) {
                container.size.z = std::max(container.size.z, body.box().max.z);
            }
        }
        walls = physical_walls(container, finest_setup(tray.setup()), options.wall_gap, context.workers);
        standing.walls = &*walls;
    }
    const PlacedBodies bodies(standing, tray, placed, context);
    std::vector<Body> all = bodies.placed();
    bodies.add_what_stays(all);
    // The copies are told of once more, so what is told goes on from where the first plan ended.
    const auto told = [&](int left, int of) { options.left(left, 2 * of); };
    Unpacking unpacking{options.unpack, std::nullopt, told};
    if (walls) unpacking.walls = all.size() - 1;
    return unpacked(bodies.disassembly(), all, unpacking, std::move(plan), counts);
}

}  // namespace spectralpack
