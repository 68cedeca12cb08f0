#include "search/tray.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <limits>

#include "random_scene.hpp"
#include "spectralpack/error.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack::test {
namespace {

TraySetup setup_of(const Vec3& size, double voxel_size) {
    TraySetup setup;
    setup.size = size;
    setup.voxel_size = voxel_size;
    return setup;
}

std::shared_ptr<const BitGrid> box(const Extent& extent) {
    BitGrid bits(extent);
    bits.fill(true);
    return std::make_shared<const BitGrid>(std::move(bits));
}

TEST(Tray, HasAsManyVoxelsAsReachItsEnd) {
    EXPECT_EQ(Tray(setup_of({480, 245, 200}, 2)).extent(), (Extent{240, 123, 100}));
    // 0.3 / 0.1 and 0.7 / 0.1 are not whole in binary; the container is.
    EXPECT_EQ(Tray(setup_of({0.3, 0.7, 2.1}, 0.1)).extent(), (Extent{3, 7, 21}));
    EXPECT_EQ(Tray(setup_of({0.31, 0.69, 2.1001}, 0.1)).extent(), (Extent{4, 7, 22}));
}

TEST(Tray, RefusesWhatMakesNoGrid) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, nan, infinity}) {
        EXPECT_THROW(Tray(setup_of({10, 10, 10}, bad)), UsageError) << bad;
        EXPECT_THROW(Tray(setup_of({10, bad, 10}, 1)), UsageError) << bad;
    }
    EXPECT_THROW(Tray(setup_of({10, 10, 0.99}, 1)), UsageError);
    EXPECT_THROW(Tray(setup_of({1e12, 10, 10}, 1)), ResourceError);
    EXPECT_THROW(Tray(setup_of({2e6, 2e6, 2e6}, 1)), ResourceError);

    TraySetup setup = setup_of({4, 3, 2}, 1);
    setup.blocked = BitGrid({3, 4, 2});
    EXPECT_THROW(Tray{setup}, InternalError);
    setup.blocked = {};
    for (const std::vector<double>& gaps :
         {std::vector<double>{}, std::vector<double>{1, 0}, std::vector<double>{1, 1}}) {
        setup.gap_classes = gaps;
        EXPECT_THROW(Tray{setup}, InternalError);
    }
}

TEST(Tray, TakesExactFits) {
    const Tray tray(setup_of({480, 245, 200}, 2));
    EXPECT_EQ(tray.candidates({480, 245, 200}), (Extent{1, 1, 1}));
    // 244 mm leave 1 mm, less than a voxel; 243 mm leave a whole one.
    EXPECT_EQ(tray.candidates({478, 244, 2}), (Extent{2, 1, 100}));
    EXPECT_EQ(tray.candidates({476.5, 243, 1}), (Extent{2, 2, 100}));
    // The box decides, not its voxels: 1 mm boxes fit into the last, half voxel.
    EXPECT_EQ(tray.candidates({1, 1, 1}), (Extent{240, 123, 100}));
    EXPECT_EQ(tray.candidates({1, 1.1, 1}), (Extent{240, 122, 100}));
}

TEST(Tray, AllowsRoundingOnlyWithinTheTolerance) {
    const Tray tray(setup_of({10, 8, 6}, 1));
    EXPECT_EQ(tray.candidates({10 + 5e-7, 8, 6}), (Extent{1, 1, 1}));
    EXPECT_EQ(tray.candidates({9 + 5e-7, 8, 6}), (Extent{2, 1, 1}));
    EXPECT_TRUE(tray.candidates({10 + 2e-6, 8, 6}).empty());
    EXPECT_EQ(tray.candidates({9 + 2e-6, 8, 6}), (Extent{1, 1, 1}));
    EXPECT_TRUE(tray.candidates({10, 8, 7}).empty());
    EXPECT_TRUE(tray.candidates({std::numeric_limits<double>::quiet_NaN(), 8, 6}).empty());
}

