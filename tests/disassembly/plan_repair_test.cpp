#include "disassembly/plan_repair.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "disassembly/remaining_steps.hpp"
#include "disassembly/scenes.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;
using test::box_mesh;
using test::frame_mesh;
using test::lying;
using test::placed;

constexpr std::size_t kAnyNumber = 1000;

/// Meshes where they stand, some discarded while they are taken apart.
class Planned {
  public:
    explicit Planned(const Vec3& size) : size_(size), scene_(size) {}

    void add(const Mesh& mesh, bool fixed = false) {
        meshes_.push_back(mesh);
        fixed_.push_back(fixed);
        scene_.add(mesh, fixed);
    }
    AssemblyScene& scene() { return scene_; }

    /// `choose(sets)`: whom to discard next, of those that hold each other; where it says none, whoever is discarded.
    template <class Choose>
    PlanRepair disassemble(const Choose& choose, std::vector<int> at_once = {}) {
        const std::vector<Body>& parts = scene_.parts();
        std::vector<std::size_t> after(parts.size(), PlanRepair::kStayed);
        Disassembler disassembler(scene_.setup(), parts, [](int, int) {});
        const auto discard = [&](int part) {
            disassembler.discard(part);
            after[static_cast<std::size_t>(part)] = disassembler.steps().size();
        };
        for (const int part : at_once) {
            discard(part);
        }
        for (disassembler.run(); disassembler.standing() > 0; disassembler.run()) {
            discard(choose(disassembler.stuck()));
        }
        return PlanRepair(scene_.setup(), parts, disassembler.steps(), after);
    }

    /// Replays the plan on the meshes of those that are not out; `more`: those that were let in.
    void replay(const PlanRepair& plan, const std::vector<Mesh>& more = {}) const {
        AssemblyScene standing(size_);
        std::vector<int> renumbered;
        std::size_t fixed = 0;
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            const bool out = !fixed_[i] && plan.out(static_cast<int>(i));
            renumbered.push_back(out ? -1 : standing.add(meshes_[i], fixed_[i]));
            fixed += fixed_[i];
        }
        for (const Mesh& mesh : more) {
            renumbered.push_back(standing.add(mesh));
        }
        standing.replay({remaining_steps(plan.steps(), renumbered, fixed), {}, {}}, 0.25);
    }

  private:
    Vec3 size_;
    AssemblyScene scene_;
    std::vector<Mesh> meshes_;
    std::vector<bool> fixed_;
};

int first_of(const std::vector<std::vector<int>>& sets) { return sets.front().front(); }

Mesh ring(double size) { return frame_mesh(size, 2, 2); }

TEST(PlanRepair, LetsBackWhatIsInNobodysWay) {
    Planned planned({40, 40, 40});
    planned.add(test::cube_mesh(8));
    planned.add(placed(test::cube_mesh(8), {0, 0, 10}));
    PlanRepair plan = planned.disassemble(first_of, {1});
    ASSERT_TRUE(plan.out(1));
    EXPECT_TRUE(plan.let_back(1, kAnyNumber));
    EXPECT_FALSE(plan.out(1));
    planned.replay(plan);
}

TEST(PlanRepair, KeepsOutWhatHoldsOthersUnlessLighterOnesGoInstead) {
    Planned planned({60, 60, 60});
    planned.add(placed(ring(20), {10, 10, 20}));            // linked with
    planned.add(placed(lying(ring(20), 0), {19, 19, 11}));  // the other
    planned.add(placed(test::cube_mesh(6), {50, 50, 0}));
    PlanRepair plan = planned.disassemble(first_of);
    ASSERT_TRUE(plan.out(0));
    EXPECT_FALSE(plan.let_back(0, kAnyNumber)) << "both weigh the same";
    EXPECT_TRUE(plan.out(0));
    planned.replay(plan);

    Planned uneven({60, 60, 60});
    uneven.add(placed(frame_mesh(20, 3, 4), {10, 10, 20}));
    uneven.add(placed(lying(ring(20), 0), {19, 19, 12}));
    PlanRepair other = uneven.disassemble(first_of);
    ASSERT_TRUE(other.out(0));
    EXPECT_TRUE(other.let_back(0, kAnyNumber));
    EXPECT_FALSE(other.out(0));
    EXPECT_TRUE(other.out(1)) << "the lighter one goes instead";
    uneven.replay(other);
}

