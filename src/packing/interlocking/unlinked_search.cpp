#include "packing/interlocking/unlinked_search.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "disassembly/ways/reachable_region.hpp"
#include "packing/interlocking/samples.hpp"

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

/// Such a tray.
struct Alone {
    Tray tray;
    int counted = -1;  ///< the round in which bytes() were

    explicit Alone(TrayObject object) : tray(tray_around(std::move(object))) {}

    /// Of what readers share, about: of 64 voxels they keep two words in each of five tables.
    std::int64_t bytes() const { return 2 * tray.extent().count(); }
};

/// Where one orientation's voxels can be moved to past one object, or the cells of them.
struct WaysOut {
    std::unique_ptr<FreeTileReader> tiles;
    ReachableRegion region;

    WaysOut(std::unique_ptr<FreeTileReader> reader, const Extent& solid, const Extent& around, const StopToken& stop,
            ReachableRegion::StraightOut straight_out)
        : tiles(std::move(reader)), region(*tiles, solid, whole(around), stop, std::move(straight_out)) {}
};

}  // namespace

BitGrid link_sample(const BitGrid& solid) { return row_sample(solid, kRowsAlong); }

/// What a shape looks like in one orientation, and past whom it is known to leave. That depends on nothing but the two
/// solids and how they stand to each other, so it holds in any tray.
struct UnlinkedSearch::Form {
    /// A solid that stands, and where the shape is beside it.
    struct Pose {
        const BitGrid* standing;
        VoxelIndex beside;

        bool operator==(const Pose&) const = default;
    };
    struct PoseHash {
        std::size_t operator()(const Pose& pose) const {
            std::size_t hash = std::hash<const void*>()(pose.standing);
            for (const int value : {pose.beside.x, pose.beside.y, pose.beside.z}) {
                hash = (hash ^ static_cast<std::size_t>(value)) * 0x9e3779b97f4a7c15u;
            }
            return hash ^ (hash >> 32);
        }
    };

    std::mutex mutex;
    std::shared_ptr<const BitGrid> sample, in_cells;  // of its voxels; null: not asked about so far
    std::shared_ptr<const Outlines> outlines;
    std::unordered_map<Pose, bool, PoseHash> leaves;  // of poses that a walk was needed for

    static constexpr std::int64_t kBytesOfPose = 64;
};

/// Ways of one shape past the objects of one tray; copies of a part are asked about one after the other.
struct UnlinkedSearch::Known {
    /// Past one object; null: not asked about so far.
    struct Past {
        std::unique_ptr<WaysOut> of_cells, of_voxels;
    };
    /// An orientation.
    struct Moving {
        std::map<ObjectId, Past> past;
        int round = 0;  // in which they were made
    };

    explicit Known(const Shape& of) : shape(of.id), moving(of.orientations.size()) {}

    std::uint64_t shape;
    std::map<ObjectId, Alone> cells, voxels;  // of objects; as long as readers of them
    std::vector<Moving> moving;               // by orientation, guarded by its form's mutex
    std::atomic<std::int64_t> bytes = 0;      // of ways and of what readers share
    std::atomic<int> round = 0;  // when there are too many of them, all ways of earlier rounds are forgotten
};

/// One search: asked by several threads.
class UnlinkedSearch::Asking {
  public:
    Asking(UnlinkedSearch& owner, const Tray& tray, const Shape& shape, const StopToken& stop)
        : owner_(owner), known_(*owner.known_), tray_(tray), shape_(shape), stop_(stop) {
        std::vector<std::unique_ptr<Form>>& forms = owner.forms_[shape.id];
        while (forms.size() < shape.orientations.size()) {
            forms.push_back(std::make_unique<Form>());
        }
        forms_ = &forms;
        for (ObjectId id = 0; id < tray.object_count(); ++id) {
            if (!tray.find(id)) continue;
            const TrayObject object = on_finest(tray.object(id));
            standing_.push_back({id, object.box(), object.solid});
        }
    }

    bool unlinked(int index, const VoxelIndex& q) {
        Form& form = *(*forms_)[static_cast<std::size_t>(index)];
        const std::lock_guard lock(form.mutex);
        if (!form.sample) make(form, index);
        const int s = tray_.detail();
        const Extent& solid = form.sample->extent();
        const VoxelIndex at{s * q.x, s * q.y, s * q.z};
        const VoxelBox box{at, at + VoxelIndex{solid.x, solid.y, solid.z}};
        for (const StandingObject& object : standing_) {
            if (intersection(box, object.box).empty()) continue;
            const VoxelIndex beside = at - object.box.lo;
            const std::shared_ptr<const Outlines> outlines = outlines_of(object);
            if (form.outlines->leave(*outlines, beside)) continue;
            if (!way_past(object, outlines, form, index, beside)) return false;
        }
        return true;
    }

  private:
    struct StandingObject {
        ObjectId id;
        VoxelBox box;  // in the voxels that collisions are decided on
        std::shared_ptr<const BitGrid> solid;
    };

    void make(Form& form, int index) {
        const OrientedShape& oriented = shape_.orientations[static_cast<std::size_t>(index)];
        const BitGrid& solid = tray_.detail() == 1 ? *oriented.solid : *oriented.fine;
        form.sample = std::make_shared<const BitGrid>(link_sample(solid));
        form.in_cells = std::make_shared<const BitGrid>(sample_in_cells(*form.sample));
        form.outlines = std::make_shared<const Outlines>(solid);
        owner_.bytes_ +=
            form.sample->extent().count() / 8 + form.in_cells->extent().count() / 8 + form.outlines->bytes();
    }

