#include "verify/nearness.hpp"

#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>
#include <gtest/gtest.h>

#include <set>

#include "reference.hpp"
#include "scenes.hpp"
#include "stl.hpp"
#include "support/data.hpp"

namespace spectralpack::test {
namespace {

/// Distance of every two triangles, as find_nearness sees them.
std::vector<std::vector<double>> all_distances(const Solid& a, const Solid& b, const Transform& b_to_a) {
    std::vector<std::vector<double>> distances;
    for (std::size_t i = 0; i < a.mesh().triangles.size(); ++i) {
        distances.emplace_back();
        for (std::size_t j = 0; j < b.mesh().triangles.size(); ++j) {
            Corners corners = b.corners(j);
            for (Vec3& corner : corners) {
                corner = b_to_a * corner;
            }
            distances.back().push_back(triangle_distance(a.corners(i), corners, kFar));
        }
    }
    return distances;
}

/// The hierarchy finds the least distance and every contact that comparing all triangles finds.
void expect_like_brute_force(const Solid& a, const Solid& b, const Transform& b_to_a, double reach) {
    const Nearness near = find_nearness(a, b, b_to_a, reach, kFar, kFar);
    std::set<std::pair<std::size_t, std::size_t>> expected, found;
    double least = kFar;
    const auto distances = all_distances(a, b, b_to_a);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        for (std::size_t j = 0; j < distances[i].size(); ++j) {
            least = std::min(least, distances[i][j]);
            if (distances[i][j] <= reach) expected.insert({i, j});
        }
    }
    for (const Contact& contact : near.contacts) {
        found.insert({contact.a, contact.b});
    }
    EXPECT_EQ(near.distance, least);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(near.contacts.size(), found.size());
    for (const double share : {0.3, 0.99, 1.01}) {
        EXPECT_EQ(find_nearness(a, b, b_to_a, 0, share * least, kFar).distance, std::min(share, 1.0) * least);
    }
}

Mesh random_shape(RandomStream& random) {
    switch (random.below(5)) {
        case 0:
            return box_mesh({0, 0, 0}, {between(random, 1, 9), between(random, 1, 9), 3});
        case 1:
            return torus_mesh(between(random, 3, 6), between(random, 1, 2), 8, 5);
        case 2:
            return sphere_mesh(between(random, 2, 4), 4);
        case 3:
            return block_mesh(random_cells(random, {3, 2, 2}, 0.6));
        default: {
            // Triangles of all sizes and shapes, needles too.
            Mesh soup;
            for (std::uint32_t i = 0; i < 30; ++i) {
                const Vec3 p = random_point(random, 5), q = random_point(random, 5);
                soup.vertices.insert(soup.vertices.end(),
                                     {p, q, 0.4 * p + 0.6 * q + random_point(random, random.below(2) ? 1 : 1e-5)});
                soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
            }
            return soup;
        }
    }
}

TEST(Nearness, AgreesWithAllTrianglePairs) {
    RandomStream random(4);
    for (int pair = 0; pair < 1500; ++pair) {
        const Solid a(random_shape(random), {}, kFar), b(random_shape(random), {}, kFar);
        Transform pose{random_rotation(random), random_point(random, 12)};
        if (random.below(2) == 0) {  // aligned, as packings are
            pose.linear = Mat3{};
            if (random.below(2) == 0) pose.linear = {{Vec3{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
            for (int axis = 0; axis < 3; ++axis) {
                pose.translation[axis] = std::round(pose.translation[axis]);
            }
        }
        expect_like_brute_force(a, b, pose, random.below(2) == 0 ? 1e-3 : 0.5);
    }
}

TEST(Nearness, AgreesOnRealParts) {
    SPECTRALPACK_NEEDS_DATA();
    RandomStream random(6);
    std::vector<Solid> solids;
    for (const char* name : {"generated--drawer-handle", "generated--cage", "generated--signet-ring",
                             "odedstein--spot-control-mesh", "mendel90--huxley-tube-cap", "chrhodgden--castle-tower"}) {
        solids.emplace_back(read_stl(*benchmark_data() / "meshes" / (std::string(name) + ".stl")), Transform{}, kFar);
        ASSERT_FALSE(solids.back().mesh().triangles.empty()) << name;
    }
    for (int pair = 0; pair < 12; ++pair) {
        const Solid& a = solids[random.below(solids.size())];
        const Solid& b = solids[random.below(solids.size())];
        const Vec3 reach = 0.6 * (a.box().size() + b.box().size());
        const Transform pose{random_rotation(random), random_point(random, length(reach))};
        expect_like_brute_force(a, b, pose, 1e-3);
    }
}

TEST(Nearness, EndsAtACrossing) {
    const Solid a(sphere_mesh(5), {}, kFar);
    const Transform beside{Mat3{}, {4, 1, 0.5}};
    const Nearness ended = find_nearness(a, a, beside, 1e-3, 0, 1e-3);
    EXPECT_GT(ended.crossing, 1e-3);
    EXPECT_LT(ended.contacts.size(), find_nearness(a, a, beside, 1e-3, 0, kFar).contacts.size());
}

/// Why FCL's own distance of triangles is not used: here it has been seen to be wrong (0.16 instead of 0, and 6e-5 too
/// far apart or together for triangles of 1e-4). Ours must not be; whether FCL's still is, is in the test's properties.
TEST(Nearness, OurTriangleDistanceIsRightWhereThatOfFclIsNot) {
    using Vector = fcl::Vector3<double>;
    const auto by_fcl = [](const Corners& a, const Corners& b) {
        Vector s[3], t[3], p, q;
        for (int i = 0; i < 3; ++i) {
            s[i] = {a[i].x, a[i].y, a[i].z};
            t[i] = {b[i].x, b[i].y, b[i].z};
        }
        return fcl::detail::TriangleDistance<double>::triDistance(s, t, p, q);
    };
    const Corners a{Vec3{1, 0, -2}, {-1, 2, 1}, {-2, -2, 0}}, b{Vec3{-1, 1, 1}, {-2, -1, 1}, {-1, 0, 0}};
    EXPECT_LT(triangle_distance(a, b, kFar), 1e-15);
    RecordProperty("fcl_crossing_pair", std::to_string(by_fcl(a, b)));

    RandomStream random(9);
    int fcl_wrong = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto tiny = [&] {
            return Corners{random_point(random, 1e-4), random_point(random, 1e-4), random_point(random, 1e-4)};
        };
        const Corners s = tiny(), t = tiny();
        const double expected = double(reference_distance(PointTriangle{Point(s[0]), Point(s[1]), Point(s[2])},
                                                          {Point(t[0]), Point(t[1]), Point(t[2])}));
        EXPECT_NEAR(triangle_distance(s, t, kFar), expected, 1e-12);
        fcl_wrong += std::abs(by_fcl(s, t) - expected) > 1e-6;
    }
    RecordProperty("fcl_wrong_of_2000_tiny_pairs", fcl_wrong);
}

}  // namespace
}  // namespace spectralpack::test