TEST(Tray, CandidatesKeepTheBoxInTheContainerAndTheVoxelsInTheGrid) {
    EXPECT_TRUE(rc::check([] {
        // Lengths in millionths of a millimetre, so that exact fits and near misses occur.
        const auto length = [](int most) { return *rc::gen::inRange(1, most) * 1e-6; };
        const double dx = *rc::gen::element(0.1, 0.2, 0.5, 0.7, 1.0, 2.0);
        const auto tray_length = [&] {
            return *rc::gen::inRange(1, 40) * dx + *rc::gen::element(0.0, dx / 2, 1e-6, length(900));
        };
        const Tray tray(setup_of({tray_length(), tray_length(), tray_length()}, dx));
        Vec3 size;
        for (int axis = 0; axis < 3; ++axis) {
            size[axis] =
                std::max(1e-6, *rc::gen::inRange(0, 41) * dx + *rc::gen::element(0.0, -5e-7, 5e-7, length(2000)));
        }
        const Extent count = tray.candidates(size);
        for (int axis = 0; axis < 3; ++axis) {
            const double room = tray.setup().size[axis] - size[axis];
            if (count[axis] == 0) continue;
            const int last = count[axis] - 1;
            RC_ASSERT(last * dx <= room + kContainTolerance * 1.001);
            RC_ASSERT(last + voxels_along(size[axis], dx) <= tray.extent()[axis]);
            // The next position is really too far, by the box or by its voxels.
            RC_ASSERT((last + 1) * dx > room + kContainTolerance * 0.999 ||
                      last + 1 + voxels_along(size[axis], dx) > tray.extent()[axis]);
        }
        if (count.empty()) {
            bool too_large = false;
            for (int axis = 0; axis < 3; ++axis) {
                too_large = too_large || size[axis] > tray.setup().size[axis] + kContainTolerance * 0.999 ||
                            voxels_along(size[axis], dx) > tray.extent()[axis];
            }
            RC_ASSERT(too_large);
        }
    }));
}

/// Occupancy by its definition: the union of the objects that are present.
BitGrid union_of(const Tray& tray, int gap_class, std::optional<ObjectId> without = {}) {
    BitGrid all(tray.extent());
    for (ObjectId id = 0; id < tray.object_count(); ++id) {
        const TrayObject* object = tray.find(id);
        if (!object || id == without || object->gap_class != gap_class) continue;
        for_each_voxel(object->solid->extent(), [&](int x, int y, int z) {
            const VoxelIndex at = VoxelIndex{x, y, z} + object->position;
            if (object->solid->get(x, y, z) && tray.extent().contains(at)) all.set(at.x, at.y, at.z);
        });
    }
    return all;
}

TEST(Tray, OccupancyIsTheUnionOfWhatIsPresent) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random, seed % 3 == 0 ? long_scene(0) : SceneLimits{});
        for (int step = 0; step < 12; ++step) {
            random_change(scene, random);
            const Tray& tray = scene.tray;
            BitGrid place(tray.extent()), move(tray.extent());
            for (int c = 0; c < tray.gap_classes(); ++c) {
                EXPECT_EQ(tray.occupied(c), union_of(tray, c));
                unite(place, tray.occupied(c), {});
            }
            move = place;
            if (!tray.blocked().extent().empty()) unite(place, tray.blocked(), {});
            EXPECT_EQ(tray.omega_place(), place);
            EXPECT_EQ(tray.omega_move(), tray.setup().blocked_is_physical ? place : move);
            if (scene.present.empty()) continue;
            const ObjectId out = scene.present[random.below(scene.present.size())];
            BitGrid rest(tray.extent());
            for (int c = 0; c < tray.gap_classes(); ++c) {
                unite(rest, union_of(tray, c, out), {});
            }
            if (tray.setup().blocked_is_physical && !tray.blocked().extent().empty()) {
                unite(rest, tray.blocked(), {});
            }
            EXPECT_EQ(tray.omega_move(out), rest);
        }
    }
}

