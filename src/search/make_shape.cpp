#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "search/shape.hpp"
#include "spectralpack/error.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/split.hpp"

namespace spectralpack {
namespace {

using Widened = std::vector<WidenedVoxels>;  ///< one for each gap class

constexpr double kSameReach = 1e-6;  ///< mm: what reaches as far but for this has the same candidates

/// By what turns each grid that others are turned from comes to be the same again; each is tried once.
class Symmetries {
  public:
    explicit Symmetries(const std::vector<OrientedVoxels>& voxels) : voxels_(voxels), told_(voxels.size()) {}

    bool have(std::size_t origin, const AxisTurn& turn) {
        std::vector<Told>& told = told_[origin];
        const auto known = std::ranges::find(told, turn, &Told::turn);
        if (known != told.end()) return known->symmetric;
        told.push_back({turn, is_symmetric(*voxels_[origin].solid, turn)});
        return told.back().symmetric;
    }

  private:
    struct Told {
        AxisTurn turn;
        bool symmetric;
    };
    const std::vector<OrientedVoxels>& voxels_;
    std::vector<std::vector<Told>> told_;
};

/// The first of each set of equal orientations.
std::vector<std::size_t> distinct_orientations(const std::vector<OrientedVoxels>& voxels) {
    Symmetries symmetries(voxels);
    const auto same = [&](const OrientedVoxels& a, const OrientedVoxels& b) {
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(a.reach[axis] - b.reach[axis]) > kSameReach) return false;
        }
        if (a.solid.extent() != b.solid.extent()) return false;
        // Of one origin, no voxels need be turned to tell.
        if (a.origin == b.origin) return symmetries.have(a.origin, chained(b.turn, inverse(a.turn)));
        return *a.solid == *b.solid;
    };
    std::vector<std::size_t> distinct;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        const bool seen =
            std::ranges::any_of(distinct, [&](std::size_t earlier) { return same(voxels[earlier], voxels[i]); });
        if (!seen) distinct.push_back(i);
    }
    return distinct;
}

/// A+g for each gap class; `make` is called once for each distinct g.
template <class Make>
Widened for_each_gap(double own_gap, const std::vector<double>& gap_classes, const Make& make) {
    Widened widened;
    for (std::size_t c = 0; c < gap_classes.size(); ++c) {
        const bool as_before = c > 0 && gap_classes[c] <= own_gap;  // both ask for the own gap
        widened.push_back(as_before ? widened.back() : make(c, std::max(own_gap, gap_classes[c])));
    }
    return widened;
}

struct Source {
    std::size_t root;  ///< in shape.orientations: the first whose voxels differ by a turn only
    AxisTurn turn;
};

/// True where voxels of dx become voxels of dx: from whichever end fine ones are counted, they are the same.
bool keeps_coarse_voxels(const AxisTurn& turn, const Extent& fine, int detail) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (turn.reversed[axis] && fine[turn.order[axis]] % detail != 0) return false;
    }
    return true;
}

/// Says of each orientation which earlier one it follows from: best by an exchange of axes alone.
void tell_turned(Shape& shape, const std::vector<Source>& sources, const std::vector<Mat3>& rotations, int detail) {
    std::vector<std::size_t> firsts;  // that others may be exchanged from
    for (std::size_t i = 0; i < sources.size(); ++i) {
        OrientedShape& oriented = shape.orientations[i];
        const Mat3& rotation = rotations[static_cast<std::size_t>(oriented.orientation)];
        const auto follow = [&](bool reversing) {
            for (const std::size_t first : firsts) {
                const OrientedShape& from = shape.orientations[first];
                if (sources[first].root != sources[i].root || (reversing && from.is_turned())) continue;
                const std::optional<AxisTurn> turn =
                    axis_turn(rotations[static_cast<std::size_t>(from.orientation)], rotation);
                if (!turn || turn->reverses() != reversing) continue;
                if (!keeps_coarse_voxels(*turn, from.fine.extent(), detail)) continue;
                oriented.turned_from = static_cast<int>(first);
                oriented.turn = *turn;
                return;
            }
        };
        follow(false);
        if (!oriented.is_turned()) follow(true);
        if (!oriented.is_exchanged()) firsts.push_back(i);
    }
}

