#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "search/shape.hpp"
#include "voxel/permute.hpp"
#include "voxel/split.hpp"

namespace spectralpack {
namespace {

using Widened = std::vector<std::shared_ptr<const WidenedVoxels>>;  ///< one for each gap class

constexpr double kSameSize = 1e-6;  ///< mm: sizes closer than this have the same candidates

bool same(const OrientedVoxels& a, const OrientedVoxels& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(a.size[axis] - b.size[axis]) > kSameSize) return false;
    }
    return a.solid == b.solid;
}

/// The first of each set of equal orientations.
std::vector<std::size_t> distinct_orientations(const std::vector<OrientedVoxels>& voxels) {
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
        widened.push_back(as_before
                              ? widened.back()
                              : std::make_shared<const WidenedVoxels>(make(c, std::max(own_gap, gap_classes[c]))));
    }
    return widened;
}

}  // namespace

Shape make_shape(std::uint64_t id, const Mesh& mesh, const std::vector<Mat3>& rotations, double voxel_size, int detail,
                 double gap, const std::vector<double>& gap_classes, const Workers& workers) {
    const auto own_class = std::ranges::find(gap_classes, gap);
    if (own_class == gap_classes.end() || !std::ranges::is_sorted(gap_classes)) {
        throw InternalError("a part's gap is not among the job's gap classes");
    }
    const double fine_size = voxel_size / detail;
    Shape shape;
    shape.id = id;
    shape.gap_class = static_cast<int>(own_class - gap_classes.begin());

    std::vector<OrientedVoxels> voxels = voxelize_orientations(mesh, rotations, fine_size, workers);
    struct Source {
        std::size_t root;  ///< in shape.orientations: the first that differs in its axes only
        AxisOrder axes;
    };
    std::vector<Source> sources;
    std::vector<std::size_t> roots;
    for (const std::size_t i : distinct_orientations(voxels)) {
        std::optional<Source> source;
        for (std::size_t k = 0; k < roots.size() && !source; ++k) {
            const int root = shape.orientations[roots[k]].orientation;
            const auto axes = exchanged_axes(rotations[i], rotations[static_cast<std::size_t>(root)]);
            if (axes) source = Source{roots[k], *axes};
        }
        if (!source) roots.push_back(sources.size());
        sources.push_back(source.value_or(Source{sources.size(), {0, 1, 2}}));
        shape.orientations.push_back({static_cast<int>(i),
                                      voxels[i].size,
                                      voxels[i].min,
                                      nullptr,
                                      {},
                                      std::make_shared<const BitGrid>(std::move(voxels[i].solid))});
    }
    workers.for_each(static_cast<std::int64_t>(shape.orientations.size()), [&](std::int64_t i) {
        OrientedShape& made = shape.orientations[static_cast<std::size_t>(i)];
        made.solid =
            detail == 1 ? made.fine : std::make_shared<const BitGrid>(reached_voxels(*made.fine, {}, detail).voxels);
    });

    // Widening costs more than all else here, so each root is widened and the others get its grids
    // with the axes exchanged: 8 of the cube's 24 rotations are roots.
    workers.for_each(static_cast<std::int64_t>(roots.size()), [&](std::int64_t k) {
        OrientedShape& root = shape.orientations[roots[static_cast<std::size_t>(k)]];
        const Mat3& rotation = rotations[static_cast<std::size_t>(root.orientation)];
        const Mesh turned = transformed(mesh, {rotation, {}});
        root.widened = for_each_gap(gap, gap_classes, [&](std::size_t, double wanted) {
            return wanted > 0 ? widen(*root.fine, turned, fine_size, wanted, workers) : WidenedVoxels{*root.fine, {}};
        });
    });
    workers.for_each(static_cast<std::int64_t>(sources.size()), [&](std::int64_t k) {
        const auto i = static_cast<std::size_t>(k);
        if (sources[i].root == i) return;
        shape.orientations[i].turned_from = static_cast<int>(sources[i].root);
        shape.orientations[i].axes = sources[i].axes;
        const Widened& of_root = shape.orientations[sources[i].root].widened;
        const AxisOrder& axes = sources[i].axes;
        shape.orientations[i].widened = for_each_gap(gap, gap_classes, [&](std::size_t c, double) {
            const VoxelIndex& offset = of_root[c]->offset;
            return WidenedVoxels{permuted(of_root[c]->voxels, axes),
                                 {offset[axes[0]], offset[axes[1]], offset[axes[2]]}};
        });
    });
    return shape;
}

}  // namespace spectralpack
