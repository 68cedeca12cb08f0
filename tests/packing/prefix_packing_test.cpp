/// Packing on from where orders part gives what packing all anew gives.

#include "packing/improve/prefix_packing.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "packing/job/tray_filler.hpp"
#include "packing/mesh_parts.hpp"
#include "packing/tray/greedy.hpp"
#include "search/cpu/cpu_search.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

class PrefixPackings : public testing::Test {
  protected:
    PrefixPackings() : engine_(make_cpu_search({}, workers_)) {
        for (const double side : {9.0, 7.0, 5.0, 3.0}) {
            parts_.meshes.push_back(box_mesh({0, 0, 0}, {side, side - 1, side / 2}));
        }
        parts_.meshes.push_back(torus_mesh(5, 1.2));
        parts_.orientations = {Mat3{}, Mat3{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}}};
        for (int part = 0; part < 5; ++part) {
            shapes_.push_back(parts_.shape(part));
            for (int number = 0; number < 4; ++number) {
                copies_.push_back({part, number});
            }
        }
        fill_.tray.size = {20, 18, 12};
        fill_.tray.voxel_size = 1;
        fill_.container.size = fill_.tray.size;
        fill_.interlock = Interlock::off;
        fill_.refine = false;
        fill_.left = fill_.to_put_back = [](int, int) {};
    }

    TrayFiller filler() {
        return {fill_, {*engine_, store_, workers_}, [this](int part) { return parts_.scaled(part); }};
    }
    PrefixPacking::ShapeOf shape_of() {
        return [this](int part) -> const Shape& { return *shapes_[static_cast<std::size_t>(part)]; };
    }
    std::vector<PackedStep> packed_anew(const std::vector<Copy>& order, const TrayCopies& wanted) {
        TrayFiller used = filler();
        StartedTray tray = used.start(wanted);
        PrefixPacking packing(tray, shape_of(), {});
        EXPECT_EQ(packing.pack(order, {}, never), PrefixPacking::Outcome::packed);
        return packing.steps();
    }
    static bool never(const std::vector<PackedStep>&) { return false; }

    Workers workers_{1};
    MeshParts parts_;
    std::vector<std::shared_ptr<const Shape>> shapes_;
    std::vector<Copy> copies_;
    FillOptions fill_;
    std::unique_ptr<PlacementSearch> engine_;
    ShapeStore store_{[this](int part, const Workers&) { return parts_.shape(part); }, workers_};
};

void expect_same(const std::vector<PackedStep>& a, const std::vector<PackedStep>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].copy, b[i].copy) << i;
        ASSERT_EQ(a[i].placed.has_value(), b[i].placed.has_value()) << i;
        if (!a[i].placed) continue;
        EXPECT_EQ(a[i].placed->position, b[i].placed->position) << i;
        EXPECT_EQ(a[i].placed->orientation, b[i].placed->orientation) << i;
        EXPECT_EQ(a[i].placed->offset, b[i].placed->offset) << i;
    }
}

TEST_F(PrefixPackings, GoOnFromWhereOrdersPart) {
    for (const HeightAt height_at : {HeightAt::top, HeightAt::bottom}) {
        const TrayCopies wanted{0, copies_, false, 0, height_at, {}};
        TrayFiller used_by_one = filler();
        StartedTray tray = used_by_one.start(wanted);
        PrefixPacking packing(tray, shape_of(), {});
        RandomStream random(11);
        std::vector<Copy> order = copies_;
        int left_over = 0;
        for (int i = 0; i < 30; ++i) {
            std::swap(order[random.below(order.size())], order[random.below(order.size())]);
            ASSERT_EQ(packing.pack(order, {}, never), PrefixPacking::Outcome::packed);
            expect_same(packing.steps(), packed_anew(order, wanted));
            left_over += static_cast<int>(order.size() - placed_of(packing.steps()).size());
        }
        EXPECT_GT(left_over, 0) << "all found a place: failures were not tried";
    }
}

TEST_F(PrefixPackings, PackAsGreedyPackingDoes) {
    const TrayCopies wanted{0, copies_, false, 0, {}, {}};
    TrayFiller used = filler();
    StartedTray tray = used.start(wanted);
    PrefixPacking packing(tray, shape_of(), {});
    ASSERT_EQ(packing.pack(copies_, {}, never), PrefixPacking::Outcome::packed);
    FilledTray greedy;
    filler().fill(
        wanted, [](std::size_t) {}, greedy);
    const std::vector<PlacedCopy> placed = placed_of(packing.steps());
    ASSERT_EQ(placed.size(), greedy.placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        EXPECT_EQ(placed[i], greedy.placed[i]) << i;
    }
}

TEST_F(PrefixPackings, StandWhatIsKnownWithoutASearch) {
    const TrayCopies wanted{0, copies_, false, 0, {}, {}};
    TrayFiller used = filler();
    StartedTray tray = used.start(wanted);
    PrefixPacking packing(tray, shape_of(), {});
    ASSERT_EQ(packing.pack(copies_, {}, never), PrefixPacking::Outcome::packed);
    const std::vector<PackedStep> known = packing.steps();
    std::vector<Copy> other = copies_;
    std::ranges::reverse(other);
    ASSERT_EQ(packing.pack(other, {}, never), PrefixPacking::Outcome::packed);
    const std::int64_t searches = packing.searches();
    ASSERT_EQ(packing.pack(copies_, known, never), PrefixPacking::Outcome::packed);
    EXPECT_EQ(packing.searches(), searches);
    expect_same(packing.steps(), known);
}

TEST_F(PrefixPackings, GiveUpAndStopInTheMidst) {
    const TrayCopies wanted{0, copies_, false, 0, {}, {}};
    TrayFiller used = filler();
    StartedTray tray = used.start(wanted);
    StopSource stop;
    PrefixPacking packing(tray, shape_of(), stop.token());
    const auto after_five = [](const std::vector<PackedStep>& steps) { return steps.size() == 5; };
    EXPECT_EQ(packing.pack(copies_, {}, after_five), PrefixPacking::Outcome::hopeless);
    EXPECT_EQ(packing.steps().size(), 5u);
    stop.request(StopReason::cancelled);
    EXPECT_EQ(packing.pack(copies_, {}, never), PrefixPacking::Outcome::stopped);
    EXPECT_EQ(packing.steps().size(), 5u);
}

TEST_F(PrefixPackings, KeepCaps) {
    fill_.max_layer_fill = 0.4;
    const TrayCopies wanted{0, copies_, false, 0, {}, {}};
    TrayFiller used = filler();
    StartedTray tray = used.start(wanted);
    PrefixPacking packing(tray, shape_of(), {});
    std::vector<Copy> order = copies_;
    for (int i = 0; i < 5; ++i) {
        std::rotate(order.begin() + i, order.begin() + 6, order.end());
        ASSERT_EQ(packing.pack(order, {}, never), PrefixPacking::Outcome::packed);
        expect_same(packing.steps(), packed_anew(order, wanted));
    }
}

}  // namespace
}  // namespace spectralpack::test
