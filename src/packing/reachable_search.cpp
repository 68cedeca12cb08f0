#include "packing/reachable_search.hpp"

#include <memory>
#include <mutex>
#include <vector>

#include "disassembly/reachable_region.hpp"

namespace spectralpack {
namespace {

/// What is known of one orientation's positions.
struct Known {
    std::mutex mutex;
    Extent solid;
    std::unique_ptr<FreeTileReader> tiles;
    std::unique_ptr<ReachableRegion> region;  // null: none of its positions was asked about
};

}  // namespace

SearchResult ReachableSearch::best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                             const StopToken& stop) {
    const Tray& fine = finest(tray);
    const int s = tray.detail(), margin = walls_ ? walls_->margin : 0;
    std::vector<Known> known(shape.orientations.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
        const OrientedShape& oriented = shape.orientations[i];
        if (tray.candidates(oriented.size).empty()) continue;
        const std::shared_ptr<const BitGrid>& solid = s == 1 ? oriented.solid : oriented.fine;
        known[i].solid = solid->extent();
        known[i].tiles = engine_.free_tiles(fine, solid, {});
    }
    Shape asked = shape;
    asked.id |= kReachableIds;
    asked.admits = [&](int index, const VoxelIndex& q) {
        Known& of = known[static_cast<std::size_t>(index)];
        const std::lock_guard lock(of.mutex);
        if (!of.region) of.region = std::make_unique<ReachableRegion>(*of.tiles, of.solid, whole(fine.extent()), stop);
        return of.region->contains({s * q.x + margin, s * q.y + margin, s * q.z + margin});
    };
    return engine_.best_placement(tray, asked, model, stop);
}

const Tray& ReachableSearch::finest(const Tray& tray) {
    if (tray.detail() == 1 && !walls_) return tray;
    if (!finest_ || followed_ != tray.instance()) {
        finest_.emplace(walls_ ? walls_->grid : finest_setup(tray.setup()));
        if (walls_) finest_->add(walls_->part.object);
        followed_ = tray.instance();
    }
    // Ids are given in the order of the journal; the walls come first.
    const int first = walls_ ? 1 : 0;
    for (auto i = static_cast<std::size_t>(finest_->version()) - static_cast<std::size_t>(first);
         i < tray.journal().size(); ++i) {
        const TrayChange& change = tray.journal()[i];
        if (!change.added) {
            finest_->remove(change.id + first);
            continue;
        }
        const TrayObject object = on_finest(tray.object(change.id));
        finest_->add(walls_ ? walls_->moved(object) : object);
    }
    return *finest_;
}

}  // namespace spectralpack
