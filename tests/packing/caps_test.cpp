#include "packing/tray/caps.hpp"

#include <gtest/gtest.h>

#include "packing/tray/greedy.hpp"
#include "packing/tray/measure.hpp"
#include "search/cpu/cpu_search.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

/// Packs cubes of 5 mm into 20 x 20 x 22 mm at 1 mm voxels.
class CappedTray : public testing::Test {
  protected:
    GreedyResult pack(const CapOptions& setup, int count) {
        TraySetup tray_setup;
        tray_setup.size = {20, 20, 22};
        tray_setup.voxel_size = 1;
        Tray tray(tray_setup);
        Caps caps(setup, {[](int) { return 125.0; }, [&](int, int) { return cube_; }});
        std::vector<Copy> copies;
        for (int copy = 0; copy < count; ++copy) {
            copies.push_back({0, copy});
        }
        const Workers workers(2);
        ShapeStore shapes(
            [&](int, const Workers&) {
                return std::make_shared<const Shape>(make_shape(1, cube_, {Mat3{}}, 1, 1, 0, {0}, workers));
            },
            workers);
        shapes.start_tray(copies);
        const Settle settle = [](const Copy&, const Shape& shape, const BestPlacement& best) {
            return settle_on_grid(shape, best, 1, 1, 0);
        };
        const auto engine = make_cpu_search({}, workers);
        GreedyResult result;
        PlaceLimits limits;
        limits.caps = &caps;
        pack_greedily(
            tray, {{*engine, shapes, workers}, 0, {1e8, HeightAt::bottom}, limits, settle}, copies, [](std::size_t) {},
            result);
        return result;
    }

    std::vector<double> areas(const GreedyResult& result) const {
        std::vector<double> area(22, 0);
        for (const PlacedCopy& placed : result.placed) {
            add_section_areas(transformed(cube_, {Mat3{}, placed.offset}), 1, area);
        }
        return area;
    }

    const Mesh cube_ = test::cube_mesh(5);
};

TEST_F(CappedTray, OfADensityTakesTheCopiesThatKeepIt) {
    const GreedyResult result = pack({0.25, std::nullopt, 8800, 400, {}, 0, 1}, 30);
    EXPECT_EQ(result.placed.size(), 17u);  // 17 x 125 of 8800 mm^3 are 24.1 %
    EXPECT_EQ(result.left_over.size(), 13u);
    EXPECT_EQ(result.searches, 17);
    EXPECT_NE(result.why.at(0).find("cap of 25 %"), std::string::npos) << result.why.at(0);
}

TEST_F(CappedTray, OfLayersGoesOnAboveThem) {
    // A cube's section is 1/16 of the base: 5 in a layer are 31.25 %. Four layers of cubes of 5 mm fit into 22 mm.
    const GreedyResult result = pack({std::nullopt, 0.32, 8800, 400, {}, 0, 1}, 30);
    EXPECT_EQ(result.placed.size(), 20u);
    for (const double area : areas(result)) {
        EXPECT_LE(area, 0.32 * 400 + 1e-9);
    }
    EXPECT_NE(result.why.at(0).find("cap of 32 %"), std::string::npos) << result.why.at(0);
    EXPECT_EQ(pack({std::nullopt, 1.0, 8800, 400, {}, 0, 1}, 100).placed.size(), 64u);
    EXPECT_EQ(pack({std::nullopt, 0.06, 8800, 400, {}, 0, 1}, 100).placed.size(), 0u);
}

TEST_F(CappedTray, OfAMeshIsOfItsSections) {
    // 200 mm2 up to 10 mm, 100 above, nothing from 15 mm on: 4, then 2 cubes of 25 mm2 fill half of a layer.
    std::vector<double> sections(10, 200.0);
    sections.resize(15, 100.0);
    EXPECT_EQ(pack({std::nullopt, 0.5, 0, 0, sections, 0, 1}, 30).placed.size(), 4u + 4 + 2);
}

TEST_F(CappedTray, CountsWhatIsFixed) {
    Caps caps({0.25, 0.1, 8800, 400, {}, 0, 1}, {[](int) { return 125.0; }, [&](int, int) { return cube_; }});
    caps.add_fixed(test::box_mesh({0, 0, 0}, {6, 6, 8}));
    EXPECT_FALSE(caps.may_stand(0, 0, {10, 10, 0})) << "36 + 25 of 40 mm2";
    EXPECT_TRUE(caps.may_stand(0, 0, {10, 10, 8}));
    EXPECT_EQ(caps.why_not(0), "");
    caps.add_fixed(test::box_mesh({0, 0, 8}, {20, 20, 13}));
    EXPECT_NE(caps.why_not(0), "") << "2288 + 125 of 2200 mm3";
}

TEST_F(CappedTray, CountsWhatStandsOffTheGrid) {
    Caps caps({std::nullopt, 0.1, 8800, 400, {}, 0, 1}, {[](int) { return 125.0; }, [&](int, int) { return cube_; }});
    EXPECT_TRUE(caps.may_stand(0, 0, {0, 0, 0.3}));
    caps.add(0, 0, {0, 0, 0.3});
    EXPECT_FALSE(caps.may_stand(0, 0, {10, 10, 0}));
    EXPECT_FALSE(caps.may_stand(0, 0, {10, 10, 4.4}));
    EXPECT_TRUE(caps.may_stand(0, 0, {10, 10, 5.6}));
}

}  // namespace
}  // namespace spectralpack
