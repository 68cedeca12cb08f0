/// Walls, gaps and the least distance.

#include "packed_by_hand.hpp"
#include "reference.hpp"

namespace spectralpack::test {
namespace {

using Kind = FindingKind;

class CheckDistances : public PackedByHand {};
class CheckDistancesOfBuild : public CubesAndRings {};

TEST_F(CheckDistancesOfBuild, NamesACopyThatSticksOut) {
    transform(3).translation = {90.25, 30, 50};
    CheckReport report = check_stated();
    expect_only(report, Kind::outside, {3}, {0.25, "+x"});
    EXPECT_NEAR(report.findings.at(0).amount, 0.25, 1e-9);
    transform(3).translation = {60, -0.5, -0.125};
    expect_only(check_stated(), Kind::outside, {3}, {0.5, "-y", 0.125, "-z"});
    transform(3).translation = {90.0009, 30, 50};
    EXPECT_TRUE(check_stated().ok());
}

TEST_F(CheckDistancesOfBuild, KeepsTheWallGap) {
    for (Placement& placement : packing_.trays[0].placements) {
        placement.transform.translation = placement.transform.translation + Vec3{2, 2, 2};
    }
    packing_.options.wall_gap = 2;
    EXPECT_TRUE(check_stated().ok());
    transform(3).translation = {60, 1.5, 10};
    expect_only(check_stated(), Kind::outside, {3}, {0.5, "-y", 2});
}

TEST_F(CheckDistances, OpenHeightEndsWhereTheCopiesDo) {
    const int part = add_part("cube", cube_mesh(20));
    place(part, {0, 0, 0});
    place(part, {30, 0, 70});
    EXPECT_FALSE(check_stated().ok()) << "70 + 20 mm stick out of 60";
    open_height();
    EXPECT_TRUE(check_stated().ok());
    EXPECT_NEAR(check().density.at(0), 2 * 8000.0 / (100 * 80 * 90), 1e-12);
    transform(0).translation.z = -1;
    EXPECT_EQ(check_stated().findings.at(0).kind, Kind::outside) << "there is a floor";
    transform(0).translation.z = 0;
    packing_.container.size.z = 120;
    state_figures();
    const CheckReport report = check();
    EXPECT_FALSE(report.ok());
    for (const Finding& finding : report.findings) {
        EXPECT_EQ(finding.kind, Kind::density) << finding.message;
    }
}

TEST_F(CheckDistances, KeepsTheLargerGapOfAPair) {
    const int near = add_part("near", cube_mesh(10)), far = add_part("far", cube_mesh(10));
    place(near, {0, 0, 0});
    place(near, {10.5, 0, 0});
    place(far, {23, 0, 0});
    packing_.parts[0].gap = 0.5;
    packing_.parts[1].gap = 2.5;
    EXPECT_TRUE(check_stated().ok());
    EXPECT_NEAR(*check().min_gap, 0.5, 1e-12);
    transform(2).translation.x = 22.75;
    CheckReport report = check_stated();
    expect_only(report, Kind::gap, {1, 2}, {2.25, 0.25, 2.5});
    EXPECT_NEAR(report.findings.at(0).amount, 0.25, 1e-12);
    transform(2).translation.x = 22.9995;
    EXPECT_TRUE(check_stated().ok());
    transform(2).translation.x = 20.5;  // touching
    report = check_stated();
    expect_only(report, Kind::gap, {1, 2}, {0, 2.5});
    EXPECT_EQ(report.min_gap, 0);
}

TEST_F(CheckDistances, MeasuresTheLeastDistanceHoweverFar) {
    RandomStream random(6);
    packing_.container.size = {1000, 1000, 1000};
    const int ring = add_part("ring", torus_mesh(10, 2, 12, 6)), ball = add_part("ball", sphere_mesh(6, 5));
    for (const double spread : {60.0, 300.0}) {
        for (int round = 0; round < 4; ++round) {
            packing_.trays[0].placements.clear();
            for (int part = 0; part < 2; ++part) {
                packing_.parts[static_cast<std::size_t>(part)].count = 0;
                packing_.parts[static_cast<std::size_t>(part)].gap = round % 2;
            }
            for (int i = 0; i < 6; ++i) {
                place(i % 2 ? ring : ball, Vec3{500, 500, 500} + random_point(random, spread), random_rotation(random));
            }
            double expected = kFar;
            const auto& placements = packing_.trays[0].placements;
            for (std::size_t i = 0; i < placements.size(); ++i) {
                for (std::size_t j = i + 1; j < placements.size(); ++j) {
                    const auto mesh = [&](std::size_t k) {
                        return transformed(*meshes_[static_cast<std::size_t>(placements[k].part)],
                                           placements[k].transform);
                    };
                    expected = std::min(expected, reference_distance(mesh(i), mesh(j)));
                }
            }
            ASSERT_TRUE(check_stated().min_gap);
            EXPECT_NEAR(*check().min_gap, expected, 1e-9);
        }
    }
    packing_.trays[0].placements.resize(1);
    EXPECT_FALSE(check().min_gap);
    packing_.trays[0].placements.clear();
    packing_.parts[0].count = packing_.parts[1].count = 0;
    EXPECT_TRUE(check_stated().ok());
    EXPECT_FALSE(check().min_gap);
}

}  // namespace
}  // namespace spectralpack::test
