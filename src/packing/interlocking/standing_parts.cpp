#include "packing/interlocking/standing_parts.hpp"

#include <algorithm>
#include <span>

#include "voxel/voxelize.hpp"

namespace spectralpack {
StandingParts::StandingParts(const StandingSetup& setup, const Tray& tray, const std::vector<PlacedItem>& placed,
                             PlacementSearch& search, const StopToken& stop)
    : setup_(setup), tray_(tray), placed_(placed) {
    disassembly_.search = &search;
    disassembly_.corner = setup.walls ? setup.walls->corner : Vec3{setup.wall_gap, setup.wall_gap, setup.wall_gap};
    disassembly_.grid = setup.walls ? setup.walls->grid : finest_setup(tray.setup());
    disassembly_.ray_spacing = setup.ray_spacing.value_or(DisassemblySetup::spacing_for(disassembly_.grid.voxel_size));
    disassembly_.on_grid = [this](int i) {
        const PlacedItem& item = placed_[static_cast<std::size_t>(i)];
        const Mesh mesh = setup_.surfaces->turned_mesh(item.item.part, item.orientation);
        return std::make_shared<const BitGrid>(voxelize(mesh, disassembly_.grid.voxel_size, setup_.workers));
    };
    disassembly_.workers = setup.workers;
    disassembly_.stop = stop;
}

bool StandingParts::follow_tray() {
    if (setup_.walls || disassembly_.grid.size.z >= tray_.setup().size.z) return false;
    disassembly_.grid = finest_setup(tray_.setup());
    return true;
}

/// An object of the tray in the grid that ways out are looked for in.
TrayObject StandingParts::in_grid(const TrayObject& object) const {
    return setup_.walls ? setup_.walls->moved(on_finest(object)) : on_finest(object);
}

StandingPart StandingParts::of(const PlacedItem& item, const TrayObject& object) const {
    return {setup_.surfaces->at(item.item.part, item.orientation), item.offset, in_grid(object)};
}

std::vector<StandingPart> StandingParts::placed(std::size_t count) const {
    const std::span items = std::span(placed_).first(std::min(count, placed_.size()));
    std::vector<TurnedPart> wanted;
    for (const PlacedItem& item : items) {
        wanted.push_back({item.item.part, item.orientation});
    }
    setup_.surfaces->make(wanted);
    std::vector<StandingPart> parts;
    for (const PlacedItem& item : items) {
        parts.push_back(of(item, tray_.object(item.object)));
    }
    return parts;
}

void StandingParts::add_fixed(std::vector<StandingPart>& parts) const {
    for (StandingPart part : setup_.fixed) {
        part.object = in_grid(part.object);
        part.object.fixed = true;
        parts.push_back(std::move(part));
    }
}

void StandingParts::add_what_stays(std::vector<StandingPart>& parts) const {
    add_fixed(parts);
    if (setup_.walls) parts.push_back(setup_.walls->part);
}

}  // namespace spectralpack