TEST(Tray, PartsAreTheFineVoxelsOfWhatIsPresent) {
    SceneLimits limits;
    limits.detail = 3;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random, limits);
        const Tray& tray = scene.tray;
        const int s = tray.detail();
        if (s == 1) continue;
        for (int step = 0; step < 8; ++step) {
            random_change(scene, random);
            for (int c = 0; c < tray.gap_classes(); ++c) {
                EXPECT_EQ(tray.occupied(c), union_of(tray, c));
                std::vector<BitGrid> parts(static_cast<std::size_t>(part_count(s)), BitGrid(tray.extent()));
                for (const ObjectId id : scene.present) {
                    const TrayObject& object = *tray.find(id);
                    if (object.gap_class != c) continue;
                    for_each_voxel(object.fine->extent(), [&](int x, int y, int z) {
                        const VoxelIndex v = VoxelIndex{x, y, z} + object.fine_position;
                        const VoxelIndex coarse{floor_div(v.x, s), floor_div(v.y, s), floor_div(v.z, s)};
                        if (!object.fine->get(x, y, z) || !tray.extent().contains(coarse)) return;
                        const int part = ((v.z - s * coarse.z) * s + v.y - s * coarse.y) * s + v.x - s * coarse.x;
                        parts[static_cast<std::size_t>(part)].set(coarse.x, coarse.y, coarse.z);
                    });
                }
                for (int part = 0; part < part_count(s); ++part) {
                    EXPECT_EQ(tray.occupied_part(c, part), parts[static_cast<std::size_t>(part)]);
                }
            }
        }
    }
}

TEST(Tray, RefusesAnObjectWithoutFineVoxelsWhereTheyDecide) {
    TraySetup setup = setup_of({6, 5, 4}, 1);
    setup.detail = 2;
    Tray tray(setup);
    EXPECT_THROW(tray.add({box({1, 1, 1}), {0, 0, 0}, 0, false}), InternalError);
}

TEST(Tray, RemovingLeavesVoxelsThatOthersHold) {
    Tray tray(setup_of({6, 5, 4}, 1));
    const ObjectId first = tray.add({box({3, 2, 2}), {0, 0, 0}, 0, false});
    const ObjectId second = tray.add({box({3, 2, 2}), {2, 1, 0}, 0, false});
    EXPECT_EQ(tray.omega_move().count(), 12 + 12 - 2);
    tray.remove(first);
    EXPECT_EQ(tray.omega_move().count(), 12);
    EXPECT_TRUE(tray.occupied(0).get(2, 1, 0));
    tray.remove(second);
    EXPECT_TRUE(tray.omega_move().none());
}

TEST(Tray, KeepsClassesApart) {
    TraySetup setup = setup_of({6, 5, 4}, 1);
    setup.gap_classes = {0, 0.5};
    Tray tray(setup);
    tray.add({box({3, 2, 2}), {0, 0, 0}, 0, false});
    const ObjectId wide = tray.add({box({3, 2, 2}), {0, 0, 0}, 1, false});
    EXPECT_EQ(tray.occupied(1).count(), 12);
    tray.remove(wide);
    EXPECT_TRUE(tray.occupied(1).none());
    EXPECT_EQ(tray.occupied(0).count(), 12);
    EXPECT_THROW(tray.add({box({1, 1, 1}), {0, 0, 0}, 2, false}), InternalError);
    EXPECT_THROW(tray.add({box({1, 1, 1}), {0, 0, 0}, -1, false}), InternalError);
}

TEST(Tray, ExcludesWhatCannotKeepItsGapInIt) {
    TraySetup setup = setup_of({6, 8, 10}, 1);  // diagonal 14.14
    setup.gap_classes = {0, 14.1, 14.2};
    Tray tray(setup);
    const auto excluded = [&tray] { return std::array{tray.excludes(0), tray.excludes(1), tray.excludes(2)}; };
    EXPECT_EQ(excluded(), (std::array{false, false, false})) << "nothing stands";
    const ObjectId plain = tray.add({box({2, 2, 2}), {0, 0, 0}, 1});
    EXPECT_EQ(excluded(), (std::array{false, false, true}));
    tray.remove(plain);
    tray.add({box({2, 2, 2}), {0, 0, 0}, 2});
    EXPECT_EQ(excluded(), (std::array{true, true, true}));
    setup.ceiling = Ceiling::open;
    Tray open(setup);
    open.add({box({2, 2, 2}), {0, 0, 0}, 2});
    EXPECT_FALSE(open.excludes(2)) << "it is as high as it has to be";
}

