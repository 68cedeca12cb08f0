#include <rapidcheck.h>

#include "core/random.hpp"
#include "files.hpp"
#include "geometry/mesh_edges.hpp"
#include "support/data.hpp"

namespace spectralpack {
namespace {

/// dim as in the file: x, z, y.
std::string binvox(int x, int z, int y, const std::string& runs, const std::string& more = "") {
    return "#binvox 1\ndim " + std::to_string(x) + " " + std::to_string(z) + " " + std::to_string(y) + "\n" + more +
           "data\n" + runs;
}

TEST(Binvox, ABlockOfVoxelsIsAClosedBox) {
    const std::string runs = {0, 1, 1, 2, 0, 3, 1, 2, 0, 4, 1, 12};  // x = 0: some; x = 1: all
    const auto loaded = test::read_as("a.binvox", binvox(2, 3, 4, runs, "translate 10 20 30\nscale 8\n"));
    ASSERT_EQ(loaded.size(), 1u);
    EXPECT_EQ(bounding_box(loaded[0].mesh), (Box{{10, 20, 30}, {14, 28, 36}}));
    EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 16 * 8);
    EXPECT_TRUE(is_closed(loaded[0].mesh));
    EXPECT_TRUE(loaded[0].repairs.empty());
}

TEST(Binvox, VolumeAndAreaAreThoseOfTheVoxels) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        const int nx = 1 + static_cast<int>(random.below(5)), ny = 1 + static_cast<int>(random.below(5)),
                  nz = 1 + static_cast<int>(random.below(5));
        std::vector<int> voxels(static_cast<std::size_t>(nx * ny * nz));
        std::string runs;
        int solid = 0, faces = 0;
        for (int& voxel : voxels) {
            voxel = random.below(2) == 1;
            solid += voxel;
            runs += {static_cast<char>(voxel), 1};
        }
        const auto at = [&](int x, int y, int z) {
            const bool inside = x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
            return inside ? voxels[static_cast<std::size_t>((x * nz + z) * ny + y)] : 0;
        };
        for (int x = 0; x < nx; ++x) {
            for (int y = 0; y < ny; ++y) {
                for (int z = 0; z < nz; ++z) {
                    if (!at(x, y, z)) continue;
                    faces += 6 - at(x - 1, y, z) - at(x + 1, y, z) - at(x, y - 1, z) - at(x, y + 1, z) -
                             at(x, y, z - 1) - at(x, y, z + 1);
                }
            }
        }
        RC_PRE(solid > 0);
        const double edge = 5.0 / std::max({nx, ny, nz});
        const Mesh mesh = test::read_as("a.binvox", binvox(nx, nz, ny, runs, "scale 5\n"))[0].mesh;
        RC_ASSERT(is_closed(mesh));
        RC_ASSERT(std::abs(signed_volume(mesh) - solid * edge * edge * edge) < 1e-9);
        RC_ASSERT(std::abs(surface_area(mesh) - faces * edge * edge) < 1e-9);
    }));
}

TEST(Binvox, WhatIsWrongIsRefused) {
    const std::string good = {1, 8};
    EXPECT_EQ(test::read_as("a.binvox", binvox(2, 2, 2, good)).size(), 1u);
    for (const std::string& bytes :
         {std::string("#binvox 2\ndim 2 2 2\ndata\n") + good, std::string("#binvox 1\ndata\n") + good,
          std::string("#binvox 1\ndim 2 2 2\n"), binvox(2, 2, 3, good), binvox(0, 2, 2, good), binvox(-2, -2, 2, good),
          binvox(2, 2, 2, good + '\1'), binvox(2, 2, 2, ""), binvox(2, 2, 2, good, "scale 0\n"),
          binvox(2, 2, 2, good, "scale nan\n"), binvox(2, 2, 2, good, "colour 7\n"),
          binvox(2, 2, 2, std::string({0, 8})), binvox(65536, 65536, 65536, good)}) {
        EXPECT_FALSE(test::refusal_of("a.binvox", bytes).cause().empty());
    }
}

TEST(Binvox, ThePublishedPiecesAreRead) {
    SPECTRALPACK_NEEDS_DATA();
    const auto folder = *test::benchmark_data() / "voxel-instances" / "data";
    int read = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
        if (file.path().extension() != ".binvox" || read == 5) continue;
        EXPECT_TRUE(is_closed(read_meshes(file.path())[0].mesh)) << file.path();
        ++read;
    }
    EXPECT_EQ(read, 5);
}

}  // namespace
}  // namespace spectralpack
