/// Figures that are stated, and copies that are counted.

#include <limits>

#include "packed_by_hand.hpp"

namespace spectralpack::test {
namespace {

using Kind = FindingKind;

class CheckFigures : public CubesAndRings {};

TEST_F(CheckFigures, NoticesEveryMisstatedFigure) {
    state_figures();
    TrayPacking& tray = packing_.trays[0];
    const Packing right = packing_;
    const auto expect_density = [&](int where, const std::vector<Fact>& facts) {
        expect_only(check(), Kind::density, {}, facts, where);
        packing_ = right;
    };
    tray.density *= 1.00001;
    expect_density(0, {"filled"});
    tray.density = std::numeric_limits<double>::quiet_NaN();
    expect_density(0, {"filled"});
    tray.density_bounding_box -= 1e-5;
    expect_density(0, {"bounding box"});
    tray.height += 0.002;
    expect_density(0, {"height"});
    tray.bounding_box.max.y += 0.002;
    expect_density(0, {"bounding box"});
    tray.bounding_box = {};
    expect_density(0, {"bounding box"});
    packing_.metrics.density += 0.01;
    expect_density(kWholePacking, {"filled"});
    packing_.metrics.min_gap = 0.2;
    expect_density(kWholePacking, {0.2, 0});
    packing_.metrics.min_gap = 0;
    EXPECT_TRUE(check().ok());
}

TEST_F(CheckFigures, CountsCopies) {
    state_figures();
    Packing right = packing_;
    packing_.trays[0].placements[3].copy = 0;
    CheckReport report = check();
    ASSERT_EQ(report.findings.size(), 2u);
    EXPECT_EQ(report.findings[0].kind, Kind::count);
    EXPECT_TRUE(names(report.findings[0].message, {"cube", 4}));
    EXPECT_EQ(report.findings[0].tray, kWholePacking);
    EXPECT_EQ(report.findings[1].kind, Kind::count);
    EXPECT_TRUE(names(report.findings[1].message, {"1 cube"}));
    EXPECT_EQ(report.findings[1].placements, (std::vector{0, 3}));

    packing_.unplaced.push_back({0, 3, UnplacedReason::no_place, ""});
    expect_only(check(), Kind::count, {0, 3});
    packing_.unplaced.push_back({0, 3, UnplacedReason::no_place, ""});
    EXPECT_EQ(check().findings.size(), 2u);

    packing_ = right;
    packing_.unplaced.push_back({1, 1, UnplacedReason::not_tried, ""});
    expect_only(check(), Kind::count, {}, {"6 ring"}, kWholePacking);

    packing_ = right;
    packing_.parts[0].count = 3;
    expect_only(check(), Kind::count, {3}, {3});

    packing_ = right;
    packing_.parts[0].count = 15;
    expect_only(check(), Kind::count, {}, {"cube", 5, 6, 3}, kWholePacking);

    packing_ = right;
    packing_.trays[0].placements.push_back({7, 0, 0, false, {}});
    expect_only(check(), Kind::count, {7}, {7});
}

TEST_F(CheckFigures, TraysAreApart) {
    packing_.trays.resize(2);
    place(0, {0, 0, 0}, {}, 1);
    EXPECT_TRUE(check_stated().ok());
    place(0, {3, 3, 3}, {}, 1);
    CheckReport report = check_stated();
    expect_only(report, Kind::overlap, {0, 1}, {"tray 2"}, 1);
    transform(1, 1).translation = {40, 40, 40};
    packing_.trays[1].placements[1].copy = 2;
    packing_.parts[0].count = 5;
    report = check_stated();
    expect_only(report, Kind::count, {1}, {"tray 1", "tray 2"}, 1);
    EXPECT_EQ(report.density.size(), 2u);
}

}  // namespace
}  // namespace spectralpack::test
