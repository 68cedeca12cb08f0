#include "packing/tray/part_surfaces.hpp"

#include <set>

namespace spectralpack {
namespace {

const Mat3& turn_of(const ScaledPart& part, int orientation) {
    return (*part.orientations)[static_cast<std::size_t>(orientation)];
}

}  // namespace

Mesh PartSurfaces::turned_mesh(int part, int orientation) const {
    const ScaledPart scaled = part_of_(part);
    return transformed(*scaled.mesh, {turn_of(scaled, orientation), {}});
}

std::shared_ptr<const Bvh> PartSurfaces::at(int part, int orientation, const StopToken& stop) {
    std::shared_ptr<const Bvh>& surface = made_[{part, orientation}];
    if (!surface) {
        const ScaledPart scaled = part_of_(part);
        if (part != part_) plain_ = std::make_unique<const Bvh>(*scaled.mesh, false, stop);
        part_ = part;
        surface = std::make_shared<const Bvh>(plain_->turned(turn_of(scaled, orientation)));
    }
    return surface;
}

void PartSurfaces::make(const std::vector<TurnedPart>& wanted) {
    std::map<int, std::set<int>> missing;  // orientations by part
    for (const TurnedPart& turned : wanted) {
        if (!made_[turned]) missing[turned.part].insert(turned.orientation);
    }
    const std::vector<std::pair<int, std::set<int>>> parts(missing.begin(), missing.end());
    workers_.for_each(static_cast<std::int64_t>(parts.size()), [&](std::int64_t k) {
        const auto& [part, orientations] = parts[static_cast<std::size_t>(k)];
        const ScaledPart scaled = part_of_(part);
        const Bvh plain(*scaled.mesh);
        for (const int orientation : orientations) {
            made_.find({part, orientation})->second =
                std::make_shared<const Bvh>(plain.turned(turn_of(scaled, orientation)));
        }
    });
}

}  // namespace spectralpack
