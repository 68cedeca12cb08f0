#include "packing/unlinked_search.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "disassembly/reachable_region.hpp"
#include "packing/row_sample.hpp"

namespace spectralpack {
namespace {

constexpr int kRowsAlong = 30;  // so many and more of a solid are taken

/// A tray that the object alone stands in, as large as its box.
Tray tray_around(TrayObject object) {
    const Extent& box = object.solid->extent();
    TraySetup setup;
    setup.voxel_size = 1;
    setup.size = {static_cast<double>(box.x), static_cast<double>(box.y), static_cast<double>(box.z)};
    Tray tray(setup);
    object.position = {};
    object.gap_class = 0;
    tray.add(std::move(object));
    return tray;
}

/// Where one orientation's voxels can be moved to past one object.
struct Ways {
    std::unique_ptr<FreeTileReader> tiles;
    ReachableRegion region;
    std::int64_t bytes;  // about: a reader keeps nearly a byte for each voxel of the object's box, a walk little

    Ways(std::unique_ptr<FreeTileReader> reader, const Extent& solid, const Extent& around, const StopToken& stop)
        : tiles(std::move(reader)),
          region(*tiles, solid, whole(around), stop),
          bytes(around.count() + tiles->extent().count() / 16) {}
};

}  // namespace

BitGrid link_sample(const BitGrid& solid) { return row_sample(solid, kRowsAlong); }

/// What is found out during one search; asked by several threads.
class UnlinkedSearch::Asking {
  public:
    Asking(UnlinkedSearch& owner, const Tray& tray, const Shape& shape, const StopToken& stop)
        : owner_(owner), tray_(tray), shape_(shape), stop_(stop), moving_(shape.orientations.size()) {
        for (ObjectId id = 0; id < tray.object_count(); ++id) {
            if (tray.find(id)) standing_.push_back({id, on_finest(tray.object(id)).box()});
        }
    }

    bool unlinked(int index, const VoxelIndex& q) {
        Moving& moving = moving_[static_cast<std::size_t>(index)];
        const std::lock_guard lock(moving.mutex);
        if (!moving.sample) {
            const OrientedShape& oriented = shape_.orientations[static_cast<std::size_t>(index)];
            const BitGrid& solid = *(tray_.detail() == 1 ? oriented.solid : oriented.fine);
            moving.sample = std::make_shared<const BitGrid>(link_sample(solid));
            moving.outlines = std::make_unique<const Outlines>(solid);
        }
        const int s = tray_.detail();
        const Extent& solid = moving.sample->extent();
        const VoxelIndex at{s * q.x, s * q.y, s * q.z};
        const VoxelBox box{at, at + VoxelIndex{solid.x, solid.y, solid.z}};
        for (const Standing& object : standing_) {
            if (intersection(box, object.box).empty()) continue;
            const VoxelIndex beside = at - object.box.lo;
            if (moving.outlines->leave(outlines(object.id), beside)) continue;
            if (!way_past(object.id, moving, beside)) return false;
        }
        return true;
    }

  private:
    struct Standing {
        ObjectId id;
        VoxelBox box;  // in the voxels that collisions are decided on
    };
    /// An orientation.
    struct Moving {
        std::mutex mutex;
        std::shared_ptr<const BitGrid> sample;  // of its voxels; null: not asked about so far
        std::unique_ptr<const Outlines> outlines;
        std::map<ObjectId, std::unique_ptr<Ways>> past;
        std::int64_t bytes = 0;  // of them
    };

    const Outlines& outlines(ObjectId id) {
        const std::lock_guard lock(making_);
        const auto known = owner_.outlines_.find(id);
        if (known != owner_.outlines_.end()) return known->second;
        const Outlines& made = owner_.outlines_.emplace(id, *on_finest(tray_.object(id)).solid).first->second;
        owner_.outlines_bytes_ += made.bytes();
        return made;
    }

    bool way_past(ObjectId id, Moving& moving, const VoxelIndex& from) {
        std::unique_ptr<Ways>& ways = moving.past[id];
        if (!ways) {
            ways = make_ways(id, moving);
            moving.bytes += ways->bytes;
            ways_bytes_ += ways->bytes;
        }
        const bool way = ways->region.contains(from);
        if (ways_bytes_ > kKeptInSearch) {
            ways_bytes_ -= std::exchange(moving.bytes, 0);
            moving.past.clear();
        }
        return way;
    }

    std::unique_ptr<Ways> make_ways(ObjectId id, const Moving& moving) {
        const std::lock_guard lock(making_);
        auto alone = alone_.find(id);
        if (alone == alone_.end()) {
            alone = alone_.emplace(id, tray_around(on_finest(tray_.object(id)))).first;
        }
        const Tray& around = alone->second;
        return std::make_unique<Ways>(owner_.engine_.free_tiles(around, moving.sample, {.once = true}),
                                      moving.sample->extent(), around.extent(), stop_);
    }

    UnlinkedSearch& owner_;
    const Tray& tray_;
    const Shape& shape_;
    StopToken stop_;
    std::vector<Standing> standing_;
    std::vector<Moving> moving_;  // by orientation
    std::mutex making_;           // guards what follows, and what is the owner's
    std::map<ObjectId, Tray> alone_;
    std::atomic<std::int64_t> ways_bytes_ = 0;
};

SearchResult UnlinkedSearch::best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                            const StopToken& stop) {
    if (followed_ != tray.instance() || outlines_bytes_ > kKept) {
        followed_ = tray.instance();
        outlines_.clear();
        outlines_bytes_ = 0;
    }
    Asking asking(*this, tray, shape, stop);
    Shape asked = shape;
    asked.id |= kUnlinkedIds;
    asked.admits = [&](int index, const VoxelIndex& q) { return asking.unlinked(index, q); };
    return engine_.best_placement(tray, asked, model, stop);
}

}  // namespace spectralpack
