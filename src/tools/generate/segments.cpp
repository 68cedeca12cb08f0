#include "tools/generate/segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/mesh_bodies.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/plane_cut.hpp"
#include "spectralpack/error.hpp"
#include "tools/generate/dice.hpp"

namespace spectralpack::tools {
namespace {

constexpr double kCrumb = 1e-3;     // of what is cut: a body that is smaller
constexpr double kMove = 1e-3;      // of what is cut: how far a plane moves to keep clear of vertices
constexpr double kMargin = 1e-3;    // mm of the room that pieces leave, where there is some to leave
constexpr int kPlaces = 9;          // along an axis that are tried
constexpr int kDirections = 12;     // of planes that are tried
constexpr double kAslant = 0.3;     // how far directions turn aside
constexpr double kOffCentre = 0.1;  // of the extent
constexpr double kFairShare = 0.3;  // of the volume for the smaller piece

/// What a cut leaves, and how good that is.
struct Trial {
    std::vector<Mesh> bodies;
    double smallest = 0;  // of their volumes, as a share of what was cut
    double longest = 0;   // mm, of their boxes' diagonals
};

Trial trial_of(const Mesh& mesh, const Plane& plane) {
    const CutMesh cut = cut_mesh(mesh, plane);
    Trial trial{bodies_of(cut.below), 1, 0};
    std::vector<Mesh> above = bodies_of(cut.above);
    std::move(above.begin(), above.end(), std::back_inserter(trial.bodies));
    const double whole = signed_volume(mesh);
    for (const Mesh& body : trial.bodies) {
        trial.smallest = std::min(trial.smallest, signed_volume(body) / whole);
        trial.longest = std::max(trial.longest, length(bounding_box(body).size()));
    }
    return trial;
}

/// As it is written.
double in_single(double coordinate) { return static_cast<double>(static_cast<float>(coordinate)); }

Vec3 written_size(const Mesh& mesh) {
    const Box box = bounding_box(mesh);
    Vec3 size;
    for (int axis = 0; axis < 3; ++axis) {
        size[axis] = in_single(box.max[axis]) - in_single(box.min[axis]);
    }
    return size;
}

/// Axes by the lengths along them, the shortest first.
std::array<int, 3> by_length(const Vec3& size) {
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size[a] < size[b]; });
    return axes;
}

/// Along which axis a body does not fit the room, and into how many slabs it has to be cut; 1: it fits.
struct Excess {
    int axis = 0;
    int slabs = 1;
    double room = 0;  // along that axis
};

std::array<Excess, 3> excesses(const Vec3& size, const Vec3& room) {
    const std::array<int, 3> sides = by_length(size), rooms = by_length(room);
    std::array<Excess, 3> all;
    for (std::size_t i = 0; i < 3; ++i) {
        const double side = size[sides[i]], most = room[rooms[i]];
        const double slabs = std::ceil((side - kContainTolerance) / most);
        all[i] = {sides[i], static_cast<int>(std::clamp(slabs, 1.0, 2.0 * kMostSegments)), most};
    }
    return all;
}

class Cutting {
  public:
    explicit Cutting(const SegmentRules& rules) : rules_(rules), dice_(rules.seed) {}

    std::vector<Mesh> pieces(const Mesh& whole) {
        pieces_ = {whole};
        if (rules_.room) fit();
        while (static_cast<int>(pieces_.size()) < rules_.pieces) {
            cut_largest();
        }
        return std::move(pieces_);
    }

  private:
    void replace(std::size_t piece, std::vector<Mesh> bodies) {
        if (pieces_.size() + bodies.size() - 1 > static_cast<std::size_t>(kMostSegments)) too_many();
        const auto at = pieces_.begin() + static_cast<std::ptrdiff_t>(piece);
        *at = std::move(bodies.front());
        pieces_.insert(at + 1, std::make_move_iterator(bodies.begin() + 1), std::make_move_iterator(bodies.end()));
    }

