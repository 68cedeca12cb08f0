/// Transforms that are no rotation times the scale of the part.

#include <limits>

#include "packed_by_hand.hpp"

namespace spectralpack::test {
namespace {

using Kind = FindingKind;

class CheckTransforms : public PackedByHand {};
class CheckTransformsOfBuild : public CubesAndRings {};

TEST_F(CheckTransformsOfBuild, RefusesTransformsThatAreNoRotationTimesScale) {
    transform(3) = {{{Vec3{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"mirror"});
    transform(3) = {{{Vec3{1, 1e-4, 0}, {0, 1, 0}, {0, 0, 1}}}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"shear"});
    transform(3) = {{{Vec3{1, 0, 0}, {0, 1.001, 0}, {0, 0, 1}}}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"uneven"});
    transform(3) = {1.5 * Mat3{}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {1.5, 1});
    transform(3) = {0 * Mat3{}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3});
    transform(3) = {Mat3{}, {80, 30, 0}};
    EXPECT_TRUE(check_stated().ok());
    transform(3).translation.y = std::numeric_limits<double>::quiet_NaN();
    const CheckReport report = check();
    EXPECT_TRUE(std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& finding) {
        return finding.kind == Kind::transform && finding.placements == std::vector{3};
    }));
}

TEST_F(CheckTransformsOfBuild, JudgesMirroredCopiesByTheirTrueShape) {
    // Mirrored, this wedge reaches where the other is; turned it would not.
    const Mesh wedge = [] {
        Mesh mesh = cube_mesh(10);
        mesh.triangles = {{0, 2, 1}, {0, 1, 4}, {0, 4, 2}, {1, 2, 4}};
        return mesh;
    }();
    const int part = add_part("wedge", wedge);
    place(part, {80, 30, 0}).transform = {{{Vec3{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {80, 30, 0}};
    place(part, {60, 30, 0});
    CheckReport report = check_stated();
    expect_only(report, Kind::transform, {7});
    transform(8).translation.x = 71;
    report = check_stated();
    ASSERT_EQ(report.findings.size(), 2u);
    EXPECT_EQ(report.findings[0].kind, Kind::transform);
    EXPECT_EQ(report.findings[1].kind, Kind::overlap);
    EXPECT_EQ(report.findings[1].placements, (std::vector{7, 8}));
}

TEST_F(CheckTransforms, ScaleAndUnitCount) {
    const int part = add_part("inch", cube_mesh(1), 0.5, 25.4);
    place(part, {0, 0, 0});
    place(part, {12.7, 0, 0}, {{Vec3{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}).transform.translation.x = 25.4;
    const CheckReport report = check_stated();
    EXPECT_TRUE(report.ok());
    EXPECT_EQ(report.min_gap, 0);
    EXPECT_NEAR(report.density[0], 2 * 12.7 * 12.7 * 12.7 / (100 * 80 * 60), 1e-12);
    transform(1).translation.x = 25;
    expect_only(check_stated(), Kind::overlap, {0, 1});
    transform(1) = {Mat3{}, {50, 50, 50}};  // the scale forgotten
    expect_only(check_stated(), Kind::transform, {1}, {1, 12.7});
}

}  // namespace
}  // namespace spectralpack::test
