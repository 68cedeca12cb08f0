#include "refine/refiner.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "geometry/mesh_distance.hpp"
#include "geometry/slide.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {

namespace {

constexpr double kProof = 1e-9;      ///< mm: the gap is proved to this in the end
constexpr double kLeastMove = 1e-9;  ///< mm: shorter ways are not worth going
constexpr int kRecoveries = 3;       ///< attempts to leave those that are too near
constexpr std::size_t kParts = 16;   ///< of a neighbour, that threads may share

Box grown(const Box& box, double by) {
    const Vec3 all{by, by, by};
    return {box.min - all, box.max + all};
}

/// One copy on its way.
class Walk {
  public:
    struct Neighbour {
        const PlacedSurface* copy;
        double gap;   ///< to keep from it
        double kept;  ///< min(gap, distance at the start)
    };

    Walk(const RefineOptions& options, const PlacedSurface& copy, std::vector<Neighbour> neighbours,
         const Workers& workers)
        : options_(options), start_(copy), at_(copy), neighbours_(std::move(neighbours)), workers_(workers) {}

    Refined run(const std::array<int, 3>& direction) {
        if (!measure()) return {start_.offset, 0, shortfall()};
        for (int i = 0; i < kRecoveries && shortfall() > kProof; ++i) {
            if (!recover()) break;
        }
        for (int round = 0; round < options_.rounds; ++round) {
            double way = 0;
            for (int axis = 0; axis < 3; ++axis) {
                if (direction[static_cast<std::size_t>(axis)] == 0) continue;
                way += move({axis, direction[static_cast<std::size_t>(axis)]}, options_.longest_move);
            }
            if (way == 0) break;  // nor would another round
        }
        if (!proved()) return {start_.offset, 0, shortfall()};
        return {at_.offset, way_, shortfall()};
    }

  private:
    /// Who may be met on a move, and how far away along it its box is.
    struct Reached {
        double from;
        const Neighbour* other;
    };

    double distance_to(const Neighbour& other) const {
        return least_distance(*at_.surface, at_.offset, *other.copy->surface, other.copy->offset, other.gap).distance;
    }

    /// How much of the gaps is kept here; false when a surface is crossed. (At gap 0 there is
    /// nothing to keep, and crossing is up to slide().)
    bool measure() {
        workers_.for_each(static_cast<std::int64_t>(neighbours_.size()), [&](std::int64_t i) {
            Neighbour& other = neighbours_[static_cast<std::size_t>(i)];
            other.kept = other.gap > 0 ? distance_to(other) : 0;
        });
        return std::all_of(neighbours_.begin(), neighbours_.end(),
                           [](const Neighbour& other) { return other.gap == 0 || other.kept > 0; });
    }

    double shortfall() const {
        double most = 0;
        for (const Neighbour& other : neighbours_) {
            most = std::max(most, other.gap - other.kept);
        }
        return most > kProof ? most : 0;
    }

    /// Away from the worst neighbour, along the axis that leads most directly. True if that helped.
    bool recover() {
        const auto worst =
            std::max_element(neighbours_.begin(), neighbours_.end(),
                             [](const Neighbour& a, const Neighbour& b) { return a.gap - a.kept < b.gap - b.kept; });
        const ClosestPoints nearest =
            least_distance(*at_.surface, at_.offset, *worst->copy->surface, worst->copy->offset, worst->gap);
        const Vec3 apart = nearest.apart();
        int axis = 0;
        for (int i = 1; i < 3; ++i) {
            if (std::abs(apart[i]) > std::abs(apart[axis])) axis = i;
        }
        const double slope = std::abs(apart[axis]) / nearest.distance;
        const double before = shortfall();
        move({axis, apart[axis] > 0 ? 1 : -1}, (worst->gap - worst->kept) / slope + kSlideSlack / 2);
        return measure() && shortfall() < before;
    }