TEST(Tray, JournalTellsEveryChange) {
    Tray tray(setup_of({6, 5, 4}, 1));
    EXPECT_EQ(tray.version(), 0u);
    const ObjectId first = tray.add({box({1, 1, 1}), {0, 0, 0}, 0, false});
    const ObjectId second = tray.add({box({1, 2, 1}), {1, 1, 1}, 0, true});
    tray.remove(first);
    EXPECT_EQ(tray.version(), 3u);
    ASSERT_EQ(tray.changes().size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(tray.changes()[i].version, i + 1);
    }
    EXPECT_EQ(tray.changes()[1].id, second);
    EXPECT_TRUE(tray.changes()[1].added);
    EXPECT_EQ(tray.changes()[2].id, first);
    EXPECT_FALSE(tray.changes()[2].added);

    EXPECT_EQ(tray.find(first), nullptr);
    EXPECT_EQ(tray.object(first).position, (VoxelIndex{0, 0, 0}));  // still known
    ASSERT_NE(tray.find(second), nullptr);
    EXPECT_TRUE(tray.find(second)->fixed);
    EXPECT_EQ(tray.find(7), nullptr);
    EXPECT_EQ(tray.find(-1), nullptr);
    EXPECT_EQ(tray.object_count(), 2);
}

TEST(Tray, RefusesToRemoveWhatIsNotThere) {
    Tray tray(setup_of({6, 5, 4}, 1));
    const ObjectId id = tray.add({box({1, 1, 1}), {0, 0, 0}, 0, false});
    tray.remove(id);
    EXPECT_THROW(tray.remove(id), InternalError);
    EXPECT_THROW(tray.remove(5), InternalError);
    EXPECT_THROW(tray.remove(-1), InternalError);
    EXPECT_EQ(tray.version(), 2u);
}

TEST(Tray, CopiesAreTraysOfTheirOwn) {
    Tray tray(setup_of({6, 5, 4}, 1));
    tray.add({box({2, 2, 2}), {0, 0, 0}, 0, false});
    Tray copy = tray;
    EXPECT_NE(copy.instance(), tray.instance());
    EXPECT_EQ(copy.version(), tray.version());
    copy.add({box({1, 1, 1}), {5, 4, 3}, 0, false});
    EXPECT_EQ(tray.omega_move().count(), 8);
    EXPECT_EQ(copy.omega_move().count(), 9);
    const std::uint64_t before = copy.instance();
    copy = tray;
    EXPECT_NE(copy.instance(), before);
    EXPECT_NE(copy.instance(), tray.instance());
}

TEST(Tray, ItsLifeEndsWithItOrWhenItBecomesAnother) {
    std::weak_ptr<const void> life, of_copy;
    Tray last(setup_of({6, 5, 4}, 1));
    {
        Tray tray(setup_of({6, 5, 4}, 1));
        Tray copy = tray;
        life = tray.life();
        of_copy = copy.life();
        EXPECT_FALSE(life.expired());
        copy = last;
        EXPECT_TRUE(of_copy.expired());
        of_copy = copy.life();
        EXPECT_FALSE(of_copy.expired());
    }
    EXPECT_TRUE(life.expired());
    EXPECT_TRUE(of_copy.expired());
    EXPECT_FALSE(last.life().expired());
}

TEST(Tray, HeightIsMeasuredInItsOwnLayersUnlessToldOtherwise) {
    TraySetup setup = setup_of({6, 5, 4}, 1);
    EXPECT_EQ(Tray(setup).reference_layers(), 4);
    setup.reference_layers = 9;
    EXPECT_EQ(Tray(setup).reference_layers(), 9);
}

}  // namespace
}  // namespace spectralpack::test