    std::shared_ptr<const Outlines> outlines_of(const StandingObject& object) {
        const std::lock_guard lock(making_);
        Standing& standing = owner_.standing_[object.solid.get()];
        if (!standing.outlines) {
            standing = {object.solid, std::make_shared<const Outlines>(*object.solid)};
            owner_.bytes_ += standing.outlines->bytes();
        }
        return standing.outlines;
    }

    bool way_past(const StandingObject& object, const std::shared_ptr<const Outlines>& outlines, Form& form, int index,
                  const VoxelIndex& from) {
        const Form::Pose pose{object.solid.get(), from};
        if (const auto seen = form.leaves.find(pose); seen != form.leaves.end()) return seen->second;
        Known::Moving& moving = known_.moving[static_cast<std::size_t>(index)];
        if (moving.round != known_.round) {
            moving.round = known_.round;
            moving.past.clear();
        }
        Known::Past& past = moving.past[object.id];
        // Where there is no way from cell to cell, there is none, and that takes a sixteenth of the look-ups.
        const bool way =
            leads_out(past.of_cells, cell_of(from), [&] { return make_ways(object.id, form, true, {}); }) &&
            leads_out(past.of_voxels, from, [&] {
                return make_ways(object.id, form, false, [moved = form.outlines, outlines](const VoxelIndex& at) {
                    return moved->leave(*outlines, at);
                });
            });
        if (known_.bytes > owner_.kept_.walks) {
            known_.bytes = 0;
            ++known_.round;
        }
        if (!stop_.stopped()) {  // walks that were stopped say nothing
            form.leaves.emplace(pose, way);
            owner_.bytes_ += Form::kBytesOfPose;
        }
        return way;
    }

    /// Whether `ways`, which are made when they are first asked, lead out from there.
    template <class Make>
    bool leads_out(std::unique_ptr<WaysOut>& ways, const VoxelIndex& from, const Make& make) {
        const std::int64_t before = ways ? ways->region.bytes() : 0;
        if (!ways) ways = make();
        const bool way = ways->region.contains(from);
        known_.bytes += ways->region.bytes() - before;
        return way;
    }

    std::unique_ptr<WaysOut> make_ways(ObjectId id, const Form& form, bool in_cells,
                                       ReachableRegion::StraightOut straight_out) {
        const std::lock_guard lock(making_);
        std::map<ObjectId, Alone>& all = in_cells ? known_.cells : known_.voxels;
        auto alone = all.find(id);
        if (alone == all.end()) {
            TrayObject object = on_finest(tray_.object(id));
            if (in_cells) object.solid = std::make_shared<const BitGrid>(object_in_cells(*object.solid));
            alone = all.emplace(id, std::move(object)).first;
        }
        const int round = known_.round;
        if (std::exchange(alone->second.counted, round) != round) known_.bytes += alone->second.bytes();
        const Tray& around = alone->second.tray;
        const std::shared_ptr<const BitGrid>& sample = in_cells ? form.in_cells : form.sample;
        return std::make_unique<WaysOut>(owner_.engine_.free_tiles(around, sample, {.for_readers = true}),
                                         sample->extent(), around.extent(), stop_, std::move(straight_out));
    }

    UnlinkedSearch& owner_;
    Known& known_;
    const Tray& tray_;
    const Shape& shape_;
    StopToken stop_;
    std::vector<std::unique_ptr<Form>>* forms_;  // by orientation
    std::vector<StandingObject> standing_;
    std::mutex making_;  // guards the trays of the known and what stands
};

UnlinkedSearch::UnlinkedSearch(PlacementSearch& engine) : ForwardingSearch(engine) {}
UnlinkedSearch::~UnlinkedSearch() = default;

void UnlinkedSearch::forget() {
    forget_poses();
    known_.reset();
    engine_.forget();
}

void UnlinkedSearch::forget_poses() {
    forms_.clear();
    standing_.clear();
    bytes_ = 0;
}

SearchResult UnlinkedSearch::best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                            const StopToken& stop) {
    const bool another = followed_ != tray.instance();
    if (another) kept_ = kept_in(tray.extent().count() * part_count(tray.detail()));
    followed_ = tray.instance();
    if (bytes_ > std::max(answers_, kept_.outlines)) forget_poses();
    if (another || !known_ || known_->shape != shape.id) known_ = std::make_unique<Known>(shape);
    Asking asking(*this, tray, shape, stop);
    Shape asked = shape;
    asked.id |= kUnlinkedIds;
    asked.admits = [&](int index, const VoxelIndex& q) {
        return (!shape.admits || shape.admits(index, q)) && asking.unlinked(index, q);
    };
    SearchResult result = engine_.best_placement(tray, asked, model, stop);
    if (stop.stopped()) known_.reset();  // walks that were stopped say nothing
    return result;
}

std::unique_ptr<PlacementSearch> make_unlinked_search(std::unique_ptr<PlacementSearch> engine) {
    struct Owner {
        std::unique_ptr<PlacementSearch> owned;
    };
    class Owning final : private Owner, public UnlinkedSearch {
      public:
        explicit Owning(std::unique_ptr<PlacementSearch> own) : Owner{std::move(own)}, UnlinkedSearch(*owned) {}
    };
    return std::make_unique<Owning>(std::move(engine));
}

}  // namespace spectralpack