    /// Up to the wall, the first contact or `longest`. Returns the way gone.
    double move(AxisDirection direction, double longest) {
        const int axis = direction.axis;
        const Box box = at_.box();
        const double room = direction.sign > 0 ? options_.container[axis] - options_.wall_gap - box.max[axis]
                                               : box.min[axis] - options_.wall_gap;
        double way = std::min(longest, room);
        if (!(way > kLeastMove)) return 0;
        Box swept = box;
        (direction.sign > 0 ? swept.max : swept.min)[axis] += direction.sign * way;
        std::atomic<const Neighbour*>& stopper = stoppers_[static_cast<std::size_t>(axis)];
        struct Part {
            const Neighbour* other;
            Vec3 offset;
            SlidePart part;
        };
        std::vector<Part> parts;
        for (const auto& [from, other] : reached(swept, direction, stopper)) {
            const Vec3 offset = at_.offset - other->copy->offset;
            for (const SlidePart& part :
                 slide_parts(*at_.surface, offset, *other->copy->surface, direction, other->kept, way, kParts)) {
                parts.push_back({other, offset, part});
            }
        }
        std::atomic<double> free = way;
        workers_.for_each_in_order(std::ssize(parts), [&](std::int64_t i) {
            const auto& [other, offset, part] = parts[static_cast<std::size_t>(i)];
            const double before = free;
            if (!(before > kLeastMove)) return;
            slide(*at_.surface, offset, *other->copy->surface, direction, other->kept, way, free, part);
            if (free < before) stopper = other;
        });
        way = free;
        if (!(way > kLeastMove)) return 0;
        at_.offset[axis] += direction.sign * way;
        way_ += way;
        return way;
    }

    /// Those that a move through `swept` may meet. In front who seems to have stopped the last move along this axis and
    /// so most likely stops this one too, then who is met first: that shortens the way for the others.
    std::vector<Reached> reached(const Box& swept, AxisDirection direction, const Neighbour* stopper) const {
        std::vector<Reached> all;
        const Box box = at_.box();
        const int axis = direction.axis;
        for (const Neighbour& other : neighbours_) {
            const Box there = other.copy->box();
            if (distance(swept, there) > other.kept + kSlideSlack) continue;
            const double from = direction.sign > 0 ? there.min[axis] - box.max[axis] : box.min[axis] - there.max[axis];
            all.push_back({&other == stopper ? -Box::kInfinity : from, &other});
        }
        std::ranges::stable_sort(all, {}, &Reached::from);
        return all;
    }

    /// The end again, by distances alone.
    bool proved() const {
        if (way_ == 0) return true;
        std::atomic<bool> kept = true;
        workers_.for_each(static_cast<std::int64_t>(neighbours_.size()), [&](std::int64_t i) {
            const Neighbour& other = neighbours_[static_cast<std::size_t>(i)];
            if (other.gap > 0 && kept && distance_to(other) < other.kept - kProof) kept = false;
        });
        return kept;
    }

    const RefineOptions& options_;
    const PlacedSurface& start_;
    PlacedSurface at_;
    std::vector<Neighbour> neighbours_;
    const Workers& workers_;
    std::array<std::atomic<const Neighbour*>, 3> stoppers_{};  // by axis; where threads meet, one that may be it
    double way_ = 0;
};

/// Where most copies will stand: a region to index.
Vec3 finite(const Vec3& container) {
    return {container.x, container.y, std::isfinite(container.z) ? container.z : std::max(container.x, container.y)};
}

}  // namespace

std::array<int, 3> descent(const std::array<Cost, 6>& neighbours) {
    std::array<int, 3> direction{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Cost& before = neighbours[2 * axis];
        const Cost& after = neighbours[2 * axis + 1];
        direction[axis] = after < before ? 1 : before < after ? -1 : 0;
    }
    return direction;
}

