/// Copies that share space.

#include "packed_by_hand.hpp"
#include "reference.hpp"

namespace spectralpack::test {
namespace {

using Kind = FindingKind;

class CheckOverlaps : public CubesAndRings {};

TEST_F(CheckOverlaps, NamesACopyMovedIntoItsNeighbour) {
    transform(1).translation.x -= 0.5;  // all other faces stay in common planes
    const CheckReport report = check_stated();
    expect_only(report, Kind::overlap, {0, 1});
    EXPECT_NEAR(report.findings.at(0).amount, 0.5, 1e-9);
    EXPECT_EQ(report.min_gap, 0);
}

TEST_F(CheckOverlaps, NamesRingsThatCross) {
    transform(5).translation.x += 8;
    expect_only(check_stated(), Kind::overlap, {4, 5});
}

TEST_F(CheckOverlaps, NamesATurnedCopyMovedIntoItsNeighbour) {
    // A rod that leans on a ring, half a millimetre too far.
    RandomStream random(4);
    const Mat3 lean = random_rotation(random);
    transform(6).linear = lean;
    const Mesh ring = transformed(*meshes_[1], transform(4)), rod = *meshes_[2];
    double near = 10, far = 40;
    for (int i = 0; i < 30; ++i) {
        const double y = (near + far) / 2;
        const Transform pose{lean, {20, 40 + y, 30}};
        (reference_distance(ring, transformed(rod, pose)) == 0 ? near : far) = y;
    }
    packing_.container.size = {200, 200, 200};
    for (Placement& placement : packing_.trays[0].placements) {
        placement.transform.translation = placement.transform.translation + Vec3{50, 50, 50};
    }
    transform(5).translation = {20, 20, 150};
    transform(6).translation = {70, 90 + far + 1e-6, 80};
    EXPECT_TRUE(check_stated().ok());
    transform(6).translation.y -= 0.5;
    expect_only(check_stated(), Kind::overlap, {4, 6});
}

TEST_F(CheckOverlaps, NamesNestedCopies) {
    const int bead = add_part("bead", sphere_mesh(1, 5));
    place(bead, {5, 5, 5});
    const CheckReport report = check_stated();
    expect_only(report, Kind::nested, {0, 7});
    EXPECT_NEAR(report.findings.at(0).amount, 5, 0.2);
    EXPECT_EQ(report.min_gap, 0);
}

TEST_F(CheckOverlaps, AllowsCopiesInClosedHollows) {
    const int shell = add_part("shell", merged(cube_mesh(20), turned_inside_out(box_mesh({4, 4, 4}, {16, 16, 16}))));
    place(shell, {70, 10, 10});
    packing_.trays[0].placements[3].transform.translation = {75, 15, 15};
    EXPECT_TRUE(check_stated().ok());
    transform(3).translation.x += 1.5;
    expect_only(check_stated(), Kind::overlap, {3, 7});
}

TEST_F(CheckOverlaps, NamesEqualCopiesInOnePlace) {
    transform(2) = transform(0);
    transform(3).translation.x = 60;
    const CheckReport report = check_stated();
    expect_only(report, Kind::overlap, {0, 2});
    EXPECT_GT(report.findings.at(0).amount, 2);
}

}  // namespace
}  // namespace spectralpack::test
