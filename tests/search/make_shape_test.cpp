#include <gtest/gtest.h>

#include <cmath>

#include "search/shape.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/orientations.hpp"
#include "support/shapes.hpp"
#include "voxel/split.hpp"

namespace spectralpack::test {
namespace {

const std::vector<double> kNoGap{0};

Shape shape_of(const Mesh& mesh, const std::vector<Mat3>& rotations, double voxel_size, double gap = 0,
               const std::vector<double>& gaps = kNoGap, int threads = 2) {
    return make_shape(7, mesh, rotations, voxel_size, 1, gap, gaps, Workers(threads));
}

Mesh turned(const Mesh& mesh, const Mat3& rotation) { return transformed(mesh, {rotation, {}}); }

bool same_size(const Vec3& a, const Vec3& b) {
    return std::abs(a.x - b.x) <= 1e-6 && std::abs(a.y - b.y) <= 1e-6 && std::abs(a.z - b.z) <= 1e-6;
}

TEST(MakeShape, MergesOrientationsOfABox) {
    const auto rotations = orientation_set("90");
    EXPECT_EQ(shape_of(cube_mesh(6), rotations, 2).orientations.size(), 1u);
    EXPECT_EQ(shape_of(box_mesh({0, 0, 0}, {8, 4, 4}), rotations, 2).orientations.size(), 3u);
    const Shape box = shape_of(box_mesh({-1, 5, 2}, {7, 9, 4}), rotations, 2);
    EXPECT_EQ(box.orientations.size(), 6u);
    EXPECT_EQ(box.id, 7u);
    EXPECT_EQ(box.orientations[0].orientation, 0);
    EXPECT_EQ(box.orientations[0].solid->extent(), (Extent{4, 2, 1}));
    EXPECT_EQ(box.orientations[0].corner, (Vec3{-1, 5, 2}));
}

TEST(MakeShape, DoesNotWidenByGapsThatLeaveNoRoomForAnother) {
    const std::vector<double> gaps{0, 3, 14.1, 14.2, 1e20};
    const Shape shape = make_shape(7, cube_mesh(6), orientation_set("90"), 1, 2, 3, gaps, Workers(2), {6, 8, 10});
    for (const OrientedShape& oriented : shape.orientations) {
        ASSERT_EQ(oriented.widened.size(), gaps.size());
        EXPECT_EQ(oriented.widened[0], oriented.widened[1]);
        EXPECT_EQ(oriented.widened[2].offset, (VoxelIndex{-29, -29, -29})) << "the diagonal is longer";
        for (const std::size_t beyond : {3, 4}) {
            EXPECT_EQ(oriented.widened[beyond].voxels, oriented.fine);
            EXPECT_EQ(oriented.widened[beyond].offset, VoxelIndex{});
        }
    }
}

TEST(MakeShape, KeepsEqualVoxelsOfUnequalSizesApart) {
    // 3.5 and 4 mm both take two voxels, but have other candidates.
    const auto rotations = orientation_set("90");
    EXPECT_EQ(shape_of(box_mesh({0, 0, 0}, {3.5, 4, 4}), rotations, 2).orientations.size(), 3u);
}

TEST(MakeShape, IsWhatTheVoxeliserGivesWithEqualOnesLeftOut) {
    for (const char* step : {"90", "45"}) {
        const auto rotations = orientation_set(step);
        for (const Mesh& mesh : {bracket(), torus_mesh(4, 1.5, 24, 12)}) {
            const Shape shape = shape_of(mesh, rotations, 1.25);
            std::size_t next = 0;
            for (std::size_t i = 0; i < rotations.size(); ++i) {
                const Mesh one = turned(mesh, rotations[i]);
                const BitGrid solid = voxelize(one, 1.25, Workers(1));
                const Box box = bounding_box(one);
                const Vec3 in = inset(box.size(), 1.25), reach = box.size() + in;
                if (next < shape.orientations.size() && shape.orientations[next].orientation == static_cast<int>(i)) {
                    const OrientedShape& kept = shape.orientations[next++];
                    EXPECT_EQ(*kept.solid, solid);
                    EXPECT_TRUE(same_size(kept.reach, reach));
                    EXPECT_TRUE(same_size(kept.corner, box.min - in));
                    continue;
                }
                bool seen = false;  // left out: an earlier one is equal
                for (std::size_t k = 0; k < next; ++k) {
                    seen = seen ||
                           (*shape.orientations[k].solid == solid && same_size(shape.orientations[k].reach, reach));
                }
                EXPECT_TRUE(seen) << "orientation " << i << " of " << step;
            }
            EXPECT_EQ(next, shape.orientations.size());
            for (std::size_t a = 0; a < next; ++a) {
                for (std::size_t b = 0; b < a; ++b) {
                    EXPECT_FALSE(*shape.orientations[a].solid == *shape.orientations[b].solid &&
                                 same_size(shape.orientations[a].reach, shape.orientations[b].reach));
                }
            }
        }
    }
}

TEST(MakeShape, OfTurnsThatOnlyExchangeAndReverseAxesOneIsVoxelised) {
    const auto voxelised = [](const char* step) {
        const auto voxels = voxelize_orientations(bracket(), orientation_set(step), 1, Workers(2));
        std::size_t count = 0;
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            count += voxels[i].origin == i ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(voxelised("90"), 1u);
    EXPECT_EQ(voxelised("45"), 14u);
}

TEST(MakeShape, TurnsVoxelsOnlyWhereTheyAreAskedFor) {
    for (const int detail : {1, 2}) {
        const Shape shape = make_shape(1, bracket(), orientation_set("90"), 1, detail, 0.5, {0.2, 0.5}, Workers(2));
        std::size_t later = 0;
        for (const OrientedShape& oriented : shape.orientations) {
            if (!oriented.is_turned()) continue;
            ++later;
            EXPECT_EQ(oriented.solid.bytes() + oriented.fine.bytes(), 0);
            for (const WidenedVoxels& wide : oriented.widened) {
                EXPECT_EQ(wide.voxels.bytes(), 0);
            }
        }
        EXPECT_GT(later, shape.orientations.size() / 2);
    }
}

TEST(MakeShape, WidensByTheLargerGapOfEachPair) {
    const auto rotations = orientation_set("90");
    const std::vector<double> gaps{0, 0.5, 2};
    const Mesh mesh = bracket();
    for (std::size_t own = 0; own < gaps.size(); ++own) {
        SCOPED_TRACE(own);
        const Shape shape = shape_of(mesh, rotations, 1, gaps[own], gaps);
        EXPECT_EQ(shape.gap_class, static_cast<int>(own));
        for (const OrientedShape& oriented : shape.orientations) {
            ASSERT_EQ(oriented.widened.size(), gaps.size());
            const Mesh one = turned(mesh, rotations[static_cast<std::size_t>(oriented.orientation)]);
            for (std::size_t c = 0; c < gaps.size(); ++c) {
                const double gap = std::max(gaps[own], gaps[c]);
                const WidenedVoxels expected = gap > 0
                                                   ? widen(*oriented.solid, one, oriented.corner, 1, gap, Workers(1))
                                                   : WidenedVoxels{oriented.solid, {}};
                EXPECT_EQ(oriented.widened[c].offset, expected.offset);
                EXPECT_EQ(*oriented.widened[c].voxels, *expected.voxels);
                // Equal gaps share one grid.
                EXPECT_EQ(oriented.widened[c] == oriented.widened[own], c <= own);
            }
        }
    }
}

TEST(MakeShape, DecidesCollisionsOnFinerVoxels) {
    const auto rotations = orientation_set("90");
    const Mesh mesh = bracket();
    for (const int detail : {2, 3}) {
        const Shape shape = make_shape(7, mesh, rotations, 1, detail, 0.5, {0.5}, Workers(2));
        for (const OrientedShape& oriented : shape.orientations) {
            const Mesh one = turned(mesh, rotations[static_cast<std::size_t>(oriented.orientation)]);
            const BitGrid fine = voxelize(one, 1.0 / detail, Workers(1));
            EXPECT_EQ(*oriented.fine, fine);
            EXPECT_EQ(*oriented.solid, reached_voxels(fine, {}, detail).voxels);
            const WidenedVoxels wide = widen(fine, one, oriented.corner, 1.0 / detail, 0.5, Workers(1));
            EXPECT_EQ(*oriented.widened[0].voxels, *wide.voxels);
            EXPECT_EQ(oriented.widened[0].offset, wide.offset);
            if (oriented.turned_from < 0) continue;
            const OrientedShape& from = shape.orientations[static_cast<std::size_t>(oriented.turned_from)];
            EXPECT_TRUE(!from.is_turned() || (oriented.is_exchanged() && from.turn.reverses()));
            EXPECT_EQ(turned(*from.fine, oriented.turn), fine);
            EXPECT_EQ(turned(*from.solid, oriented.turn), *oriented.solid);
            EXPECT_EQ(turned(*from.widened[0].voxels, oriented.turn), *wide.voxels);
        }
        EXPECT_TRUE(std::ranges::any_of(shape.orientations, [](const OrientedShape& o) { return o.turned_from >= 0; }));
    }
}

TEST(MakeShape, SaysWhichOrientationsFollowFromOthers) {
    const auto rotations = orientation_set("90");
    // An odd number of fine voxels along some axis: not the same voxels of dx from its other end.
    const auto turned_from = [&](double voxel_size, int detail) {
        int none = 0, reversing = 0, exchanging = 0;
        for (const OrientedShape& oriented :
             make_shape(7, bracket(), rotations, voxel_size, detail, 0, {0}, Workers(2)).orientations) {
            none += oriented.turned_from < 0;
            reversing += oriented.turn.reverses();
            exchanging += oriented.turned_from >= 0 && !oriented.turn.reverses();
        }
        return std::array{none, reversing, exchanging};
    };
    EXPECT_EQ(turned_from(1, 1), (std::array{1, 7, 16}));
    EXPECT_EQ(turned_from(1, 2)[2], 16);
}

TEST(MakeShape, DoesNotDependOnThreads) {
    const auto rotations = orientation_set("45");
    const Shape one = shape_of(bracket(), rotations, 0.75, 1, {0, 1}, 1);
    const Shape many = shape_of(bracket(), rotations, 0.75, 1, {0, 1}, 4);
    ASSERT_EQ(one.orientations.size(), many.orientations.size());
    for (std::size_t i = 0; i < one.orientations.size(); ++i) {
        EXPECT_EQ(one.orientations[i].orientation, many.orientations[i].orientation);
        EXPECT_EQ(*one.orientations[i].solid, *many.orientations[i].solid);
        EXPECT_EQ(*one.orientations[i].widened[0].voxels, *many.orientations[i].widened[0].voxels);
    }
}

TEST(MakeShape, RefusesAGapThatTheJobDoesNotHave) {
    EXPECT_THROW(shape_of(cube_mesh(4), {Mat3{}}, 2, 0.5, {0, 1}), InternalError);
    EXPECT_THROW(shape_of(cube_mesh(4), {Mat3{}}, 2, 1, {1, 0}), InternalError);
}

}  // namespace
}  // namespace spectralpack::test
