#include "verify/check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "reference.hpp"
#include "scenes.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack::test {
namespace {

using Kind = FindingKind;

/// A packing built by hand whose figures are stated as its meshes have them.
class CheckTest : public testing::Test {
  protected:
    CheckTest() {
        packing_.container.size = {100, 80, 60};
        packing_.trays.resize(1);
    }

    void open_height() {
        packing_.container.open_height = true;
        double top = 0;
        for (const Placement& placement : packing_.trays[0].placements) {
            const Mesh& mesh = *meshes_[static_cast<std::size_t>(placement.part)];
            top = std::max(top, bounding_box(transformed(mesh, placement.transform)).max.z);
        }
        packing_.container.size.z = top;
    }

    int add_part(const std::string& name, Mesh mesh, double scale = 1, double unit = 1) {
        PackedPart part;
        part.id = static_cast<int>(packing_.parts.size());
        part.name = name;
        part.count = 0;
        part.scale = scale;
        part.unit = unit;
        packing_.parts.push_back(part);
        meshes_.push_back(std::make_shared<const Mesh>(std::move(mesh)));
        return part.id;
    }

    /// The next copy of a part.
    Placement& place(int part, const Vec3& at, const Mat3& rotation = {}, std::size_t tray = 0) {
        PackedPart& p = packing_.parts[static_cast<std::size_t>(part)];
        packing_.trays[tray].placements.push_back({part, p.count++, 0, false, {p.to_mm() * rotation, at}});
        return packing_.trays[tray].placements.back();
    }

    void state_figures() {
        const double container = packing_.container.size.x * packing_.container.size.y * packing_.container.size.z;
        double all = 0;
        for (TrayPacking& tray : packing_.trays) {
            double volume = 0;
            tray.bounding_box = {};
            for (const Placement& placement : tray.placements) {
                const Mesh& mesh = *meshes_[static_cast<std::size_t>(placement.part)];
                const double mm = packing_.parts[static_cast<std::size_t>(placement.part)].to_mm();
                volume += signed_volume(mesh) * mm * mm * mm;
                tray.bounding_box.add(bounding_box(transformed(mesh, placement.transform)));
            }
            tray.density = volume / container;
            const bool flat = tray.placements.empty();
            tray.density_bounding_box = flat ? 0 : volume / tray.bounding_box.volume();
            tray.height = flat ? 0 : tray.bounding_box.max.z;
            all += volume;
        }
        packing_.metrics.density = all / (container * static_cast<double>(packing_.trays.size()));
    }

    CheckReport check(int threads = 1) {
        Listener quiet;
        return check_packing(packing_, meshes_, Workers(threads), quiet, StopToken());
    }

    CheckReport check_stated() {
        state_figures();
        return check();
    }

    /// Exactly one finding: of this kind, about these placements, with a message that names them.
    void expect_only(const CheckReport& report, Kind kind, const std::vector<int>& placements,
                     const std::vector<std::string>& names, int tray = 0) {
        for (const Finding& finding : report.findings) {
            SCOPED_TRACE(finding.message);
            EXPECT_EQ(finding.kind, kind);
            EXPECT_EQ(finding.tray, tray);
            EXPECT_EQ(finding.placements, placements);
            for (const std::string& name : names) {
                EXPECT_NE(finding.message.find(name), std::string::npos) << name;
            }
        }
        EXPECT_EQ(report.findings.size(), 1u);
        EXPECT_FALSE(report.ok());
    }

    Transform& transform(std::size_t placement, std::size_t tray = 0) {
        return packing_.trays[tray].placements[placement].transform;
    }