    [[noreturn]] static void too_many() {
        throw UsageError("that would be more than " + std::to_string(kMostSegments) + " pieces");
    }

    void fit() {
        double fewest = 1;
        for (const Excess& excess : excesses(written_size(pieces_[0]), *rules_.room)) {
            fewest *= excess.slabs;
        }
        if (fewest > kMostSegments) too_many();
        for (std::size_t piece = 0; piece < pieces_.size();) {
            const std::array<Excess, 3> all = excesses(written_size(pieces_[piece]), *rules_.room);
            const Excess& worst = *std::max_element(all.begin(), all.end(),
                                                    [](const Excess& a, const Excess& b) { return a.slabs < b.slabs; });
            if (worst.slabs == 1) {
                ++piece;
                continue;
            }
            std::vector<Mesh> bodies = bodies_of(pieces_[piece]);
            replace(piece, bodies.size() > 1 ? std::move(bodies) : slabs_of(pieces_[piece], worst));
        }
    }

    /// Two slabs of so many, each with whole ones; as many more as it takes where the cut would have to lie where
    /// vertices are.
    static std::vector<Mesh> slabs_of(const Mesh& mesh, Excess excess) {
        for (; excess.slabs <= kMostSegments; ++excess.slabs) {
            if (auto trial = slab_cut(mesh, excess)) return std::move(trial->bodies);
        }
        too_many();
    }

    static std::optional<Trial> slab_cut(const Mesh& mesh, const Excess& excess) {
        const Box box = bounding_box(mesh);
        const double low = box.min[excess.axis], size = box.max[excess.axis] - low;
        const int below = excess.slabs / 2, above = excess.slabs - below;
        // Both ends leave room enough for the slabs on their side.
        double first = low + size - above * excess.room + kMargin, last = low + below * excess.room - kMargin;
        const bool tight = first > last;
        if (tight) {  // they fill it to the last, so they have to do so as they are written, too
            first = last = low + below * excess.room;
            const double at = in_single(first);
            if (at - in_single(low) > below * excess.room + kContainTolerance ||
                in_single(low + size) - at > above * excess.room + kContainTolerance) {
                return std::nullopt;
            }
        }
        Vec3 normal;
        normal[excess.axis] = 1;
        const double wanted = std::clamp(low + size * below / excess.slabs, first, last);
        std::optional<Trial> best;
        for (int place = 0; place < kPlaces; ++place) {
            // The wanted place, then by turns before and behind it.
            const double step = (last - first) / (kPlaces - 1) * ((place + 1) / 2);
            const double at = std::clamp(place % 2 == 0 ? wanted + step : wanted - step, first, last);
            const double move = kMove * size;
            auto offset = clear_offset(mesh, normal, at, std::max(first, at - move), std::min(last, at + move));
            if (tight && meets_vertices_only_in(mesh, excess.axis, at)) offset = at;
            if (!offset) continue;
            Trial trial = trial_of(mesh, {normal, *offset});
            if (tight && !is_sound(trial)) return std::nullopt;
            const bool clean = trial.bodies.size() == 2 && trial.smallest > kCrumb;
            const bool better = !best || (trial.smallest > kCrumb && best->smallest <= kCrumb);
            if (clean || better) best = std::move(trial);
            if (clean || tight) break;
        }
        return best;
    }

    /// Of all vertices near to a plane each is in it, exactly.
    static bool meets_vertices_only_in(const Mesh& mesh, int axis, double offset) {
        return std::ranges::all_of(mesh.vertices, [&](const Vec3& vertex) {
            return vertex[axis] == offset || std::abs(vertex[axis] - offset) > kMargin;
        });
    }

    /// No crumbs, and no sheets where facets lay in the plane.
    static bool is_sound(const Trial& trial) {
        return trial.smallest > kCrumb && std::ranges::all_of(trial.bodies, [](const Mesh& body) {
                   return count_edges(MeshEdges(body)).crowded == 0;
               });
    }

