#include "packing/order/beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "search/cpu/cpu_search.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

const std::vector<Mat3> kTurns = test::three_turns();

/// Tori and boxes of several sizes, six parts.
Mesh mesh_of(int part) {
    if (part % 2 == 0) return test::torus_mesh(4 + part, 2, 24, 12);
    return test::box_mesh({0, 0, 0}, {3.0 + part, 9, 5});
}

double volume_of_part(int part) { return signed_volume(mesh_of(part)); }

struct Packed {
    GreedyResult result;
    PackingScore score;
};

/// Copies of the parts in random order, in a tray that does not hold them all (or, open, on a base).
class BeamSearch : public testing::TestWithParam<int> {
  protected:
    BeamSearch() {
        setup_.size = {24, 20, 18};
        setup_.voxel_size = 1;
        model_ = {4, HeightAt::bottom};
        for (int part = 0; part < 6; ++part) {
            sizes_.push_back({part, 4, bounding_box(mesh_of(part)).volume(), 0, "", volume_of_part(part)});
        }
        copies_ = order_copies(sizes_, Order::random, static_cast<std::uint64_t>(GetParam()));
    }

    void open() {
        setup_.ceiling = Ceiling::open;
        setup_.reference_layers = 20;
        setup_.size.z = 10;
        model_ = {1e8, HeightAt::top};
    }

    /// width 0: pack_greedily().
    Packed pack(int width, const std::vector<Copy>& copies, int threads = 2) {
        const Workers workers(threads);
        ShapeStore shapes(
            [&](int part, const Workers&) {
                return std::make_shared<const Shape>(
                    make_shape(static_cast<std::uint64_t>(part) + 1, mesh_of(part), kTurns, 1, 1, 0, {0}, workers));
            },
            workers);
        shapes.start_tray(copies);
        const Settle settle = [](const Copy&, const Shape& shape, const BestPlacement& best) {
            return settle_on_grid(shape, best, 1, 1, 0);
        };
        BeamOptions beam{width,
                         urgency_ranks(sizes_),
                         [&] { return make_cpu_search({}, workers); },
                         {volume_of_part, [](const PlacedCopy& placed) {
                              const Mesh turned =
                                  transformed(mesh_of(placed.copy.part),
                                              {kTurns[static_cast<std::size_t>(placed.orientation)], {}});
                              return bounding_box(turned).max.z + placed.offset.z;
                          }}};
        Tray tray(setup_);
        Packed packed;
        if (width == 0) {
            const auto engine = make_cpu_search({}, workers);
            pack_greedily(
                tray, {{*engine, shapes, workers}, 0, model_, {}, settle}, copies, [](std::size_t) {}, packed.result);
        } else {
            const auto engine = make_cpu_search({}, workers);
            pack_in_beam(
                tray, beam, {{*engine, shapes, workers, stop_.token()}, 0, model_, {}, settle}, copies,
                [](std::size_t) {}, packed.result);
        }
        packed.score = score_packing(copies, {&packed.result.placed}, beam.measures);
        return packed;
    }

    static void expect_same(const GreedyResult& a, const GreedyResult& b) {
        ASSERT_EQ(a.placed.size(), b.placed.size());
        for (std::size_t i = 0; i < a.placed.size(); ++i) {
            EXPECT_EQ(a.placed[i].copy, b.placed[i].copy) << i;
            EXPECT_EQ(a.placed[i].orientation, b.placed[i].orientation) << i;
            EXPECT_EQ(a.placed[i].position, b.placed[i].position) << i;
        }
    }

    TraySetup setup_;
    CostModel model_;
    std::vector<PartSize> sizes_;
    std::vector<Copy> copies_;
    StopSource stop_;
};

TEST_P(BeamSearch, OfOneIsGreedy) {
    for (const bool opened : {false, true}) {
        if (opened) open();
        const Packed greedy = pack(0, copies_), beam = pack(1, copies_);
        expect_same(beam.result, greedy.result);
        EXPECT_EQ(beam.result.searches, greedy.result.searches);
        EXPECT_EQ(beam.result.left_over.size(), greedy.result.left_over.size());
        EXPECT_EQ(opened, greedy.result.left_over.empty()) << "one tray should overflow and the other not";
    }
}

TEST_P(BeamSearch, GreedyInItsOrderGivesTheSame) {
    for (const bool opened : {false, true}) {
        if (opened) open();
        const Packed beam = pack(4, copies_);
        EXPECT_EQ(beam.result.placed.size() + beam.result.left_over.size(), copies_.size());
        EXPECT_TRUE(beam.result.untried.empty());
        std::vector<Copy> order;
        for (const PlacedCopy& placed : beam.result.placed) {
            order.push_back(placed.copy);
        }
        order.insert(order.end(), beam.result.left_over.begin(), beam.result.left_over.end());
        ASSERT_TRUE(std::is_permutation(order.begin(), order.end(), copies_.begin(), copies_.end()));
        const Packed greedy = pack(0, order);
        expect_same(beam.result, greedy.result);
        EXPECT_EQ(beam.score, greedy.score);
    }
}

TEST_P(BeamSearch, DoesNotDependOnThreads) { expect_same(pack(3, copies_, 1).result, pack(3, copies_, 4).result); }

TEST_P(BeamSearch, UrgentCopiesComeFirst) {
    sizes_[2].priority = 1;
    sizes_[5].priority = -1;
    copies_ = order_copies(sizes_, Order::random, static_cast<std::uint64_t>(GetParam()));
    open();
    const Packed beam = pack(4, copies_);
    const std::vector<int> ranks = urgency_ranks(sizes_);
    int last = 0;
    for (const PlacedCopy& placed : beam.result.placed) {
        const int rank = ranks[static_cast<std::size_t>(placed.copy.part)];
        EXPECT_GE(rank, last);
        last = rank;
    }
    EXPECT_EQ(last, 2);
}

TEST_P(BeamSearch, AStopLeavesTheRestUntried) {
    stop_.request(StopReason::time_limit);
    const Packed beam = pack(4, copies_);
    EXPECT_TRUE(beam.result.placed.empty());
    EXPECT_EQ(beam.result.untried, copies_);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BeamSearch, testing::Range(1, 6));

}  // namespace
}  // namespace spectralpack