    Packing packing_;
    std::vector<std::shared_ptr<const Mesh>> meshes_;
};

/// Four cubes in a row that touch, a linked pair of rings, a rod through a ring.
class Build : public CheckTest {
  protected:
    Build() {
        const int cube = add_part("cube", cube_mesh(10));
        for (int i = 0; i < 4; ++i) {
            place(cube, {10.0 * i, 0, 0});
        }
        const int ring = add_part("ring", torus_mesh(10, 2));
        place(ring, {20, 40, 30});
        place(ring, {30, 40, 30}, {{Vec3{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}});
        const int rod = add_part("rod", box_mesh({-1, -1, -15}, {1, 1, 15}));
        place(rod, {20, 46, 30});
    }
};

TEST_F(Build, IsFine) {
    const CheckReport report = check_stated();
    for (const Finding& finding : report.findings) {
        ADD_FAILURE() << finding.message;
    }
    EXPECT_TRUE(report.ok());
    EXPECT_EQ(report.min_gap, 0);
    ASSERT_EQ(report.density.size(), 1u);
    EXPECT_NEAR(report.density[0], packing_.trays[0].density, 1e-15);
    EXPECT_GE(report.pairs_tested, 3);
}

TEST_F(Build, NamesACopyMovedIntoItsNeighbour) {
    transform(1).translation.x -= 0.5;  // all other faces stay in common planes
    const CheckReport report = check_stated();
    expect_only(report, Kind::overlap, {0, 1}, {"cube #0", "cube #1"});
    EXPECT_NEAR(report.findings.at(0).amount, 0.5, 1e-9);
    EXPECT_EQ(report.min_gap, 0);
}

TEST_F(Build, NamesRingsThatCross) {
    transform(5).translation.x += 8;
    expect_only(check_stated(), Kind::overlap, {4, 5}, {"ring #0", "ring #1"});
}

TEST_F(Build, NamesATurnedCopyMovedIntoItsNeighbour) {
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
    expect_only(check_stated(), Kind::overlap, {4, 6}, {"ring #0", "rod #0"});
}

TEST_F(Build, NamesACopyThatSticksOut) {
    transform(3).translation = {90.25, 30, 50};
    CheckReport report = check_stated();
    expect_only(report, Kind::outside, {3}, {"cube #3", "0.25 mm at +x"});
    EXPECT_NEAR(report.findings.at(0).amount, 0.25, 1e-9);
    transform(3).translation = {60, -0.5, -0.125};
    expect_only(check_stated(), Kind::outside, {3}, {"cube #3", "0.5 mm at -y", "0.125 mm at -z"});
    transform(3).translation = {90.0009, 30, 50};
    EXPECT_TRUE(check_stated().ok());
}

TEST_F(Build, KeepsTheWallGap) {
    for (Placement& placement : packing_.trays[0].placements) {
        placement.transform.translation = placement.transform.translation + Vec3{2, 2, 2};
    }
    packing_.options.wall_gap = 2;
    EXPECT_TRUE(check_stated().ok());
    transform(3).translation = {60, 1.5, 10};
    expect_only(check_stated(), Kind::outside, {3}, {"cube #3", "0.5 mm at -y", "wall gap of 2 mm"});
}

TEST_F(Build, NamesNestedCopies) {
    const int bead = add_part("bead", sphere_mesh(1, 5));
    place(bead, {5, 5, 5});
    const CheckReport report = check_stated();
    expect_only(report, Kind::nested, {0, 7}, {"bead #0 lies inside the material of cube #0"});
    EXPECT_NEAR(report.findings.at(0).amount, 5, 0.2);
    EXPECT_EQ(report.min_gap, 0);
}

TEST_F(Build, AllowsCopiesInClosedHollows) {
    const int shell = add_part("shell", merged(cube_mesh(20), turned_inside_out(box_mesh({4, 4, 4}, {16, 16, 16}))));
    place(shell, {70, 10, 10});
    packing_.trays[0].placements[3].transform.translation = {75, 15, 15};
    EXPECT_TRUE(check_stated().ok());
    transform(3).translation.x += 1.5;
    expect_only(check_stated(), Kind::overlap, {3, 7}, {"cube #3", "shell #0"});
}

TEST_F(Build, NamesEqualCopiesInOnePlace) {
    transform(2) = transform(0);
    transform(3).translation.x = 60;
    const CheckReport report = check_stated();
    ASSERT_EQ(report.findings.size(), 1u);
    expect_only(report, Kind::overlap, {0, 2}, {"cube #0", "cube #2"});
    EXPECT_GT(report.findings[0].amount, 2);
}

TEST_F(Build, RefusesTransformsThatAreNoRotationTimesScale) {
    transform(3) = {{{Vec3{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"cube #3 is mirrored"});
    transform(3) = {{{Vec3{1, 1e-4, 0}, {0, 1, 0}, {0, 0, 1}}}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"cube #3 is sheared"});
    transform(3) = {{{Vec3{1, 0, 0}, {0, 1.001, 0}, {0, 0, 1}}}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"cube #3", "unevenly"});
    transform(3) = {1.5 * Mat3{}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"cube #3 is scaled by 1.5, not by 1"});
    transform(3) = {0 * Mat3{}, {80, 30, 0}};
    expect_only(check_stated(), Kind::transform, {3}, {"cube #3"});
    transform(3) = {Mat3{}, {80, 30, 0}};
    EXPECT_TRUE(check_stated().ok());
    transform(3).translation.y = std::numeric_limits<double>::quiet_NaN();
    Packing whole = packing_;  // what is stated of the rest
    packing_.trays[0].placements.pop_back();
    EXPECT_EQ(check().findings.size() > 0, true);
    packing_ = whole;
    const CheckReport report = check();
    EXPECT_TRUE(std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& finding) {
        return finding.kind == Kind::transform && finding.message.find("cube #3") == 0;
    }));
}