    /// The largest piece that can be cut into no more bodies than are wanted; else the largest.
    void cut_largest() {
        std::vector<std::size_t> largest(pieces_.size());
        std::iota(largest.begin(), largest.end(), 0U);
        std::vector<double> volumes;
        for (const Mesh& piece : pieces_) {
            volumes.push_back(signed_volume(piece));
        }
        std::stable_sort(largest.begin(), largest.end(),
                         [&](std::size_t a, std::size_t b) { return volumes[a] > volumes[b]; });
        const std::size_t wanted = static_cast<std::size_t>(rules_.pieces) - pieces_.size() + 1;
        std::optional<std::pair<std::size_t, Trial>> fallback;
        for (const std::size_t piece : largest) {
            std::optional<Trial> trial = cut_across(pieces_[piece], wanted);
            if (!trial) continue;
            if (trial->bodies.size() <= wanted && trial->smallest > kCrumb) {
                replace(piece, std::move(trial->bodies));
                return;
            }
            if (!fallback) fallback.emplace(piece, std::move(*trial));
        }
        if (!fallback) throw UsageError("there is no plane clear of its vertices to cut it by into more pieces");
        replace(fallback->first, std::move(fallback->second.bodies));
    }

    /// The best of some planes across the longest extent; none where none is clear of vertices.
    std::optional<Trial> cut_across(const Mesh& mesh, std::size_t wanted) {
        std::optional<Trial> best;
        const auto rank = [&](const Trial& trial) {
            return std::tuple(trial.bodies.size() <= wanted && trial.smallest > kCrumb,
                              std::min(trial.smallest, kFairShare), -trial.longest);
        };
        const Vec3 across = longest_direction(mesh);
        for (int i = 0; i < kDirections; ++i) {
            const double x = dice_.between(-kAslant, kAslant), y = dice_.between(-kAslant, kAslant);
            const Vec3 aslant = across + Vec3{x, y, dice_.between(-kAslant, kAslant)};
            const Vec3 normal = (1 / length(aslant)) * aslant;
            const auto [low, high] = extent(mesh, normal);
            const double at = low + (high - low) * (0.5 + dice_.between(-kOffCentre, kOffCentre));
            const double move = kMove * (high - low);
            const auto offset = clear_offset(mesh, normal, at, at - move, at + move);
            if (!offset) continue;
            Trial trial = trial_of(mesh, {normal, *offset});
            if (!best || rank(trial) > rank(*best)) best = std::move(trial);
        }
        return best;
    }

    static std::pair<double, double> extent(const Mesh& mesh, const Vec3& direction) {
        double low = Box::kInfinity, high = -Box::kInfinity;
        for (const Vec3& vertex : mesh.vertices) {
            const double height = dot(direction, vertex);
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return {low, high};
    }

    /// Of the axes and the diagonals between them.
    static Vec3 longest_direction(const Mesh& mesh) {
        Vec3 longest{1, 0, 0};
        double most = 0;
        for (int x = 0; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
                for (int z = -1; z <= 1; ++z) {
                    const Vec3 v{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                    if (length(v) == 0) continue;
                    const Vec3 direction = (1 / length(v)) * v;
                    const auto [low, high] = extent(mesh, direction);
                    if (high - low > most) {
                        most = high - low;
                        longest = direction;
                    }
                }
            }
        }
        return longest;
    }

    SegmentRules rules_;
    Dice dice_;
    std::vector<Mesh> pieces_;
};

}  // namespace

std::vector<Mesh> cut_into_segments(const Mesh& whole, const SegmentRules& rules) {
    return Cutting(rules).pieces(whole);
}

std::string segment_name(const std::string& whole, std::size_t number) {
    return whole + (number < 10 ? "-0" : "-") + std::to_string(number);
}

}  // namespace spectralpack::tools
