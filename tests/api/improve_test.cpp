/// Improving through the public face: what comes of it is whole, sound, better, and the same again.

#include <gtest/gtest.h>
#include <spectralpack/spectralpack.hpp>

#include <map>

#include "support/process.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

Job job_of(int count, const Vec3& tray) {
    Job job;
    job.parts = {{.name = "ring", .mesh = test::torus_mesh(12, 2), .count = count},
                 {.name = "bracket", .mesh = test::bracket(), .count = count, .scale = 2},
                 {.name = "cube", .mesh = test::cube_mesh(9), .count = count},
                 {.name = "bar", .mesh = test::box_mesh({0, 0, 0}, {31, 5, 4}), .count = count}};
    job.options.tray = tray;
    job.options.voxel = 2;
    job.options.gap = 0.5;
    job.options.threads = 2;
    return job;
}

void expect_sound(const PackResult& result) {
    EXPECT_FALSE(result.failure);
    const CheckReport report = check({result.packing, result.meshes});
    EXPECT_TRUE(report.ok()) << (report.ok() ? "" : report.findings.front().message);
    for (const TrayPacking& tray : result.packing.trays) {
        EXPECT_TRUE(tray.disassembly && tray.disassembly->complete);
    }
    EXPECT_GE(result.packing.metrics.min_gap.value_or(1), 0.5 - 1e-6);
}

double placed_value(const Packing& packing) {
    double sum = 0;
    for (const Placement& placement : packing.trays.front().placements) {
        sum += packing.parts[static_cast<std::size_t>(placement.part)].value;
    }
    return sum;
}

TEST(Improve, ALowerPackingOfAll) {
    Job job = job_of(9, {37, 34, 0});
    job.parts[3].mesh = test::torus_mesh(9, 3);
    job.options.open_height = true;
    const PackResult first = pack(job);
    job.options.improve_steps = 60;
    const PackResult improved = pack(job);
    expect_sound(improved);
    EXPECT_EQ(improved.packing.metrics.placed, 36);
    const std::optional<Improved>& record = improved.packing.metrics.improvement;
    ASSERT_TRUE(record);
    EXPECT_EQ(record->what, Improves::height);
    EXPECT_EQ(record->steps, 60);
    EXPECT_NEAR(record->before, first.packing.trays.front().height, 1e-9);
    EXPECT_NEAR(record->now, improved.packing.trays.front().height, 1e-9);
    EXPECT_LT(record->now, record->before - 0.5) << "nothing was gained: the test tells little";
}

TEST(Improve, TheSameStepsGiveTheSamePackingOnAnyNumberOfThreads) {
    Job job = job_of(4, {44, 40, 0});
    job.options.open_height = true;
    job.options.improve_steps = 25;
    const PackResult two = pack(job);
    job.options.threads = 1;
    const PackResult one = pack(job);
    EXPECT_EQ(one.packing.metrics.improvement->now, two.packing.metrics.improvement->now);
    const auto& a = one.packing.trays.front().placements;
    const auto& b = two.packing.trays.front().placements;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].part, b[i].part);
        EXPECT_EQ(a[i].transform, b[i].transform);
    }
    EXPECT_EQ(one.packing.input_hash, two.packing.input_hash);
    job.options.improve_steps = 26;
    EXPECT_NE(pack(job).packing.input_hash, one.packing.input_hash);
}

TEST(Improve, EachGoalGetsMostOfWhatItAsksFor) {
    Job job = job_of(12, {44, 40, 30});
    job.parts[0].value = 50;
    job.options.improve_steps = 12;
    std::map<Goal, PackResult> results;
    for (const Goal goal : {Goal::fair, Goal::volume, Goal::copies, Goal::value}) {
        job.options.goal = goal;
        results[goal] = pack(job);
        expect_sound(results[goal]);
        EXPECT_FALSE(results[goal].packing.unplaced.empty()) << "the tray holds all: goals do not matter";
        const Improved& record = *results[goal].packing.metrics.improvement;
        EXPECT_GE(record.now, record.before);
    }
    const auto& fair = results[Goal::fair].packing;
    EXPECT_GT(results[Goal::volume].packing.metrics.density, fair.metrics.density);
    EXPECT_GT(results[Goal::copies].packing.metrics.placed, fair.metrics.placed);
    EXPECT_GT(placed_value(results[Goal::value].packing), placed_value(fair));
    EXPECT_EQ(results[Goal::copies].packing.metrics.improvement->what, Improves::copies);
}

TEST(Improve, TheGoalDecidesTheFirstPackingToo) {
    Job job = job_of(12, {44, 40, 30});
    const auto placed = [&](Goal goal) {
        job.options.goal = goal;
        return pack(job).packing.metrics.placed;
    };
    EXPECT_GT(placed(Goal::copies), placed(Goal::fair));
}

