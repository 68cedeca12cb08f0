#include <cmath>

#include "files.hpp"
#include "formats/csv.hpp"
#include "formats/zip_archive.hpp"
#include "packings.hpp"
#include "support/data.hpp"

namespace spectralpack {
namespace {

std::string golden(const std::string& name) {
    return test::read_text(std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / "tests" / "formats" / "golden" / name);
}

std::string entry_of(const std::string& archive, const std::string& entry) {
    std::string text;
    ZipReader("file", archive).unpack(entry, 1 << 30, [&](std::string_view piece) { text += piece; });
    return text;
}

TEST(Write3mf, ThePackageIsTheOneOnRecordAndAlwaysTheSame) {
    const test::TemporaryFolder folder;
    write_3mf(test::small_packing(), test::small_meshes(), folder / "a.3mf");
    write_3mf(test::small_packing(), test::small_meshes(), folder / "b.3mf");
    const std::string bytes = test::read_text(folder / "a.3mf");
    EXPECT_EQ(bytes, test::read_text(folder / "b.3mf"));
    EXPECT_EQ(entry_of(bytes, "3D/3dmodel.model"), golden("3dmodel.model"));
    EXPECT_EQ(entry_of(bytes, "[Content_Types].xml"), golden("content_types.xml"));
    EXPECT_EQ(entry_of(bytes, "_rels/.rels"), golden("rels.xml"));
}

TEST(Write3mf, TransformsAndMeshesReadBackEqual) {
    RandomStream random(7);
    Packing packing;
    packing.container.size = {100, 100, 100};
    packing.parts.resize(2);
    packing.parts[0].name = "cube";
    packing.parts[1].name = "torus";
    packing.parts[0].count = packing.parts[1].count = 10;
    packing.trays.resize(1);
    // Coordinates that no float holds are written as doubles; read back they are the same.
    const PartMeshes meshes{std::make_shared<Mesh>(test::cube_mesh(0.1 + 1.0 / 3)),
                            std::make_shared<Mesh>(test::torus_mesh(3, 1))};
    for (int i = 0; i < 20; ++i) {
        Placement placement;
        placement.part = i % 2;
        placement.copy = i / 2;
        placement.transform = {10 * random.unit() * test::random_rotation(random),
                               {100 * random.unit(), 1e-7 * random.unit(), 100}};
        packing.trays[0].placements.push_back(placement);
    }
    const test::TemporaryFolder folder;
    write_3mf(packing, meshes, folder / "p.3mf");
    const auto loaded = read_meshes(folder / "p.3mf");
    ASSERT_EQ(loaded.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
        const Placement& placement = packing.trays[0].placements[i];
        EXPECT_EQ(loaded[i].item_transform, placement.transform);
        EXPECT_EQ(loaded[i].name, packing.parts[i % 2].name);
        EXPECT_EQ(loaded[i].unit, 1);
        const Mesh placed = transformed(*meshes[i % 2], placement.transform);
        ASSERT_EQ(loaded[i].mesh.triangles.size(), placed.triangles.size());
        for (std::size_t t = 0; t < placed.triangles.size(); ++t) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                EXPECT_EQ(loaded[i].mesh.vertices[loaded[i].mesh.triangles[t][corner]],
                          placed.vertices[placed.triangles[t][corner]]);
            }
        }
    }
}

TEST(Write3mf, EqualMeshesAreWrittenOnceAndEveryCopyIsAnItem) {
    const auto cube = std::make_shared<Mesh>(test::cube_mesh(10));
    Packing packing;
    packing.container.size = {100, 100, 100};
    packing.parts.resize(3);
    for (std::size_t i = 0; i < 3; ++i) {
        packing.parts[i].name = "part " + std::to_string(i);
    }
    packing.trays.resize(2);
    for (int part = 0; part < 2; ++part) {  // part 2 is not placed
        for (auto& tray : packing.trays) {
            tray.placements.push_back({part, 0, 0, false, {(1.0 + part) * Mat3{}, {5, 5, 5}}});
        }
    }
    const test::TemporaryFolder folder;
    write_3mf(packing, {cube, cube, std::make_shared<Mesh>(test::cube_mesh(1))}, folder / "p.3mf");
    const std::string model = entry_of(test::read_text(folder / "p.3mf"), "3D/3dmodel.model");
    const auto occurrences = [&](const std::string& text) {
        int count = 0;
        for (std::size_t at = model.find(text); at != std::string::npos; at = model.find(text, at + 1)) {
            ++count;
        }
        return count;
    };
    EXPECT_EQ(occurrences("<object "), 1);
    EXPECT_EQ(occurrences("<item "), 4);
    const auto loaded = read_meshes(folder / "p.3mf");
    ASSERT_EQ(loaded.size(), 2u);  // by scale
    EXPECT_EQ(loaded[0].name, "part 0");
    EXPECT_EQ(loaded[1].name, "2 part 1");
    EXPECT_EQ(loaded[0].instances, 2);
    // The second tray stands beside the first, nothing leaves the positive octant.
    EXPECT_TRUE(test::contains(model, "5 5 5\""));
    EXPECT_TRUE(test::contains(model, "125 5 5\""));
}

