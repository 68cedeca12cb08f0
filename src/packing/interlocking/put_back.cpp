#include "packing/interlocking/put_back.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <unordered_set>
#include <utility>

#include "core/stopped.hpp"
#include "packing/interlocking/reachable_search.hpp"
#include "packing/interlocking/removable_packing.hpp"
#include "packing/tray/greedy.hpp"

namespace spectralpack {
namespace {

/// A position of an orientation of a shape.
struct Place {
    int index;  ///< in Shape::orientations
    VoxelIndex position;
};
using Places = std::vector<Place>;

// Where a copy does not come out it is tried elsewhere, up to so many places in all. More find none that these do not.
constexpr int kPlacesTried = 4;

/// Whether a copy's boxes there have their centres less than half a box from each other along every axis.
bool in_same_hole(const Shape& shape, const Place& a, const Place& b) {
    const Extent& at_a = shape.orientations[static_cast<std::size_t>(a.index)].solid.extent();
    const Extent& at_b = shape.orientations[static_cast<std::size_t>(b.index)].solid.extent();
    for (int axis = 0; axis < 3; ++axis) {
        const int twice = 2 * (a.position[axis] - b.position[axis]) + at_a[axis] - at_b[axis];
        if (std::abs(twice) >= std::min(at_a[axis], at_b[axis])) return false;
    }
    return true;
}

class PuttingBack {
  public:
    PuttingBack(const TrayRepair& repair, PutBackWish wish)
        : tray_(repair.tray),
          placed_(repair.placed),
          context_(repair.context),
          options_(repair.options),
          wish_(std::move(wish)),
          packing_(repair.bodies, wish_.steps),
          reachable_(context_.search, options_.walls),
          // Without a ceiling there is always one that can be reached, and others take long to find.
          most_places_(is_open() ? 1 : kPlacesTried) {}

    PutBackResult run() {
        std::vector<Copy> copies = std::move(wish_.copies);
        sort(copies);
        ShapeStore& shapes = context_.shapes;
        const StopToken& stop = context_.stop;
        shapes.start_tray(copies, ShapeStore::kAheadOfWays);
        std::unordered_set<int> hopeless;
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const bool was_taken_out = wish_.taken_out.contains(copies[i]);
            const bool again = !stop.stopped() && !hopeless.contains(copies[i].part) &&
                               try_put_in(shapes, i, copies[i], was_taken_out);
            if (!again) {
                hopeless.insert(copies[i].part);
                if (was_taken_out && !stop.stopped()) result_.interlocked.push_back(copies[i]);
            } else {
                tell(was_taken_out);
                ++(was_taken_out ? result_.put_back : result_.added);
            }
            shapes.release(i, again);
            options_.to_put_back(static_cast<int>(copies.size() - i - 1), static_cast<int>(copies.size()));
        }
        result_.steps = packing_.steps();
        result_.fills = packing_.fills();
        return std::move(result_);
    }

  private:
    bool is_open() const { return tray_.setup().ceiling == Ceiling::open; }

    /// In the order of the job.
    void sort(std::vector<Copy>& copies) const {
        std::map<Copy, std::size_t> rank;
        for (const Copy& copy : options_.order) {
            rank.emplace(copy, rank.size());
        }
        std::stable_sort(copies.begin(), copies.end(), [&](const Copy& a, const Copy& b) { return rank[a] < rank[b]; });
    }

    /// Of the copy that was put in last.
    void tell(bool was_taken_out) const {
        if (!context_.observer) return;
        if (was_taken_out) {
            context_.observer->copy_put_back(placed_.back());
        } else {
            context_.observer->copy_placed(placed_.back());
        }
    }

    /// A copy that had no room before has some only where something was taken out, unless caps or a ceiling that goes
    /// up make room elsewhere.
    Shape asked(const Shape& shape, bool was_taken_out) const {
        Shape asked = shape;
        const bool full = options_.waiting_had_no_room && !context_.limits.caps && !is_open();
        if (full && !was_taken_out) asked.only_near = wish_.freed;
        return asked;
    }

    bool try_put_in(ShapeStore& shapes, std::size_t i, const Copy& copy, bool was_taken_out) {
        try {
            return put_in(copy, asked(shapes.at(i), was_taken_out));
        } catch (const Stopped&) {  // while its voxels were made
            return false;
        }
    }

    bool put_in(const Copy& copy, const Shape& shape) {
        const Caps* caps = context_.limits.caps;
        if (caps && !caps->why_not(copy.part).empty()) return false;
        const auto place_of = [&](PlacementSearch& search, const Shape& wanted) {
            return find_place(tray_, search, context_, copy, wanted).best;
        };
        PlacementSearch& best_search = options_.best ? *options_.best : context_.search;
        Places& refused = refused_[copy.part];
        Shape elsewhere = shape;
        elsewhere.admits = [&](int index, const VoxelIndex& q) {
            return std::ranges::none_of(refused, [&](const Place& place) {
                return in_same_hole(shape, place, {index, q});
            });
        };
        int tried = 0;
        for (; tried < most_places_; ++tried) {
            const std::optional<BestPlacement> best = place_of(best_search, refused.empty() ? shape : elsewhere);
            if (!best) break;
            if (put_at(*best, copy, shape)) return true;
            if (most_places_ > 1) refused.push_back({best->index, best->position});
        }
        if (tried == 0 && refused.empty()) return false;  // there is no place at all
        const std::optional<BestPlacement> best = place_of(reachable_, shape);
        return best && put_at(*best, copy, shape);
    }

    bool put_at(const BestPlacement& place, const Copy& copy, const Shape& shape) {
        Settled settled = settle_on_grid(shape, place, options_.voxel_size, tray_.detail(), options_.wall_gap);
        const int orientation = shape.orientations[static_cast<std::size_t>(place.index)].orientation;
        PlacedCopy placed{copy, orientation, place.position, settled.offset, 0, place.cost};
        placed_.push_back(placed);
        if (!packing_.admit(placed, settled.object)) {
            placed_.pop_back();
            return false;
        }
        // Not before: engines keep what they know while objects are only added.
        placed_.back().object = tray_.add(std::move(settled.object));
        if (Caps* caps = context_.limits.caps) caps->add(copy.part, orientation, placed.offset);
        return true;
    }

    Tray& tray_;
    std::vector<PlacedCopy>& placed_;
    const TrayContext& context_;
    const UntangleOptions& options_;
    PutBackWish wish_;
    RemovablePacking packing_;
    ReachableSearch reachable_;
    std::map<int, Places> refused_;  // by part: where one copy did not come out, another does not
    int most_places_;                // tried of each copy; where it is 1, none are called refused
    PutBackResult result_;
};

}  // namespace

PutBackResult put_back(const TrayRepair& repair, PutBackWish wish) {
    return PuttingBack(repair, std::move(wish)).run();
}

}  // namespace spectralpack