/// A of each orientation, from its fine voxels or by a turn.
void add_coarse_voxels(Shape& shape, int detail, const Workers& workers) {
    std::vector<OrientedShape>& all = shape.orientations;
    if (detail == 1) {
        for (OrientedShape& oriented : all) {
            oriented.solid = oriented.fine;
        }
        return;
    }
    workers.for_each(std::ssize(all), [&](std::int64_t i) {
        OrientedShape& oriented = all[static_cast<std::size_t>(i)];
        if (!oriented.is_turned()) oriented.solid = LazyGrid(reached_voxels(*oriented.fine, {}, detail).voxels);
    });
    // What is reversed before what is only exchanged, which may follow from it.
    for (const bool exchanged : {false, true}) {
        for (OrientedShape& oriented : all) {
            if (!oriented.is_turned() || oriented.is_exchanged() != exchanged) continue;
            oriented.solid = turned(all[static_cast<std::size_t>(oriented.turned_from)].solid, oriented.turn);
        }
    }
}

}  // namespace

Shape make_shape(std::uint64_t id, const Mesh& mesh, const std::vector<Mat3>& rotations, double voxel_size, int detail,
                 double gap, const std::vector<double>& gap_classes, const Workers& workers, const Vec3& room) {
    const auto own_class = std::ranges::find(gap_classes, gap);
    if (own_class == gap_classes.end() || !std::ranges::is_sorted(gap_classes)) {
        throw InternalError("a part's gap is not among the job's gap classes");
    }
    const double fine_size = voxel_size / detail;
    Shape shape;
    shape.id = id;
    shape.gap_class = static_cast<int>(own_class - gap_classes.begin());

    std::vector<OrientedVoxels> voxels = voxelize_orientations(mesh, rotations, fine_size, workers, room);
    std::vector<Source> sources;
    std::vector<std::size_t> roots;
    for (const std::size_t i : distinct_orientations(voxels)) {
        std::optional<Source> source;
        for (std::size_t k = 0; k < roots.size() && !source; ++k) {
            const auto root = static_cast<std::size_t>(shape.orientations[roots[k]].orientation);
            if (voxels[root].origin != voxels[i].origin) continue;
            source = Source{roots[k], chained(inverse(voxels[root].turn), voxels[i].turn)};
        }
        if (!source) roots.push_back(sources.size());
        sources.push_back(source.value_or(Source{sources.size(), {}}));
        shape.orientations.push_back({static_cast<int>(i), voxels[i].reach, voxels[i].corner, {}, {}, voxels[i].solid});
    }
    tell_turned(shape, sources, rotations, detail);
    add_coarse_voxels(shape, detail, workers);

    // Where a gap leaves no room for another object, no engine is asked (find_place()).
    const auto widens = [&](double wanted) { return wanted > 0 && !holds_one_only(room, wanted); };
    // Widening costs more than all else here, so each root is widened and the others get its grids turned: of the
    // cube's 24 rotations one is a root.
    workers.for_each(static_cast<std::int64_t>(roots.size()), [&](std::int64_t k) {
        OrientedShape& root = shape.orientations[roots[static_cast<std::size_t>(k)]];
        const Mat3& rotation = rotations[static_cast<std::size_t>(root.orientation)];
        const Mesh turned_mesh = transformed(mesh, {rotation, {}});
        root.widened = for_each_gap(gap, gap_classes, [&](std::size_t, double wanted) {
            return widens(wanted) ? widen(*root.fine, turned_mesh, root.corner, fine_size, wanted, workers)
                                  : WidenedVoxels{root.fine, {}};
        });
    });
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (sources[i].root == i) continue;
        const OrientedShape& root = shape.orientations[sources[i].root];
        OrientedShape& oriented = shape.orientations[i];
        oriented.widened = for_each_gap(gap, gap_classes, [&](std::size_t c, double wanted) {
            return widens(wanted) ? turned(root.widened[c], root.fine.extent(), sources[i].turn)
                                  : WidenedVoxels{oriented.fine, {}};
        });
    }
    return shape;
}

}  // namespace spectralpack
