/// Packing meshes that never were files.

#include <gtest/gtest.h>
#include <spectralpack/spectralpack.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <sstream>

#include "support/shapes.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

/// Brackets and cubes in a tray of 40 x 30 x 20 mm.
Job small_job() {
    Job job;
    job.options.tray = {40, 30, 20};
    job.options.voxel = 1;
    job.options.gap = 0.5;
    job.parts.push_back({.name = "bracket", .mesh = test::bracket(), .count = 12});
    job.parts.push_back({.name = "cube", .mesh = test::cube_mesh(6), .count = 5, .priority = 1});
    return job;
}

class EmptyFolder : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("spectralpack-memory-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        before_ = fs::current_path();
        fs::current_path(folder_);
    }
    void TearDown() override {
        fs::current_path(before_);
        fs::remove_all(folder_);
    }

    fs::path folder_, before_;
};

using InMemory = EmptyFolder;

TEST_F(InMemory, AScaleThatNoTransformHoldsIsRefused) {
    for (const double scale : {0.0, -1.0, 1e-300, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        Job job = small_job();
        job.parts[1].scale = scale;
        EXPECT_THROW(pack(job), UsageError) << scale;
    }
}

TEST_F(InMemory, ManyPartsOfOneMeshArePackedAsOneOfManyCopies) {
    const auto mesh = std::make_shared<const Mesh>(test::bracket());
    const auto transforms = [&](int parts, int count) {
        Job job = small_job();
        job.options.threads = 1;
        job.parts.clear();
        for (int i = 0; i < parts; ++i) {
            job.parts.push_back({.name = "part " + std::to_string(i), .mesh = mesh, .count = count});
        }
        std::vector<Transform> found;
        const PackResult result = pack(job);
        for (const Placement& placement : result.packing.trays.front().placements) {
            found.push_back(placement.transform);
        }
        return found;
    };
    const std::vector<Transform> one = transforms(1, 40);
    EXPECT_FALSE(one.empty());
    EXPECT_EQ(transforms(40, 1), one);
    EXPECT_EQ(transforms(8, 5), one);
}

TEST_F(InMemory, PacksBoxesAndBracketsWithoutAFile) {
    const PackResult result = pack(small_job());
    EXPECT_FALSE(result.failure);
    ASSERT_EQ(result.packing.trays.size(), 1u);
    const TrayPacking& tray = result.packing.trays.front();
    EXPECT_EQ(tray.placements.size(), 17u);
    EXPECT_TRUE(result.packing.unplaced.empty());
    ASSERT_TRUE(tray.disassembly);
    EXPECT_TRUE(tray.disassembly->complete);
    EXPECT_EQ(result.packing.parts[0].name, "bracket");
    EXPECT_EQ(result.packing.parts[0].mesh, "");
    EXPECT_TRUE(fs::is_empty(folder_)) << "something was written";

    const CheckReport report = check({result.packing, result.meshes}, 1);
    EXPECT_TRUE(report.ok()) << (report.findings.empty() ? "" : report.findings.front().message);
    EXPECT_GE(*report.min_gap, 0.5 - kCheckTolerance);
}

/// The same job from files is the same packing.
TEST_F(InMemory, FilesPackAlike) {
    const Job job = small_job();
    Job filed = job;
    filed.parts.clear();
    for (const Part& part : job.parts) {
        const fs::path file = folder_ / (part.name + ".off");
        std::string text = "OFF\n" + std::to_string(part.mesh.mesh()->vertices.size()) + " " +
                           std::to_string(part.mesh.mesh()->triangles.size()) + " 0\n";
        for (const Vec3& v : part.mesh.mesh()->vertices) {
            text += std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
        }
        for (const Triangle& t : part.mesh.mesh()->triangles) {
            text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
        }
        std::ofstream(file) << text;
        Part from_file = part;
        from_file.mesh = file.string();
        filed.parts.push_back(from_file);
    }
    const PackResult a = pack(job), b = pack(filed);
    EXPECT_EQ(a.packing.input_hash, b.packing.input_hash);
    ASSERT_EQ(a.packing.trays.size(), b.packing.trays.size());
    const auto& in_memory = a.packing.trays.front().placements;
    const auto& from_files = b.packing.trays.front().placements;
    ASSERT_EQ(in_memory.size(), from_files.size());
    for (std::size_t i = 0; i < in_memory.size(); ++i) {
        EXPECT_EQ(in_memory[i].part, from_files[i].part);
        EXPECT_EQ(in_memory[i].copy, from_files[i].copy);
        EXPECT_EQ(in_memory[i].transform, from_files[i].transform);
    }
}

TEST_F(InMemory, ABorrowedMeshIsNotCopied) {
    const Mesh cube = test::cube_mesh(6);
    Job job = small_job();
    job.parts = {{.name = "cube", .mesh = MeshInput::borrowed(cube), .count = 2}};
    const PackResult result = pack(job);
    EXPECT_EQ(result.meshes.front().get(), &cube);
}

TEST_F(InMemory, WhatCannotBeUsedIsNamedAndTheRestIsPacked) {
    Job job = small_job();
    Mesh torn = test::cube_mesh(6);
    torn.triangles.push_back({0, 1, 99});
    job.parts.push_back({.name = "torn", .mesh = torn});
    Mesh infinite = test::cube_mesh(6);
    infinite.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
    job.parts.push_back({.name = "infinite", .mesh = infinite});
    job.parts.push_back({.name = "nothing", .mesh = Mesh{}});
    const PackResult result = pack(job);
    EXPECT_EQ(result.packing.metrics.placed, 17);
    ASSERT_EQ(result.unusable.size(), 3u);
    EXPECT_EQ(result.unusable[0].file(), "torn");
    EXPECT_EQ(result.unusable[0].place(), "triangle 12");
    EXPECT_EQ(result.unusable[1].file(), "infinite");
    EXPECT_EQ(result.unusable[1].place(), "vertex 3");
    EXPECT_EQ(result.unusable[2].file(), "nothing");
    ASSERT_EQ(result.packing.unplaced.size(), 3u);
    EXPECT_EQ(result.packing.unplaced[0].reason, UnplacedReason::bad_file);
}

/// A packing file names mesh files, so one of meshes in memory cannot be written; other kinds can.
TEST_F(InMemory, APackingFileNeedsMeshFiles) {
    const PackResult result = pack(small_job());
    const Scene scene{result.packing, result.meshes};
    try {
        write_output(scene, folder_ / "build.json", 1);
        FAIL() << "was written";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("bracket"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(fs::is_empty(folder_));
    write_output(scene, folder_ / "build.3mf", 1);
    EXPECT_GT(fs::file_size(folder_ / "build.3mf"), 1000u);
    const Image picture = render(scene, {.width = 64, .height = 48}, 1);
    EXPECT_EQ(picture.rgb.size(), 64u * 48u * 3u);
}

TEST_F(InMemory, PicturesAreLeftOutOnceTheirTimeIsOver) {
    const PackResult result = pack(small_job());
    const Scene scene{result.packing, result.meshes};
    StopSource over;
    const DrawingTime time{{}, over.token()};
    EXPECT_EQ(write_output(scene, folder_ / "in-time.png", 1, time).size(), 1u);
    EXPECT_EQ(write_report(scene, folder_ / "in-time.html", {}, 1, time), 0);
    over.request(StopReason::time_limit);
    EXPECT_TRUE(write_output(scene, folder_ / "late.png", 2, time).empty());
    EXPECT_FALSE(fs::exists(folder_ / "late.png"));
    EXPECT_EQ(write_output(scene, folder_ / "late.stl", 2, time).size(), 1u);
    EXPECT_GT(write_report(scene, folder_ / "late.html", {}, 2, time), 2);
    std::ostringstream page;
    page << std::ifstream(folder_ / "late.html").rdbuf();
    EXPECT_NE(page.str().find("left out for time"), std::string::npos);
    EXPECT_EQ(page.str().find("data:image"), std::string::npos);
}

/// Runs out of memory once so many copies stand.
class OutOfMemory : public Listener {
  public:
    explicit OutOfMemory(int copies) : copies_(copies) {}
    void on_event(const Event& event) override {
        if (event.kind == EventKind::copy_placed && --copies_ == 0) throw std::bad_alloc();
    }

  private:
    int copies_;
};

TEST_F(InMemory, WhatStandsWhenMemoryRunsOutIsKept) {
    OutOfMemory listener(4);
    const PackResult result = pack(small_job(), {&listener});
    ASSERT_TRUE(result.failure);
    EXPECT_EQ(result.failure->kind(), ErrorKind::resource);
    EXPECT_EQ(result.packing.metrics.placed, 4);
    ASSERT_EQ(result.packing.trays.size(), 1u);
    EXPECT_EQ(result.packing.trays.front().placements.size(), 4u);
    EXPECT_EQ(result.packing.unplaced.size(), 13u);
}

/// Stops the run in a phase.
class StopIn : public Listener {
  public:
    explicit StopIn(Phase phase) : phase_(phase) {}
    void on_progress(const Progress& progress) override {
        if (progress.phase == phase_) source.request(StopReason::cancelled);
    }
    StopSource source;

  private:
    Phase phase_;
};

TEST_F(InMemory, WhatIsStoppedBeforeItBeginsPlacesNothingAndSaysSo) {
    StopIn listener(Phase::load);
    const PackResult result = pack(small_job(), {&listener, listener.source.token()});
    EXPECT_EQ(result.stopped, StopReason::cancelled);
    EXPECT_FALSE(result.failure);
    EXPECT_EQ(result.packing.metrics.placed, 0);
    EXPECT_EQ(estimate(small_job(), {&listener, listener.source.token()}).stopped, StopReason::cancelled);
    EXPECT_EQ(estimate(small_job()).stopped, StopReason::none);
}

TEST_F(InMemory, EnoughPlacedStillComesApart) {
    StopIn listener(Phase::search);
    Job job = small_job();
    job.enough_placed = listener.source.token();
    const PackResult none = pack(job, {&listener});
    EXPECT_EQ(none.stopped, StopReason::cancelled);
    EXPECT_EQ(none.packing.metrics.placed, 0);
    ASSERT_TRUE(none.packing.trays.front().disassembly);
    EXPECT_TRUE(none.packing.trays.front().disassembly->complete);
    const PackResult all = pack(small_job());
    EXPECT_EQ(all.stopped, StopReason::none);
}

}  // namespace
}  // namespace spectralpack