TEST(Write3mf, AMeshIsNamedWithoutScaleAndWrittenOnceAlsoWhereItWasReadTwice) {
    Packing packing;
    packing.container.size = {100, 100, 100};
    packing.parts.resize(3);
    packing.parts[0].name = "hook x 1.02";
    packing.parts[0].scale = 1.02;
    packing.parts[1].name = "hook";
    packing.parts[2].name = "lid x 2";  // somebody calls it so
    packing.trays.resize(1);
    for (int part = 0; part < 3; ++part) {
        const double scale = packing.parts[static_cast<std::size_t>(part)].scale;
        packing.trays[0].placements.push_back({part, 0, 0, false, {scale * Mat3{}, {30.0 * part, 5, 5}}});
    }
    const auto cube = [](double size) { return std::make_shared<Mesh>(test::cube_mesh(size)); };
    const test::TemporaryFolder folder;
    write_3mf(packing, {cube(10), cube(10), cube(20)}, folder / "p.3mf");
    const std::string model = entry_of(test::read_text(folder / "p.3mf"), "3D/3dmodel.model");
    EXPECT_TRUE(test::contains(model, "<object id=\"1\" type=\"model\" name=\"hook\""));
    EXPECT_TRUE(test::contains(model, "<object id=\"2\" type=\"model\" name=\"lid x 2\""));
    EXPECT_FALSE(test::contains(model, "<object id=\"3\""));
    EXPECT_TRUE(test::contains(model, "partnumber=\"1 hook x 1.02\""));
    EXPECT_TRUE(test::contains(model, "partnumber=\"2 hook\""));
}

TEST(WriteStl, HoldsEveryCopyWhereItWasPlaced) {
    const test::TemporaryFolder folder;
    const Packing packing = test::small_packing();
    const PartMeshes meshes = test::small_meshes();
    write_stl(packing, meshes, folder / "p.stl");
    const auto loaded = read_meshes(folder / "p.stl");
    ASSERT_EQ(loaded.size(), 1u);
    double volume = 0;
    Box box;
    for (std::size_t tray = 0; tray < 2; ++tray) {
        for (const Placement& placement : packing.trays[tray].placements) {
            Mesh placed = transformed(*meshes[static_cast<std::size_t>(placement.part)], placement.transform);
            for (Vec3& vertex : placed.vertices) {
                vertex.x += static_cast<double>(tray) * 120;
            }
            volume += signed_volume(placed);
            box.add(bounding_box(placed));
        }
    }
    EXPECT_EQ(loaded[0].mesh.triangles.size(), 36u);
    EXPECT_NEAR(signed_volume(loaded[0].mesh), volume, 1e-5 * volume);
    EXPECT_LT(length(bounding_box(loaded[0].mesh).min - box.min), 1e-5);
    EXPECT_LT(length(bounding_box(loaded[0].mesh).max - box.max), 1e-5);
}

TEST(WriteStl, NormalsPointOutwards) {
    const test::TemporaryFolder folder;
    write_stl(test::small_packing(), test::small_meshes(), folder / "p.stl");
    const std::string bytes = test::read_text(folder / "p.stl");
    for (std::size_t at = 84; at < bytes.size(); at += 50) {
        float f[12];
        std::memcpy(f, bytes.data() + at, sizeof f);
        const Vec3 a{f[3], f[4], f[5]}, b{f[6], f[7], f[8]}, c{f[9], f[10], f[11]}, normal{f[0], f[1], f[2]};
        EXPECT_NEAR(length(normal), 1, 1e-6);
        EXPECT_GT(dot(normal, cross(b - a, c - a)), 0);
    }
}

TEST(WriteTransforms, TheTableIsTheOneOnRecordAndParses) {
    const test::TemporaryFolder folder;
    Packing packing = test::small_packing();
    write_transforms_csv(packing, folder / "p.csv");
    const std::string text = test::read_text(folder / "p.csv");
    EXPECT_EQ(text, golden("transforms.csv"));
    const auto rows = parse_csv("p.csv", text);
    ASSERT_EQ(rows.size(), 4u);
    for (const CsvRow& row : rows) {
        EXPECT_EQ(row.fields.size(), 18u);
    }
    EXPECT_EQ(rows[1].fields[2], packing.parts[0].name);
}

TEST(Writers, ReplaceFilesWholeOrNotAtAll) {
    const test::TemporaryFolder folder;
    const Packing packing = test::small_packing();
    const PartMeshes meshes = test::small_meshes();
    const std::string nowhere = (folder / "no folder/p").string();
    EXPECT_THROW(write_packing(packing, nowhere), ResourceError);
    EXPECT_THROW(write_3mf(packing, meshes, nowhere), ResourceError);
    EXPECT_THROW(write_stl(packing, meshes, nowhere), ResourceError);
    EXPECT_THROW(write_transforms_csv(packing, nowhere), ResourceError);
    test::write_bytes(folder / "p.stl", "old");
    write_stl(packing, meshes, folder / "p.stl");
    EXPECT_NE(test::read_text(folder / "p.stl"), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace spectralpack
