#include "packing/interlocking/placed_bodies.hpp"

#include <algorithm>
#include <span>

#include "voxel/voxelize.hpp"

namespace spectralpack {
PlacedBodies::PlacedBodies(const BodyOptions& options, const Tray& tray, const std::vector<PlacedCopy>& placed,
                           const TrayContext& context)
    : options_(options), tray_(tray), placed_(placed) {
    disassembly_.search = &context.search;
    disassembly_.corner =
        options.walls ? options.walls->corner : Vec3{options.wall_gap, options.wall_gap, options.wall_gap};
    disassembly_.grid = options.walls ? options.walls->grid : finest_setup(tray.setup());
    disassembly_.ray_spacing =
        options.ray_spacing.value_or(DisassemblyOptions::spacing_for(disassembly_.grid.voxel_size));
    disassembly_.on_grid = [this](int i) {
        const PlacedCopy& copy = placed_[static_cast<std::size_t>(i)];
        const Mesh mesh = options_.surfaces->turned_mesh(copy.copy.part, copy.orientation);
        return std::make_shared<const BitGrid>(voxelize(mesh, disassembly_.grid.voxel_size, disassembly_.workers));
    };
    disassembly_.workers = context.workers;
    disassembly_.stop = context.stop;
}

bool PlacedBodies::follow_tray() {
    if (options_.walls || disassembly_.grid.size.z >= tray_.setup().size.z) return false;
    disassembly_.grid = finest_setup(tray_.setup());
    return true;
}

/// An object of the tray in the grid that ways out are looked for in.
TrayObject PlacedBodies::in_grid(const TrayObject& object) const {
    return options_.walls ? options_.walls->moved(on_finest(object)) : on_finest(object);
}

Body PlacedBodies::of(const PlacedCopy& placed, const TrayObject& object) const {
    return {options_.surfaces->at(placed.copy.part, placed.orientation), placed.offset, in_grid(object)};
}

std::vector<Body> PlacedBodies::placed(std::size_t count) const {
    const std::span copies = std::span(placed_).first(std::min(count, placed_.size()));
    std::vector<TurnedPart> wanted;
    for (const PlacedCopy& placed : copies) {
        wanted.push_back({placed.copy.part, placed.orientation});
    }
    options_.surfaces->make(wanted);
    std::vector<Body> bodies;
    for (const PlacedCopy& placed : copies) {
        bodies.push_back(of(placed, tray_.object(placed.object)));
    }
    return bodies;
}

void PlacedBodies::add_fixed(std::vector<Body>& bodies) const {
    for (Body body : options_.fixed) {
        body.object = in_grid(body.object);
        body.object.fixed = true;
        bodies.push_back(std::move(body));
    }
}

void PlacedBodies::add_what_stays(std::vector<Body>& bodies) const {
    add_fixed(bodies);
    if (options_.walls) bodies.push_back(options_.walls->part);
}

}  // namespace spectralpack
