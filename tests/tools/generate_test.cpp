/// The generated sets: sound meshes, sizes as stated, the same bits everywhere.

#include "spectralpack/tools/generate.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <span>

#include "geometry/mesh_repair.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/mesh_figures.hpp"

namespace spectralpack::test {
namespace {

using namespace tools;

const std::span<const GeneratedSet> kSets = generated_sets();

/// FNV-1a over the names, counts, triangles and the bits of all coordinates.
std::uint64_t hash_of(const std::vector<GeneratedPart>& parts) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](std::uint64_t value) {
        for (int i = 0; i < 8; ++i, value >>= 8) {
            hash = (hash ^ (value & 255)) * 0x100000001b3u;
        }
    };
    for (const GeneratedPart& part : parts) {
        for (const char c : part.name) {
            add(static_cast<unsigned char>(c));
        }
        add(static_cast<std::uint64_t>(part.count));
        for (const Vec3& v : part.mesh.vertices) {
            add(std::bit_cast<std::uint64_t>(v.x));
            add(std::bit_cast<std::uint64_t>(v.y));
            add(std::bit_cast<std::uint64_t>(v.z));
        }
        for (const Triangle& t : part.mesh.triangles) {
            for (const std::uint32_t index : t) {
                add(index);
            }
        }
    }
    return hash;
}

void expect_sound(const GeneratedPart& part) {
    SCOPED_TRACE(part.name);
    const MeshFigures figures = inspect_mesh(part.mesh);
    EXPECT_TRUE(figures.watertight());
    EXPECT_EQ(figures.edges.border, 0u);
    EXPECT_EQ(figures.edges.misdirected, 0u);
    EXPECT_EQ(figures.edges.crowded, 0u);
    EXPECT_EQ(figures.shells, 1u);
    EXPECT_EQ(figures.duplicates, 0u);
    EXPECT_EQ(figures.crossings.pairs, 0);
    EXPECT_GT(figures.volume, 0);
    EXPECT_EQ(figures.box.min, Vec3{});
    Mesh mended = part.mesh;
    const MeshRepair repair = repair_mesh(mended);
    EXPECT_TRUE(repair.repairs.empty()) << repair.repairs.front();
    EXPECT_FALSE(repair.unusable);
}

TEST(GeneratedSets, EveryMeshIsSoundWhateverTheSeed) {
    for (const GeneratedSet set : kSets) {
        for (const std::uint64_t seed : {0u, 1u, 2u}) {
            const bool letters = set == GeneratedSet::letters, segments = set == GeneratedSet::segments;
            const auto parts = generate_parts({set, seed, letters || segments ? std::nullopt : std::optional(200)});
            for (const GeneratedPart& part : parts) {
                expect_sound(part);
            }
            if (letters) break;
        }
    }
}

TEST(GeneratedSets, RefusesNumbersThatMakeNoSense) {
    EXPECT_THROW(generate_parts({GeneratedSet::pieces, 0, 0}), UsageError);
    EXPECT_THROW(generate_parts({GeneratedSet::pieces, 0, 10'000'001}), UsageError);
    EXPECT_THROW(generate_parts({GeneratedSet::letters, 0, 3}), UsageError) << "there are always seven";
    EXPECT_THROW(generate_parts({GeneratedSet::segments, 0, 3}), UsageError) << "there are always 25";
}

TEST(GeneratedSets, NamesAreUniqueAndCopiesAddUp) {
    const int expected[] = {1446, 286, 468, 48, 80, 8, 25};
    for (std::size_t i = 0; i < kSets.size(); ++i) {
        std::set<std::string> names;
        int copies = 0;
        for (const GeneratedPart& part : generate_parts({kSets[i], 5, {}})) {
            EXPECT_TRUE(names.insert(part.name).second) << part.name;
            EXPECT_GE(part.count, 1);
            copies += part.count;
        }
        EXPECT_EQ(copies, expected[i]);
    }
    int copies = 0;
    for (const GeneratedPart& part : generate_parts({GeneratedSet::pieces, 5, 37})) {
        copies += part.count;
    }
    EXPECT_EQ(copies, 37);
}