Refiner::Refiner(const RefineOptions& options) : options_(options), index_({Vec3{}, finite(options.container)}) {
    const Vec3& size = options.container;
    if (!std::isfinite(options.wall_gap) || options.wall_gap < 0) {
        throw UsageError("the wall gap must be a number of millimetres, 0 or more");
    }
    const double least = std::min({size.x, size.y, size.z});
    if (!(2 * options.wall_gap < least)) {
        throw UsageError("the wall gap leaves no room in the tray");
    }
    if (!std::isfinite(options.longest_move) || options.longest_move < 0 || options.rounds < 0 ||
        !std::isfinite(size.x + size.y) || std::isnan(size.z)) {
        throw InternalError("refinement: the options makes no sense");
    }
}

Refiner::CopyId Refiner::add(PlacedSurface copy) {
    if (!std::isfinite(copy.gap) || copy.gap < 0) {
        throw UsageError("a gap must be a number of millimetres, 0 or more");
    }
    const auto id = static_cast<CopyId>(copies_.size());
    index_.add(id, copy.box());
    largest_gap_ = std::max(largest_gap_, copy.gap);
    copies_.emplace_back(std::move(copy));
    return id;
}

void Refiner::remove(CopyId id) {
    const PlacedSurface* copy = find(id);
    if (!copy) throw InternalError("refinement: the copy to remove does not stand here");
    index_.remove(id, copy->box());
    copies_[static_cast<std::size_t>(id)].reset();
}

const PlacedSurface* Refiner::find(CopyId id) const {
    if (id < 0 || id >= static_cast<CopyId>(copies_.size())) return nullptr;
    const std::optional<PlacedSurface>& copy = copies_[static_cast<std::size_t>(id)];
    return copy ? &*copy : nullptr;
}

Refined Refiner::refine(const PlacedSurface& copy, const std::array<int, 3>& direction, const Workers& workers) const {
    if (!std::isfinite(copy.gap) || copy.gap < 0) {
        throw UsageError("a gap must be a number of millimetres, 0 or more");
    }
    // A millimetre more than the rounds can go: for the recovery.
    const double reach = options_.rounds * options_.longest_move + std::max(largest_gap_, copy.gap) + 1;
    const Box around = grown(copy.box(), reach);
    std::vector<Walk::Neighbour> neighbours;
    for (const CopyId id : index_.near(around)) {
        const PlacedSurface* other = find(id);
        if (distance(around, other->box()) > 0) continue;
        neighbours.push_back({other, other->wall ? other->gap : std::max(copy.gap, other->gap), 0});
    }
    return Walk(options_, copy, std::move(neighbours), workers).run(direction);
}

template <class Counts>
double Refiner::clearance_to(const PlacedSurface& copy, double upper_bound, const Counts& counts) const {
    std::vector<CopyId> ids;
    if (std::isfinite(upper_bound)) {
        ids = index_.near(grown(copy.box(), upper_bound));
    } else {
        ids.resize(copies_.size());
        for (std::size_t i = 0; i < ids.size(); ++i) {
            ids[i] = static_cast<CopyId>(i);
        }
    }
    double least = upper_bound;
    for (const CopyId id : ids) {
        const PlacedSurface* other = find(id);
        if (!other || other->wall || !counts(id)) continue;
        least = least_distance(*copy.surface, copy.offset, *other->surface, other->offset, least).distance;
    }
    return least;
}

double Refiner::clearance(const PlacedSurface& copy, double upper_bound, std::optional<CopyId> except) const {
    return clearance_to(copy, upper_bound, [&](CopyId id) { return id != except; });
}

std::optional<double> Refiner::least_gap(const Workers& workers) const {
    std::atomic<double> least = Box::kInfinity;
    workers.for_each(std::ssize(copies_), [&](std::int64_t id) {
        const PlacedSurface* copy = find(id);
        if (!copy || copy->wall) return;
        // Each pair once.
        lower(least, clearance_to(*copy, least, [&](CopyId other) { return other < id; }));
    });
    return std::isfinite(least) ? std::optional<double>(least) : std::nullopt;
}

}  // namespace spectralpack