TEST_F(Build, JudgesMirroredCopiesByTheirTrueShape) {
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
    expect_only(report, Kind::transform, {7}, {"wedge #0"});
    transform(8).translation.x = 71;
    report = check_stated();
    ASSERT_EQ(report.findings.size(), 2u);
    EXPECT_EQ(report.findings[0].kind, Kind::transform);
    EXPECT_EQ(report.findings[1].kind, Kind::overlap);
    EXPECT_EQ(report.findings[1].placements, (std::vector{7, 8}));
}

TEST_F(CheckTest, OpenHeightEndsWhereTheCopiesDo) {
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

TEST_F(CheckTest, ScaleAndUnitCount) {
    const int part = add_part("inch", cube_mesh(1), 0.5, 25.4);
    place(part, {0, 0, 0});
    place(part, {12.7, 0, 0}, {{Vec3{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}).transform.translation.x = 25.4;
    const CheckReport report = check_stated();
    EXPECT_TRUE(report.ok());
    EXPECT_EQ(report.min_gap, 0);
    EXPECT_NEAR(report.density[0], 2 * 12.7 * 12.7 * 12.7 / (100 * 80 * 60), 1e-12);
    transform(1).translation.x = 25;
    expect_only(check_stated(), Kind::overlap, {0, 1}, {"inch #0", "inch #1"});
    transform(1) = {Mat3{}, {50, 50, 50}};  // the scale forgotten
    expect_only(check_stated(), Kind::transform, {1}, {"inch #1 is scaled by 1, not by 12.7"});
}

TEST_F(Build, NoticesEveryMisstatedFigure) {
    state_figures();
    TrayPacking& tray = packing_.trays[0];
    const Packing right = packing_;
    const auto expect_density = [&](int where, const std::string& word) {
        expect_only(check(), Kind::density, {}, {word}, where);
        packing_ = right;
    };
    tray.density *= 1.00001;
    expect_density(0, "density");
    tray.density = std::numeric_limits<double>::quiet_NaN();
    expect_density(0, "density");
    tray.density_bounding_box -= 1e-5;
    expect_density(0, "bounding box");
    tray.height += 0.002;
    expect_density(0, "height");
    tray.bounding_box.max.y += 0.002;
    expect_density(0, "bounding box");
    tray.bounding_box = {};
    expect_density(0, "bounding box");
    packing_.metrics.density += 0.01;
    expect_density(kWholePacking, "density");
    packing_.metrics.min_gap = 0.2;
    expect_density(kWholePacking, "least distance");
    packing_.metrics.min_gap = 0;
    EXPECT_TRUE(check().ok());
}

TEST_F(Build, CountsCopies) {
    state_figures();
    Packing right = packing_;
    packing_.trays[0].placements[3].copy = 0;
    CheckReport report = check();
    ASSERT_EQ(report.findings.size(), 2u);
    EXPECT_EQ(report.findings[0].message, "cube #3 is neither placed nor listed as left over");
    EXPECT_EQ(report.findings[0].tray, kWholePacking);
    EXPECT_EQ(report.findings[1].message, "cube #0 is placed twice");
    EXPECT_EQ(report.findings[1].placements, (std::vector{0, 3}));

    packing_.unplaced.push_back({0, 3, UnplacedReason::tray_full, ""});
    expect_only(check(), Kind::count, {0, 3}, {"cube #0 is placed twice"});
    packing_.unplaced.push_back({0, 3, UnplacedReason::tray_full, ""});
    EXPECT_EQ(check().findings.size(), 2u);

    packing_ = right;
    packing_.unplaced.push_back({1, 1, UnplacedReason::stopped, ""});
    expect_only(check(), Kind::count, {}, {"ring #1 is placed, and listed as left over"}, kWholePacking);

    packing_ = right;
    packing_.parts[0].count = 3;
    expect_only(check(), Kind::count, {3}, {"cube #3 is beyond its part's count of 3"});

    packing_ = right;
    packing_.parts[0].count = 15;
    expect_only(check(), Kind::count, {}, {"cube #4, #5", "and 3 more are neither placed"}, kWholePacking);

    packing_ = right;
    packing_.trays[0].placements.push_back({7, 0, 0, false, {}});
    expect_only(check(), Kind::count, {7}, {"part 7 #0 is of no part there is"});
}

TEST_F(Build, TraysAreApart) {
    packing_.trays.resize(2);
    place(0, {0, 0, 0}, {}, 1);
    EXPECT_TRUE(check_stated().ok());
    place(0, {3, 3, 3}, {}, 1);
    CheckReport report = check_stated();
    expect_only(report, Kind::overlap, {0, 1}, {"tray 1: ", "cube #4", "cube #5"}, 1);
    transform(1, 1).translation = {40, 40, 40};
    packing_.trays[1].placements[1].copy = 2;
    packing_.parts[0].count = 5;
    report = check_stated();
    expect_only(report, Kind::count, {1}, {"cube #2 is placed in tray 0 too"}, 1);
    EXPECT_EQ(report.density.size(), 2u);
}

TEST_F(CheckTest, KeepsTheLargerGapOfAPair) {
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
    expect_only(report, Kind::gap, {1, 2}, {"near #1", "far #0", "2.25 mm apart", "0.25 mm less"});
    EXPECT_NEAR(report.findings.at(0).amount, 0.25, 1e-12);
    transform(2).translation.x = 22.9995;
    EXPECT_TRUE(check_stated().ok());
    transform(2).translation.x = 20.5;  // touching
    report = check_stated();
    expect_only(report, Kind::gap, {1, 2}, {"0 mm apart"});
    EXPECT_EQ(report.min_gap, 0);
}

TEST_F(CheckTest, MeasuresTheLeastDistanceHoweverFar) {
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

TEST_F(CheckTest, DoesNotDependOnThreads) {
    RandomStream random(7);
    const int ring = add_part("ring", torus_mesh(10, 2)), cube = add_part("cube", cube_mesh(10));
    packing_.parts[0].gap = 0.7;
    for (int i = 0; i < 60; ++i) {
        place(i % 3 ? ring : cube, Vec3{50, 40, 30} + random_point(random, 45), random_rotation(random));
    }
    state_figures();
    const CheckReport one = check(1);
    EXPECT_GT(one.findings.size(), 20u);
    for (const int threads : {2, 3}) {
        const CheckReport more = check(threads);
        EXPECT_EQ(more.min_gap, one.min_gap);
        EXPECT_EQ(more.pairs_tested, one.pairs_tested);
        EXPECT_EQ(more.density, one.density);
        ASSERT_EQ(more.findings.size(), one.findings.size());
        for (std::size_t i = 0; i < one.findings.size(); ++i) {
            EXPECT_EQ(more.findings[i].message, one.findings[i].message);
            EXPECT_EQ(more.findings[i].amount, one.findings[i].amount);
            EXPECT_EQ(more.findings[i].placements, one.findings[i].placements);
        }
    }
    EXPECT_TRUE(std::is_sorted(one.findings.begin(), one.findings.end(), [](const Finding& a, const Finding& b) {
        return std::tie(a.tray, a.placements) < std::tie(b.tray, b.placements);
    }));
}

/// Remembers what it was told, and asks for a stop at a given call.
struct Witness : Listener {
    explicit Witness(int stop_at = 1 << 30) : left(stop_at) {}
    void on_progress(const Progress& progress) override {
        EXPECT_EQ(progress.phase, Phase::check);
        EXPECT_GE(progress.work, work);
        EXPECT_LE(progress.done, progress.total);
        work = progress.work;
        ++calls;
        if (--left == 0) source.request(StopReason::cancelled);
    }
    void on_warning(const std::string& text) override { warnings.push_back(text); }

    int left, calls = 0;
    double work = 0;
    std::vector<std::string> warnings;
    StopSource source;
};

TEST_F(Build, TellsItsProgressAndStopsWhenAsked) {
    transform(1).translation.x -= 0.5;
    state_figures();
    Witness all;
    EXPECT_EQ(check_packing(packing_, meshes_, Workers(1), all, StopToken()).findings.size(), 1u);
    EXPECT_NEAR(all.work, 1, 1e-12);
    for (int at = 1; at < all.calls; ++at) {
        Witness witness(at);
        const CheckReport report = check_packing(packing_, meshes_, Workers(1), witness, witness.source.token());
        EXPECT_TRUE(report.stopped);
        EXPECT_FALSE(report.ok());
        EXPECT_LE(report.findings.size(), 1u);
    }
    StopSource already;
    already.request(StopReason::time_limit);
    EXPECT_TRUE(check_packing(packing_, meshes_, Workers(1), all, already.token()).stopped);
}

TEST_F(Build, WarnsOfOpenMeshes) {
    Mesh open = cube_mesh(10);
    open.triangles.pop_back();
    const int part = add_part("sack", open);
    place(part, {70, 40, 20});
    place(part, {70, 40, 40});
    const int bead = add_part("bead", sphere_mesh(1, 5));
    place(bead, {75, 45, 25});  // inside, if there were an inside
    state_figures();
    Witness witness;
    EXPECT_TRUE(check_packing(packing_, meshes_, Workers(1), witness, StopToken()).ok());
    ASSERT_EQ(witness.warnings.size(), 1u);
    EXPECT_EQ(witness.warnings[0].find("sack"), 0u);
    transform(9).translation.x = 70;  // through its side
    expect_only(check_stated(), Kind::overlap, {7, 9}, {"sack #0", "bead #0"});
}

TEST_F(Build, NeedsTheMeshesOfPlacedPartsOnly) {
    add_part("absent", {});
    meshes_.back() = nullptr;
    packing_.parts.back().count = 1;
    packing_.unplaced.push_back({3, 0, UnplacedReason::unusable, ""});
    EXPECT_TRUE(check_stated().ok());
    meshes_[2] = nullptr;
    EXPECT_THROW(check(), InternalError);
}

TEST_F(CheckTest, AnEmptyPackingIsFine) {
    EXPECT_TRUE(check_stated().ok());
    packing_.trays.clear();
    packing_.metrics.density = 0;
    EXPECT_TRUE(check().ok());
}

}  // namespace
}  // namespace spectralpack::test