TEST(GeneratedSets, TheFirstPartsDoNotDependOnHowManyFollow) {
    const auto few = generate_parts({GeneratedSet::locks, 9, 20}), many = generate_parts({GeneratedSet::locks, 9, 90});
    ASSERT_LT(few.size(), many.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
        EXPECT_EQ(few[i].name, many[i].name);
        EXPECT_EQ(few[i].mesh.vertices, many[i].mesh.vertices);
    }
}

TEST(GeneratedSets, EverythingFitsTheTrayAsItLies) {
    constexpr double kRounding = 1e-9;
    for (const GeneratedSet set : kSets) {
        if (set == GeneratedSet::letters) continue;
        for (const GeneratedPart& part : generate_parts({set, 1, {}})) {
            const Vec3 size = bounding_box(part.mesh).size();
            EXPECT_LE(size.x, 480 + kRounding) << part.name;
            EXPECT_LE(size.y, 245 + kRounding) << part.name;
            EXPECT_LE(size.z, 200 + kRounding) << part.name;
        }
    }
}

TEST(GeneratedSets, PolyhedraAreTenKindsHalfOfThemConvex) {
    for (const std::uint64_t seed : {0u, 1u, 2u, 3u}) {
        const auto parts = generate_parts({GeneratedSet::polyhedra, seed, {}});
        ASSERT_EQ(parts.size(), 10u);
        double volume = 0;
        int convex = 0;
        for (const GeneratedPart& part : parts) {
            EXPECT_EQ(part.count, 8);
            EXPECT_LE(part.mesh.triangles.size(), 36u) << part.name;
            volume += part.count * signed_volume(part.mesh);
            // Convex: no vertex lies in front of a face.
            bool in_front = false;
            for (const Triangle& t : part.mesh.triangles) {
                const Vec3& a = part.mesh.vertices[t[0]];
                const Vec3 normal = cross(part.mesh.vertices[t[1]] - a, part.mesh.vertices[t[2]] - a);
                for (const Vec3& vertex : part.mesh.vertices) {
                    in_front = in_front || dot(normal, vertex - a) > 1e-9 * length(normal);
                }
            }
            convex += in_front ? 0 : 1;
        }
        EXPECT_EQ(convex, 5);
        // The paper's figure 17: 51.27 % of 36.98 x 41.98 x 56.37 mm.
        EXPECT_NEAR(volume, 44'867, 0.15 * 44'867) << seed;
    }
}

TEST(GeneratedSets, LettersFillTheirBoxWhateverTheSeed) {
    for (const GeneratedPart& part : generate_parts({GeneratedSet::letters, 7, {}})) {
        EXPECT_EQ(bounding_box(part.mesh).max, (Vec3{322, 322, 80})) << part.name;
    }
    EXPECT_EQ(hash_of(generate_parts({GeneratedSet::letters, 7, {}})),
              hash_of(generate_parts({GeneratedSet::letters, 8, {}})));
}

TEST(GeneratedSets, TheSameSeedGivesTheSameBitsOnEveryMachine) {
    const std::uint64_t expected[] = {5707763886658800452u, 3374524357999745200u, 17712619925501134617u,
                                      5849794097200047623u, 4732503296566822603u, 8801153097218782892u,
                                      14629577709095613703u};
    for (std::size_t i = 0; i < kSets.size(); ++i) {
        EXPECT_EQ(hash_of(generate_parts({kSets[i], 1, {}})), expected[i]) << i;
    }
}

TEST(GeneratedSets, SeedsDiffer) {
    EXPECT_NE(hash_of(generate_parts({GeneratedSet::tori, 1, {}})),
              hash_of(generate_parts({GeneratedSet::tori, 2, {}})));
}

}  // namespace
}  // namespace spectralpack::test
