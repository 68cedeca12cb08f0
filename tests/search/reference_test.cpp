/// What the reference engine promises beyond the common suite: its transforms, error bound and
/// memory.

#include "search/reference/reference_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "brute_force.hpp"
#include "random_scene.hpp"
#include "search/reference/error_bound.hpp"
#include "search/reference/transform.hpp"
#include "search/verifying_search.hpp"

namespace spectralpack::test {
namespace {

bool is_smooth(int n) {
    for (const int prime : {2, 3, 5, 7}) {
        while (n % prime == 0) {
            n /= prime;
        }
    }
    return n == 1;
}

TEST(NextSmooth, IsTheLeastSmoothLengthThatIsLongEnough) {
    EXPECT_EQ(next_smooth(123), 125);
    EXPECT_EQ(next_smooth(240), 240);
    EXPECT_EQ(next_smooth(1), 1);
    EXPECT_TRUE(rc::check([] {
        const int least = *rc::gen::inRange(1, 3000);
        const int n = next_smooth(least);
        RC_ASSERT(n >= least && is_smooth(n));
        for (int smaller = least; smaller < n; ++smaller) {
            RC_ASSERT(!is_smooth(smaller));
        }
    }));
}

TEST(TransformExtent, IsSmoothWithEvenRowsAndMultiplesOfFourAcross) {
    EXPECT_EQ(transform_extent({240, 123, 100}, {}), (Extent{240, 128, 100}));
    EXPECT_EQ(transform_extent({240, 123, 100}, {1, 1, 1}), (Extent{250, 128, 108}));
    EXPECT_EQ(transform_extent({1, 1, 1}, {}), (Extent{2, 1, 1}));
}

/// Circular correlation of two grids of small whole numbers, by transforms and by its definition:
/// the greatest difference, divided by the bound.
template <class Real>
double error_by_bound(RandomStream& random, const Extent& grid, int most_a, int most_b) {
    Grid<int> a(grid), b(grid);
    double squares_a = 0, squares_b = 0;
    const FourierPlan<Real> plan(grid, false);
    FourierBuffer<Real> p(grid), q(grid);
    for_each_voxel(grid, [&](int x, int y, int z) {
        const int least = x + y + z == 0 ? 1 : 0;  // neither is all zero
        a.at(x, y, z) = between(random, least, most_a);
        b.at(x, y, z) = between(random, least, most_b);
        squares_a += std::pow(a.at(x, y, z), 2);
        squares_b += std::pow(b.at(x, y, z), 2);
        p.row(y, z)[x] = static_cast<Real>(a.at(x, y, z));
        q.row(y, z)[x] = static_cast<Real>(b.at(x, y, z));
    });
    plan.forward(p);
    plan.forward(q);
    for (std::int64_t i = 0; i < p.spectrum_size(); ++i) {
        p.spectrum()[i] = std::conj(p.spectrum()[i]) * q.spectrum()[i];
    }
    plan.inverse(p);

    double worst = 0;
    for_each_voxel(grid, [&](int qx, int qy, int qz) {
        double exact = 0;
        for_each_voxel(grid, [&](int x, int y, int z) {
            exact += static_cast<double>(a.at(x, y, z)) * b.at((x + qx) % grid.x, (y + qy) % grid.y, (z + qz) % grid.z);
        });
        const double computed = static_cast<double>(p.row(qy, qz)[qx]) / static_cast<double>(grid.count());
        worst = std::max(worst, std::abs(computed - exact));
    });
    const double unit_roundoff = std::is_same_v<Real, float> ? 0x1p-24 : 0x1p-53;
    return worst / correlation_error_bound(grid, std::sqrt(squares_a) * std::sqrt(squares_b), 1, unit_roundoff);
}

TEST(Correlation, IsTheDirectSumWithinTheBound) {
    RandomStream random(5);
    for (const Extent& grid :
         {Extent{1, 1, 1}, Extent{7, 5, 3}, Extent{14, 9, 10}, Extent{2, 1, 35}, Extent{21, 4, 1}, Extent{16, 15, 6}}) {
        for (const auto& [most_a, most_b] : {std::pair{1, 1}, {1, 40}, {3, 100000}}) {
            EXPECT_LT(error_by_bound<double>(random, grid, most_a, most_b), 1);
            EXPECT_LT(error_by_bound<float>(random, grid, most_a, most_b), 1);
        }
    }
}

TEST(Correlation, BoundLeavesRoomForRealTraysInDoublePrecision) {
    // 480 x 245 x 200 mm at 1 mm, an object of 8.6 million voxels, distances up to 100.
    const Extent grid{480, 245, 200};
    const double norms = std::sqrt(8.6e6) * 100 * std::sqrt(static_cast<double>(grid.count()));
    EXPECT_LT(correlation_error_bound(grid, norms, 1, 0x1p-53), 0.001);
    EXPECT_GT(correlation_error_bound(grid, norms, 1, 0x1p-24), 0.5);
    EXPECT_GT(correlation_error_bound(grid, 1e6 * norms, 1, 0x1p-53), 0.5);
}

TEST(Reference, AnswersAlikeWithEveryOption) {
    const Workers workers(3);
    // The bound says that single precision is exact for trays as small as these.
    for (const ReferenceOptions& options :
         {ReferenceOptions{false, false, 1}, ReferenceOptions{false, true, 2}, ReferenceOptions{true, false, 0}}) {
        VerifyingSearch search(make_reference_search(options, workers), std::make_unique<BruteForceSearch>(), {});
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            SCOPED_TRACE(seed);
            RandomStream random(seed);
            SceneLimits limits;
            limits.least = limits.most = {13, 6, 7};  // one grid, so that measuring is done once
            const Scene scene = random_scene(random, limits);
            for (const Shape& shape : scene.shapes) {
                ASSERT_NO_THROW(search.best_placement(scene.tray, shape, random_model(random), {}));
                ASSERT_NO_THROW(search.free_positions(scene.tray, shape, 0, {}));
            }
        }
    }
}

VoxelIndex overhang_of(const std::vector<Shape>& shapes) {
    VoxelIndex most;
    for (const Shape& shape : shapes) {
        for (const OrientedShape& oriented : shape.orientations) {
            for (const auto& wide : oriented.widened) {
                for (int axis = 0; axis < 3; ++axis) {
                    const int after = wide.offset[axis] + wide.voxels.extent()[axis] - oriented.solid.extent()[axis];
                    most[axis] = std::max({most[axis], -wide.offset[axis], after});
                }
            }
        }
    }
    return most;
}

TEST(Reference, HoldsWhatWasPredictedAtMost) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random);
        ReferenceOptions options;
        options.lanes = between(random, 1, 3);
        options.single_precision = one_in(random, 2);
        const auto engine = make_reference_search(options, Workers(1));
        const auto lanes_used = [&](const Shape& shape) {
            return std::min(options.lanes, static_cast<int>(shape.orientations.size()));
        };
        int lanes = 0, classes = 0;
        for (const Shape& shape : scene.shapes) {
            engine->best_placement(scene.tray, shape, {}, {});
            lanes = std::max(lanes, lanes_used(shape));
        }
        for (int c = 0; c < scene.tray.gap_classes(); ++c) {
            classes += scene.tray.occupied(c).none() ? 0 : 1;
        }
        const ReferenceMemory need{
            scene.tray.extent(), overhang_of(scene.shapes), scene.tray.gap_classes(), !scene.tray.blocked().none(),
            options.lanes,       options.single_precision};
        EXPECT_LE(engine->memory(), reference_memory(need));
        // Exactly so for what was used; a later, wider shape makes the lanes anew.
        ReferenceMemory used = need;
        used.gap_classes = classes;
        used.lanes = lanes;
        if (overhang_of({scene.shapes[0]}) == need.overhang) {
            EXPECT_EQ(engine->memory(), reference_memory(used));
        }
    }
}

TEST(Reference, PredictsThePaddedTransforms) {
    // Three transforms of at least (240 + 63) x (123 + 31) x (100 + 15) doubles.
    const std::int64_t bytes = reference_free_memory({240, 123, 100}, {64, 32, 16}, false);
    EXPECT_GT(bytes, 3 * 8 * 303LL * 154 * 115);
    EXPECT_LT(bytes, 3 * 8 * 340LL * 170 * 125);
    EXPECT_LT(reference_free_memory({240, 123, 100}, {64, 32, 16}, true), bytes * 6 / 10);
}

}  // namespace
}  // namespace spectralpack::test
