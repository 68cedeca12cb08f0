#include "packing/interlocking/reachable_search.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "disassembly/ways/reachable_region.hpp"
#include "packing/interlocking/samples.hpp"

namespace spectralpack {
namespace {

/// How much walks may remember, shared by all of a search.
class WalkMemory {
  public:
    WalkMemory(std::int64_t bytes, std::size_t walkers)
        : bytes_(bytes), share_(bytes / (2 * static_cast<std::int64_t>(std::max<std::size_t>(1, walkers)))) {}

    /// What one walker has grew from `before` to `now`. False where it should forget it: together they have too much,
    /// and this one more than half of its share.
    bool grow(std::int64_t before, std::int64_t now) { return (taken_ += now - before) <= bytes_ || now <= share_; }
    void forget(std::int64_t bytes) { taken_ -= bytes; }

  private:
    std::int64_t bytes_, share_;
    std::atomic<std::int64_t> taken_ = 0;
};

/// Where some voxels can be taken out from among all that stands.
struct Ways {
    std::shared_ptr<const BitGrid> solid;
    std::unique_ptr<FreeTileReader> tiles;
    // None: nothing was asked so far.
    std::optional<Outlines> outlines;
    std::optional<ReachableRegion> region;

    bool lead_out(const VoxelIndex& from, const Outlines& standing, const Extent& around, const StopToken& stop,
                  WalkMemory& memory) {
        if (!outlines) outlines.emplace(*solid);
        const std::int64_t before = region ? region->bytes() : 0;
        if (!region) {
            region.emplace(*tiles, solid->extent(), whole(around), stop,
                           [this, &standing](const VoxelIndex& q) { return outlines->leave(standing, q); });
        }
        const bool way = region->contains(from);
        if (!memory.grow(before, region->bytes())) {
            memory.forget(region->bytes());
            region.reset();
        }
        return way;
    }
};

/// What is known of one orientation's positions.
struct Known {
    std::mutex mutex;
    Ways of_sample, of_solid;  // no sample where it would be the whole solid
};

}  // namespace

void ReachableSearch::forget() {
    finest_.reset();
    outlines_.reset();
    engine_.forget();
}

SearchResult ReachableSearch::best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                             const StopToken& stop) {
    const Tray& fine = finest(tray);
    const int s = tray.detail(), margin = walls_ ? walls_->margin : 0;
    const Outlines& standing = outlines(fine);
    std::vector<Known> known(shape.orientations.size());
    WalkMemory memory(kept_, 2 * known.size());
    const auto read = [&](std::shared_ptr<const BitGrid> voxels, Ways& ways) {
        ways.tiles = engine_.free_tiles(fine, voxels, {});
        ways.solid = std::move(voxels);
    };
    for (std::size_t i = 0; i < known.size(); ++i) {
        const OrientedShape& oriented = shape.orientations[i];
        if (tray.candidates(oriented.reach).empty()) continue;
        const std::shared_ptr<const BitGrid> solid = (s == 1 ? oriented.solid : oriented.fine).share();
        read(solid, known[i].of_solid);
        auto sample = std::make_shared<const BitGrid>(row_sample(*solid, rows_along_));
        if (*sample != *solid) read(std::move(sample), known[i].of_sample);
    }
    Shape asked = shape;
    asked.id |= kReachableIds;
    asked.admits = [&](int index, const VoxelIndex& q) {
        const VoxelIndex start{s * q.x + margin, s * q.y + margin, s * q.z + margin};
        Known& of = known[static_cast<std::size_t>(index)];
        const std::lock_guard lock(of.mutex);
        // Where some of it does not come out, neither does all of it, and that takes fewer look-ups.
        if (of.of_sample.tiles && !of.of_sample.lead_out(start, standing, fine.extent(), stop, memory)) return false;
        return of.of_solid.lead_out(start, standing, fine.extent(), stop, memory);
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
    // Ids are given in the order of the changes; the walls come first.
    const int first = walls_ ? 1 : 0;
    for (auto i = static_cast<std::size_t>(finest_->version()) - static_cast<std::size_t>(first);
         i < tray.changes().size(); ++i) {
        const TrayChange& change = tray.changes()[i];
        if (!change.added) {
            finest_->remove(change.id + first);
            continue;
        }
        const TrayObject object = on_finest(tray.object(change.id));
        finest_->add(walls_ ? walls_->moved(object) : object);
    }
    return *finest_;
}

const Outlines& ReachableSearch::outlines(const Tray& fine) {
    const std::vector<TrayChange>& changes = fine.changes();
    const auto known = [&] { return changes.begin() + static_cast<std::ptrdiff_t>(outlined_version_); };
    const auto removed = [](const TrayChange& change) { return !change.added; };
    if (!outlines_ || outlined_ != fine.instance() || std::any_of(known(), changes.end(), removed)) {
        outlines_.emplace(fine.omega_move(whole(fine.extent()), std::nullopt));
        outlined_ = fine.instance();
    } else {
        for (auto change = known(); change != changes.end(); ++change) {
            const TrayObject& object = fine.object(change->id);
            outlines_->join(Outlines(*object.solid), object.position);
        }
    }
    outlined_version_ = changes.size();
    return *outlines_;
}

}  // namespace spectralpack