TEST(Improve, SeveralTraysLeaveLessToTheLast) {
    Job job = job_of(9, {44, 40, 32});
    job.options.trays = 0;
    job.options.improve_steps = 8;
    const PackResult result = pack(job);
    expect_sound(result);
    EXPECT_EQ(result.packing.metrics.placed, 36);
    const Improved& record = *result.packing.metrics.improvement;
    EXPECT_EQ(record.what, Improves::trays);
    EXPECT_LE(record.now, record.before);
    const double last = result.packing.trays.back().density;
    EXPECT_NEAR(record.now, static_cast<double>(result.packing.trays.size()) - 1 + last, 1e-9);
}

double box_of(const PackResult& result) {
    Box box;
    for (const Placement& placement : result.packing.trays.front().placements) {
        box.add(
            bounding_box(transformed(*result.meshes[static_cast<std::size_t>(placement.part)], placement.transform)));
    }
    return box.volume();
}

TEST(Improve, ASmallerBox) {
    Job job = job_of(3, {150, 150, 0});
    job.options.minimise = Minimise::box;
    const double first = box_of(pack(job));
    job.options.improve_steps = 70;
    const PackResult improved = pack(job);
    expect_sound(improved);
    EXPECT_EQ(improved.packing.metrics.placed, 12);
    const Improved& record = *improved.packing.metrics.improvement;
    EXPECT_EQ(record.what, Improves::box);
    EXPECT_EQ(record.steps, 70);
    EXPECT_GT(record.starts, 1) << "no other base was tried";
    EXPECT_NEAR(record.before, first, 1e-6 * first);
    EXPECT_NEAR(record.now, box_of(improved), 1e-6 * first);
    EXPECT_LT(record.now, 0.99 * first) << "nothing was gained: the test tells little";
    job.options.threads = 1;
    EXPECT_EQ(box_of(pack(job)), box_of(improved));
}

TEST(Improve, ALargerBudgetTakesAFinerGridWhereNobodySaysWhich) {
    Job job = job_of(400, {480, 245, 200});
    job.options.voxel.reset();
    const Mat3 tilt{{Vec3{0.8, -0.6, 0}, Vec3{0.6, 0.8, 0}, Vec3{0, 0, 1}}};
    job.parts[3].mesh = transformed(test::box_mesh({0, 0, 0}, {31, 5, 4}), {tilt, {}});
    const auto grid = [&](std::optional<int> seconds) {
        job.options.improve = seconds;
        job.options.improve_steps = seconds ? 1 : 0;
        const Estimate estimated = estimate(job);
        return std::pair(estimated.voxel, estimated.orientations);
    };
    const int usual = 24, with_box = 48;
    EXPECT_EQ(grid(std::nullopt), std::pair(2.0, usual));
    EXPECT_EQ(grid(1), std::pair(2.0, usual));
    EXPECT_EQ(grid(30), std::pair(1.0, usual));
    EXPECT_EQ(grid(10000), std::pair(1.0, with_box));
    job.options.voxel = 3;
    EXPECT_EQ(grid(10000), std::pair(3.0, with_box));
    job.options.rotations = "none";
    EXPECT_EQ(grid(10000), std::pair(3.0, 1));
}

TEST(Improve, ThePackingSaysWhichGridItTook) {
    Job job = job_of(1, {60, 50, 0});
    job.options.open_height = true;
    job.options.voxel.reset();
    EXPECT_EQ(pack(job).packing.options.voxel, 2.0);
    job.options.improve_steps = 2;
    EXPECT_EQ(pack(job).packing.options.voxel, 2.0) << "steps are steps on the usual grid";
    job.options.improve = 20;
    const PackResult result = pack(job);
    expect_sound(result);
    EXPECT_EQ(result.packing.options.voxel, 1.0);
    EXPECT_EQ(result.packing.options.rotations, "90+box");
}

TEST(Improve, TheLastOfSeveralTraysBecomesLower) {
    Job job = job_of(10, {44, 40, 32});
    job.options.trays = 0;
    const PackResult first = pack(job);
    job.options.improve_steps = 12;
    const PackResult lower = pack(job);
    expect_sound(lower);
    EXPECT_EQ(lower.packing.metrics.placed, 40);
    EXPECT_EQ(lower.packing.metrics.improvement->steps, 12);
    ASSERT_EQ(lower.packing.trays.size(), first.packing.trays.size());
    EXPECT_NEAR(lower.packing.trays.back().density, first.packing.trays.back().density, 1e-9);
    EXPECT_LT(lower.packing.trays.back().height, first.packing.trays.back().height - 1);
}

