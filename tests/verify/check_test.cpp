/// The judge as a whole: what it says of a sound packing, threads, progress, warnings.

#include "packed_by_hand.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack::test {
namespace {

using Kind = FindingKind;

class Check : public PackedByHand {};
class CheckOfBuild : public CubesAndRings {};

TEST_F(CheckOfBuild, IsFine) {
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

TEST_F(Check, DoesNotDependOnThreads) {
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

TEST_F(Check, AnEmptyPackingIsFine) {
    EXPECT_TRUE(check_stated().ok());
    packing_.trays.clear();
    packing_.metrics.density = 0;
    EXPECT_TRUE(check().ok());
}

TEST_F(CheckOfBuild, NeedsTheMeshesOfPlacedPartsOnly) {
    add_part("absent", {});
    meshes_.back() = nullptr;
    packing_.parts.back().count = 1;
    packing_.unplaced.push_back({3, 0, UnplacedReason::bad_file, ""});
    EXPECT_TRUE(check_stated().ok());
    meshes_[2] = nullptr;
    EXPECT_THROW(check(), InternalError);
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

TEST_F(CheckOfBuild, TellsItsProgressAndStopsWhenAsked) {
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

TEST_F(CheckOfBuild, WarnsOfOpenMeshes) {
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
    EXPECT_TRUE(names(witness.warnings[0], {"sack"}));
    transform(9).translation.x = 70;  // through its side
    expect_only(check_stated(), Kind::overlap, {7, 9});
}

}  // namespace
}  // namespace spectralpack::test
