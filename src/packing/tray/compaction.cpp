#include "packing/tray/compaction.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

namespace spectralpack {
namespace {

constexpr double kWorth = 0.01;     // mm: a sweep in which no copy sinks so far was the last
constexpr double kEnough = 0.1;     // mm: who sinks so far looks no further
constexpr double kUpperPart = 0.5;  // of the height: copies below make way for few that matter
constexpr std::array<int, 3> kDown[]{{0, 0, -1}};
constexpr std::array<int, 3> kSideways[]{{1, 0, -1}, {-1, 0, -1}, {0, 1, -1}, {0, -1, -1}};

class Compaction {
  public:
    Compaction(const CompactionOptions& options, PartSurfaces& surfaces, Caps* caps, std::vector<PlacedCopy>& placed,
               const Workers& workers, const StopToken& stop)
        : options_(options),
          surfaces_(surfaces),
          caps_(caps),
          placed_(placed),
          workers_(workers),
          stop_(stop),
          refiner_(options.refine) {
        for (const PlacedSurface& obstacle : options.standing) {
            refiner_.add(obstacle);
        }
        for (const PlacedCopy& copy : placed) {
            ids_.push_back(refiner_.add(surface_of(copy)));
        }
    }

    bool run() {
        sweeps(options_.sweeps);
        for (int i = 0; i < options_.sideways && sweep(kSideways, kUpperPart * top()); ++i) {
            sweeps(options_.sweeps);
        }
        return moved_;
    }

  private:
    using Directions = std::span<const std::array<int, 3>>;

    PlacedSurface surface_of(const PlacedCopy& copy) const {
        return {surfaces_.at(copy.copy.part, copy.orientation), copy.offset, surfaces_.part(copy.copy.part).gap};
    }
    Box box_of(std::size_t i) const { return refiner_.find(ids_[i])->box(); }

    double top() const {
        double top = 0;
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            top = std::max(top, box_of(i).max.z);
        }
        return top;
    }

    void sweeps(int most) {
        for (int i = 0; i < most && sweep(kDown, 0); ++i) {
        }
    }

    /// Moves all copies that reach above `above`, from the lowest on. True where that was worth it.
    bool sweep(Directions directions, double above) {
        std::vector<std::size_t> order(placed_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return box_of(i).min.z; });
        double most = 0;
        for (const std::size_t i : order) {
            if (stop_.stopped()) return false;
            if (box_of(i).max.z > above) most = std::max(most, move(i, directions));
        }
        return most > kWorth;
    }

    /// In the first of `directions` that lets the copy sink enough, or where it sinks most. Returns how far it sinks.
    double move(std::size_t i, Directions directions) {
        PlacedSurface copy = *refiner_.find(ids_[i]);
        refiner_.remove(ids_[i]);
        Vec3 best = copy.offset;
        for (const std::array<int, 3>& direction : directions) {
            const Vec3 there = refiner_.refine(copy, direction, workers_).offset;
            if (there.z < best.z) best = there;
            if (copy.offset.z - best.z > kEnough) break;
        }
        double sunk = copy.offset.z - best.z;
        if (sunk > 0 && may_stand(placed_[i], best)) {
            placed_[i].offset = copy.offset = best;
            moved_ = true;
        } else {
            sunk = 0;
        }
        ids_[i] = refiner_.add(std::move(copy));
        return sunk;
    }

    /// If so, the caps have it there now.
    bool may_stand(const PlacedCopy& placed, const Vec3& offset) {
        if (!caps_) return true;
        const auto& [part, number] = placed.copy;
        caps_->remove(part, placed.orientation, placed.offset);
        const bool may = caps_->may_stand(part, placed.orientation, offset);
        caps_->add(part, placed.orientation, may ? offset : placed.offset);
        return may;
    }

    const CompactionOptions& options_;
    PartSurfaces& surfaces_;
    Caps* caps_;
    std::vector<PlacedCopy>& placed_;
    const Workers& workers_;
    const StopToken& stop_;
    Refiner refiner_;
    std::vector<Refiner::CopyId> ids_;  // by place in what is placed
    bool moved_ = false;
};

}  // namespace

bool compact(const CompactionOptions& options, PartSurfaces& surfaces, Caps* caps, std::vector<PlacedCopy>& placed,
             const Workers& workers, const StopToken& stop) {
    std::vector<TurnedPart> turned;
    for (const PlacedCopy& copy : placed) {
        turned.push_back({copy.copy.part, copy.orientation});
    }
    surfaces.make(turned);
    return Compaction(options, surfaces, caps, placed, workers, stop).run();
}

double top_of(const std::vector<PlacedCopy>& placed, PartSurfaces& surfaces) {
    double top = 0;
    for (const PlacedCopy& copy : placed) {
        top = std::max(top, surfaces.at(copy.copy.part, copy.orientation)->box().max.z + copy.offset.z);
    }
    return top;
}

}  // namespace spectralpack