TEST(PlanRepair, LetsInWhereTheWayOpensLater) {
    // An open chest with a lid that fits loosely over it.
    Planned planned({40, 40, 40});
    planned.add(test::chest_mesh(26, 2, true));
    planned.add(placed(box_mesh({0, 0, 0}, {26, 26, 2}), {0, 0, 27}));
    PlanRepair plan = planned.disassemble(first_of);
    const Mesh inside = placed(test::cube_mesh(8), {10, 10, 10});
    AssemblyScene alone({40, 40, 40});
    alone.add(inside);
    EXPECT_TRUE(plan.let_in(2, alone.parts().front(), kAnyNumber));
    planned.replay(plan, {inside});
    const Mesh wide = placed(box_mesh({0, 0, 0}, {30, 30, 3}), {5, 5, 30});
    AssemblyScene second({40, 40, 40});
    second.add(wide);
    plan.put_first(3, second.parts().front(), {{0, 0, 20}});
    planned.replay(plan, {inside, wide});
}

TEST(PlanRepair, RefusesWhatNeverComesOut) {
    Planned planned({40, 40, 40});
    planned.add(test::chest_mesh(26, 2, false));
    planned.add(placed(test::cube_mesh(5), {30, 30, 0}));
    PlanRepair plan = planned.disassemble(first_of);
    AssemblyScene alone({40, 40, 40});
    alone.add(placed(test::cube_mesh(8), {10, 10, 10}));
    EXPECT_FALSE(plan.let_in(2, alone.parts().front(), kAnyNumber));
    planned.replay(plan);
}

TEST(PlanRepair, RefusesASecondOneInTheSameHoleAndTakesOneBesideIt) {
    // A chest stands on one half open, and what is in that leaves round a corner after the chest: all of them wait for
    // it.
    Planned planned({40, 40, 90});
    planned.add(placed(test::chest_mesh(26, 2, false), {0, 0, 27}));
    planned.add(test::merged(test::chest_mesh(26, 2, true), box_mesh({0, 0, 24}, {13, 26, 26})));
    planned.add(placed(test::cube_mesh(8), {3, 8, 5}));
    PlanRepair plan = planned.disassemble(first_of);
    const auto refused = [&](int name, const Mesh& mesh) {
        AssemblyScene alone({40, 40, 90});
        alone.add(mesh);
        const int before = plan.fills();
        EXPECT_FALSE(plan.let_in(name, alone.parts().front(), kAnyNumber));
        return plan.fills() - before;
    };
    const int first = refused(3, placed(test::cube_mesh(8), {10, 10, 40}));
    EXPECT_LE(refused(3, placed(test::cube_mesh(8), {5, 5, 40})), first);
    planned.replay(plan);
    const Mesh outside = placed(test::cube_mesh(8), {30, 30, 10});
    AssemblyScene alone({40, 40, 90});
    alone.add(outside);
    EXPECT_TRUE(plan.let_in(3, alone.parts().front(), kAnyNumber));
    planned.replay(plan, {outside});
}

TEST(PlanRepair, PlansOfRandomScenesReplayWhoeverIsLetBack) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Planned planned({48, 48, 48});
        Tray tray(TraySetup{{48, 48, 48}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
        std::vector<int> movable;
        for (int tries = 0; tries < 60 && movable.size() < 9; ++tries) {
            const double side = 8 + 2 * static_cast<double>(random.below(6));
            Mesh mesh = random.below(4) == 0 ? box_mesh({0, 0, 0}, {side, 4, 4}) : ring(side);
            mesh = lying(mesh, static_cast<int>(random.below(3)));
            const Vec3 room = Vec3{48, 48, 48} - bounding_box(mesh).size();
            Vec3 at;
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = static_cast<double>(random.below(1 + static_cast<std::uint64_t>(room[axis])));
            }
            mesh = placed(mesh, at - bounding_box(mesh).min);
            AssemblyScene one({48, 48, 48});
            one.add(mesh);
            const TrayObject& object = one.parts().front().object;
            if (intersects(tray.omega_move(), *object.solid, object.position)) continue;
            tray.add(object);
            const bool fixed = random.below(12) == 0;
            if (!fixed) movable.push_back(static_cast<int>(planned.scene().parts().size()));
            planned.add(mesh, fixed);
        }
        std::vector<int> at_once;
        for (const int part : movable) {
            if (random.below(3) == 0) at_once.push_back(part);
        }
        PlanRepair plan = planned.disassemble(
            [&](const std::vector<std::vector<int>>& sets) {
                std::vector<int> some;
                for (const int part : sets.front()) {
                    if (std::ranges::find(movable, part) != movable.end()) some.push_back(part);
                }
                return some[random.below(some.size())];
            },
            at_once);
        planned.replay(plan);
        for (int tries = 0; tries < 12; ++tries) {
            const int part = movable[random.below(movable.size())];
            if (!plan.out(part)) continue;
            const bool let = plan.let_back(part, 1 + random.below(9));
            EXPECT_EQ(plan.out(part), !let);
            planned.replay(plan);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

}  // namespace
}  // namespace spectralpack