TEST(Improve, FixedCopiesStayAndCapsHold) {
    Job job = job_of(2, {60, 50, 60});
    const PackResult build = pack(job);
    Job more = job_of(3, {60, 50, 60});
    more.onto = Scene{build.packing, build.meshes};
    more.options.max_layer_fill = 0.5;
    more.options.improve_steps = 10;
    const PackResult result = pack(more);
    EXPECT_FALSE(result.failure);
    EXPECT_TRUE(check({result.packing, result.meshes}).ok());
    int before = 0;
    for (const Placement& placement : result.packing.trays.front().placements) {
        before += placement.before ? 1 : 0;
    }
    EXPECT_EQ(before, 8);
    for (const double area : result.packing.trays.front().layers.area) {
        EXPECT_LE(area, 0.5 * 60 * 50 + 1e-6);
    }
}

/// Ends improving after so many steps, as a clock would.
struct Ender : Listener {
    int left = 4;
    StopSource source;
    std::vector<double> now;
    void on_progress(const Progress& progress) override {
        if (progress.phase != Phase::improve) return;
        ASSERT_TRUE(progress.improved);
        now.push_back(progress.improved->now);
        if (left-- == 0) source.request(StopReason::time_limit);
    }
};

TEST(Improve, EndsWhenAskedToAndSaysHowManyStepsItTook) {
    Job job = job_of(5, {44, 40, 0});
    job.options.open_height = true;
    job.options.improve = 1000;
    Ender ender;
    job.enough_improved = ender.source.token();
    const PackResult timed = pack(job, {&ender});
    expect_sound(timed);
    EXPECT_EQ(timed.stopped, StopReason::none) << "the packing is whole: only improving ended";
    ASSERT_TRUE(timed.packing.metrics.improvement);
    const Improved& record = *timed.packing.metrics.improvement;
    EXPECT_GE(record.steps, 3);
    EXPECT_LE(record.steps, 6);
    for (std::size_t i = 1; i < ender.now.size(); ++i) {
        EXPECT_LE(ender.now[i], ender.now[i - 1]);
    }
    job.options.improve.reset();
    job.enough_improved.reset();
    job.options.improve_steps = static_cast<int>(record.steps);
    EXPECT_EQ(pack(job).packing.metrics.improvement->now, record.now) << "the steps do not repeat it";
}

/// Kills the run at one of the things it is told once it improves.
struct Killer : Listener {
    struct Killed {};
    int left = 1;
    void on_event(const Event& event) override {
        if (improving && event.kind == EventKind::tray_finished && left-- == 0) throw Killed();
    }
    void on_progress(const Progress& progress) override { improving = improving || progress.phase == Phase::improve; }
    bool improving = false;
};

TEST(Improve, ARunThatWasKilledGoesOnFromItsBest) {
    const test::TemporaryFolder folder;
    JournalOptions journal;
    journal.file = folder / "run.journal";
    Job job = job_of(9, {37, 34, 0});
    job.parts[3].mesh = test::torus_mesh(9, 3);
    job.options.open_height = true;
    job.options.improve = 1000;
    Ender patient;
    patient.left = 1'000'000;
    job.enough_improved = patient.source.token();
    struct Both : Killer {
        double now = 0, seconds = 0;
        void on_progress(const Progress& progress) override {
            Killer::on_progress(progress);
            if (progress.improved) now = progress.improved->now;
        }
    } killer;
    EXPECT_THROW(pack(job, {&killer}, journal), Killer::Killed);
    Ender ender;
    ender.left = 2;
    job.enough_improved = ender.source.token();
    const PackResult result = pack(job, {&ender}, journal);
    expect_sound(result);
    const Improved& record = *result.packing.metrics.improvement;
    EXPECT_LE(record.now, killer.now + 1e-9) << "what had been found is lost";
    EXPECT_LT(killer.now, record.before);
    EXPECT_GT(record.steps, 3) << "steps of the run before do not count";
}

TEST(Improve, DoesNotGoWithWhatHasAnotherAim) {
    for (const auto& change :
         std::vector<void (*)(PackOptions&)>{[](PackOptions& options) { options.fill = true; },
                                             [](PackOptions& options) { options.interlock = Interlock::place; }}) {
        Job job = job_of(1, {60, 50, 40});
        job.options.improve_steps = 3;
        change(job.options);
        EXPECT_THROW(pack(job), UsageError);
    }
    Job endless = job_of(1, {60, 50, 40});
    endless.options.improve = 5;
    EXPECT_THROW(pack(endless), UsageError) << "nobody holds the clock";
}

}  // namespace
}  // namespace spectralpack
