#include <map>

#include "files.hpp"
#include "formats/zip_archive.hpp"
#include "support/remarks.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::names;

const std::string kRelationships =
    "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/"
    "relationships\"><Relationship Target=\"/3D/3dmodel.model\" Id=\"r\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

std::string mesh_xml(const Mesh& mesh) {
    std::ostringstream xml;
    xml << "<mesh><vertices>";
    for (const Vec3& v : mesh.vertices) {
        xml << "<vertex x=\"" << v.x << "\" y=\"" << v.y << "\" z=\"" << v.z << "\"/>";
    }
    xml << "</vertices><triangles>";
    for (const Triangle& t : mesh.triangles) {
        xml << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"/>";
    }
    xml << "</triangles></mesh>";
    return xml.str();
}

std::string object(const std::string& attributes, const std::string& content) {
    return "<object " + attributes + ">" + content + "</object>";
}

std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><model "
           "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" " +
           attributes + "><resources>" + resources + "</resources><build>" + build + "</build></model>";
}

std::string package(const std::string& root, const std::map<std::string, std::string>& others = {}) {
    std::vector<ZipEntry> entries{{"_rels/.rels", kRelationships}, {"3D/3dmodel.model", root}};
    for (const auto& [name, content] : others) {
        entries.push_back({name, content});
    }
    return make_zip(entries);
}

std::vector<LoadedMesh> read(const std::string& root, const std::map<std::string, std::string>& others = {}) {
    return test::read_as("file.3mf", package(root, others));
}

InputError refused(const std::string& root) { return test::refusal_of("file.3mf", package(root)); }

const std::string kCube = object("id=\"1\"", mesh_xml(test::cube_mesh(2)));
const std::string kItem = "<item objectid=\"1\"/>";

TEST(ThreeMf, UnitsAreTold) {
    const std::pair<const char*, double> units[] = {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
                                                    {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
    for (const auto& [name, mm] : units) {
        const auto loaded = read(model(kCube, kItem, "unit=\"" + std::string(name) + "\""));
        EXPECT_EQ(loaded.at(0).unit, mm);
        EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 8);  // in the file's own unit
    }
    EXPECT_EQ(read(model(kCube, kItem))[0].unit, 1);
    EXPECT_TRUE(names(refused(model(kCube, kItem, "unit=\"furlong\"")).cause(), {"furlong"}));
}

TEST(ThreeMf, ItemsOfOneObjectInOneOrientationAreInstances) {
    const auto loaded =
        read(model(kCube + object("id=\"2\" partnumber=\"box &amp; lid\" name=\"n\"",
                                  mesh_xml(test::box_mesh({0, 0, 0}, {1, 2, 3}))),
                   "<item objectid=\"1\"/><item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>"
                   "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 7 8 9\"/>"
                   "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 0\" partnumber=\"turned\"/>"));
    ASSERT_EQ(loaded.size(), 3u);
    EXPECT_EQ(loaded[0].object, "1");
    EXPECT_EQ(loaded[0].instances, 2);
    EXPECT_EQ(loaded[0].name, "file-1");
    EXPECT_EQ(loaded[0].item_transform, Transform{});
    EXPECT_EQ(loaded[1].object, "2");
    EXPECT_EQ(loaded[1].name, "box & lid");
    EXPECT_EQ(bounding_box(loaded[1].mesh), (Box{{5, 0, 0}, {6, 2, 3}}));
    EXPECT_EQ(loaded[1].item_transform->translation, (Vec3{5, 0, 0}));
    EXPECT_EQ(loaded[2].name, "turned");
    EXPECT_EQ(loaded[2].instances, 1);
    // Row vectors: (x, y, z) goes to (-y, x, z).
    EXPECT_EQ(loaded[2].item_transform->linear, (Mat3{{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}}));
    EXPECT_EQ(bounding_box(loaded[2].mesh), (Box{{-2, 0, 0}, {0, 2, 2}}));
}

TEST(ThreeMf, ComponentsNestAndTheirTransformsMultiply) {
    const auto loaded =
        read(model(kCube +
                       object("id=\"2\"",
                              "<components><component objectid=\"1\"/>"
                              "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 4 0 0\"/></components>") +
                       object("id=\"3\"",
                              "<components><component objectid=\"2\"/>"
                              "<component objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 0 4 0\"/></components>"),
                   "<item objectid=\"3\" transform=\"2 0 0 0 2 0 0 0 2 100 0 0\"/>"));
    ASSERT_EQ(loaded.size(), 1u);
    EXPECT_EQ(loaded[0].mesh.triangles.size(), 48u);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 4 * 64);
    EXPECT_EQ(bounding_box(loaded[0].mesh), (Box{{100, 0, 0}, {112, 12, 4}}));
}

TEST(ThreeMf, AMirroredItemIsAShapeOfItsOwnAndStaysOutward) {
    const Mesh tetrahedron{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    const auto loaded = read(model(object("id=\"1\"", mesh_xml(tetrahedron)),
                                   kItem + "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"));
    ASSERT_EQ(loaded.size(), 2u);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 1);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[1].mesh), 1);
    EXPECT_EQ(bounding_box(loaded[1].mesh), (Box{{-3, 0, 0}, {0, 2, 1}}));
    EXPECT_TRUE(loaded[1].repairs.empty());
}

TEST(ThreeMf, WhatIsNotToBePrintedIsLeftOutWithANote) {
    const auto loaded = read(model(kCube + object("id=\"2\" type=\"support\"", mesh_xml(test::cube_mesh(5))),
                                   "<item objectid=\"1\"/><item objectid=\"1\" printable=\"0\"/>"
                                   "<item objectid=\"2\"/>"));
    ASSERT_EQ(loaded.size(), 1u);
    EXPECT_EQ(loaded[0].instances, 1);
    EXPECT_TRUE(test::any_names(test::texts_of(loaded[0].warnings), {"printable"}));
    EXPECT_TRUE(test::any_names(test::texts_of(loaded[0].warnings), {"support"}));
    EXPECT_TRUE(names(refused(model(kCube, "<item objectid=\"1\" printable=\"0\"/>")).cause(), {"printable"}));
}

TEST(ThreeMf, ExtensionsThatDoNotChangeGeometryAreIgnored) {
    const auto loaded = read(model(
        "<m:colorgroup xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
        "id=\"9\"><m:color color=\"#FF0000\"/></m:colorgroup><basematerials id=\"8\"><base/>"
        "</basematerials>" +
            object("id=\"1\" pid=\"9\" pindex=\"0\" p:UUID=\"00000000-0000-0000-0000-000000000000\"",
                   "<metadatagroup><metadata name=\"a\">b</metadata></metadatagroup>" + mesh_xml(test::cube_mesh(2))) +
            "<x:object xmlns:x=\"urn:other\" id=\"1\"><x:mesh/></x:object>",
        "<item objectid=\"1\" p:UUID=\"00000000-0000-0000-0000-000000000000\"/>", "requiredextensions=\"p\""));
    ASSERT_EQ(loaded.size(), 1u);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 8);
}

TEST(ThreeMf, ObjectsInOtherModelPartsAreFollowed) {
    const std::string other = model(object("id=\"1\"", mesh_xml(test::cube_mesh(3))), "");
    const auto loaded =
        read(model(object("id=\"1\"",
                          "<components><component objectid=\"1\" p:path=\"/3D/Objects/o.model\"/>"
                          "</components>"),
                   kItem + "<item objectid=\"1\" p:path=\"/3D/Objects/o.model\"/>", "requiredextensions=\"p\""),
             {{"3D/Objects/o.model", other}});
    ASSERT_EQ(loaded.size(), 2u);
    EXPECT_EQ(loaded[0].object, "1");
    EXPECT_EQ(loaded[1].object, "3D/Objects/o.model#1");
    EXPECT_DOUBLE_EQ(signed_volume(loaded[0].mesh), 27);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[1].mesh), 27);
    EXPECT_EQ(refused(model(object("id=\"1\"",
                                   "<components><component objectid=\"1\" p:path=\"/gone\"/>"
                                   "</components>"),
                            kItem))
                  .place(),
              "gone");
}

TEST(ThreeMf, UnknownRequiredExtensionsAreRefusedByName) {
    EXPECT_TRUE(names(refused(model(kCube, kItem, "xmlns:z=\"urn:lattice\" requiredextensions=\"z\"")).cause(),
                      {"urn:lattice"}));
    EXPECT_TRUE(names(refused(model(kCube, kItem, "requiredextensions=\"q\"")).cause(), {"q"}));
    EXPECT_EQ(read(model(kCube, kItem, "xmlns:z=\"urn:lattice\"")).size(), 1u);
}

TEST(ThreeMf, WhatTheSpecificationForbidsIsRefused) {
    const struct {
        std::string root;
        std::vector<test::Fact> named;
    } cases[] = {
        {model(kCube, ""), {"items"}},
        {model(kCube, "<item objectid=\"2\"/>"), {"object", 2}},
        {model(kCube + kCube, kItem), {"object", 1}},
        {model(kCube, "<item/>"), {"objectid"}},
        {model(kCube, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0\"/>"), {"transform", 12}},
        {model(kCube, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 x 0 0 0\"/>"), {"transform", "x"}},
        {model(kCube, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"/>"), {"transform"}},
        {model(kCube, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 nan 0 0 0\"/>"), {"transform", "nan"}},
        {model(object("id=\"1\"", "<mesh><vertices><vertex x=\"0\" y=\"0\"/></vertices></mesh>"), kItem),
         {"attribute", "z"}},
        {model(object("id=\"1\"", "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"1,5\"/></vertices></mesh>"), kItem),
         {"1,5"}},
        {model(object("id=\"1\"",
                      "<mesh><vertices/><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"
                      "</triangles></mesh>"),
               kItem),
         {"triangle", "vertex", 0}},
        {model(object("id=\"1\"",
                      "<mesh><vertices/><triangles><triangle v1=\"-1\" v2=\"1\" v3=\"2\"/>"
                      "</triangles></mesh>"),
               kItem),
         {"vertex", -1}},
        {model(object("id=\"1\"", "<mesh/>"), kItem), {"triangles"}},
        {"<html/>", {"3MF"}},
        {"<model", {"XML"}},
        {"", {"XML"}},
        {"<!DOCTYPE model [<!ENTITY a \"b\">]>" + model(kCube, kItem).substr(38), {"document type"}},
    };
    for (const auto& [root, named] : cases) {
        EXPECT_TRUE(names(refused(root).what(), named)) << " for " << root;
    }
}

TEST(ThreeMf, ComponentsThatMultiplyOrContainThemselvesAreRefused) {
    for (const std::string& leaf : {mesh_xml(test::cube_mesh(2)), std::string("<mesh/>"), std::string()}) {
        std::string resources = object("id=\"1\"", leaf);
        for (int level = 2; level < 30; ++level) {
            std::string components;
            for (int i = 0; i < 10; ++i) {
                components += "<component objectid=\"" + std::to_string(level - 1) + "\"/>";
            }
            resources += object("id=\"" + std::to_string(level) + "\"", "<components>" + components + "</components>");
        }
        EXPECT_TRUE(names(refused(model(resources, "<item objectid=\"29\"/>")).cause(), {"multiply"}));
    }
    const auto component = [](int id) {
        return "<components><component objectid=\"" + std::to_string(id) + "\"/></components>";
    };
    EXPECT_TRUE(names(refused(model(object("id=\"1\"", component(1)), kItem)).cause(), {"nested"}));
    std::string chain = object("id=\"1\"", mesh_xml(test::cube_mesh(2)));
    for (int id = 2; id < 20'000; ++id) {
        chain += object("id=\"" + std::to_string(id) + "\"", component(id - 1));
    }
    EXPECT_TRUE(names(refused(model(chain, "<item objectid=\"19999\"/>")).cause(), {"nested"}));
}

TEST(ThreeMf, ItemsThatMultiplyALargeMeshAreRefusedButManyOfItsOwnSizeAreNot) {
    const std::string torus = object("id=\"1\"", mesh_xml(test::torus_mesh(30, 8, 100, 50)));  // 10 000 triangles
    const auto items = [](int count) {
        std::string xml;
        for (int i = 1; i <= count; ++i) {
            xml += "<item objectid=\"1\" transform=\"" + std::to_string(i) + " 0 0 0 1 0 0 0 1 0 0 0\"/>";
        }
        return xml;
    };
    EXPECT_EQ(read(model(torus, items(40))).size(), 40u);
    EXPECT_TRUE(names(refused(model(torus, items(500))).cause(), {"multiply"}));
}

TEST(ThreeMf, PackagesWithoutAModelAreRefused) {
    EXPECT_TRUE(names(test::refusal_of("a.3mf", make_zip({{"a.txt", "b"}})).cause(), {"3MF"}));
    EXPECT_EQ(test::refusal_of("a.3mf", make_zip({{"_rels/.rels", kRelationships}})).place(), "3D/3dmodel.model");
    EXPECT_TRUE(names(test::refusal_of("a.3mf", make_zip({{"_rels/.rels", "<Relationships/>"}})).cause(), {"model"}));
    EXPECT_TRUE(names(test::refusal_of("a.3mf", "PK\x03\x04").cause(), {"ZIP"}));
    EXPECT_TRUE(names(test::refusal_of("a.3mf", "").cause(), {"empty"}));
}

TEST(ThreeMf, ManyItemsWithTransformsOfTheirOwnAreRead) {
    std::string items;
    for (int i = 0; i < 5000; ++i) {
        items += "<item objectid=\"1\" transform=\"" + std::to_string(1 + i % 2500) + " 0 0 0 1 0 0 0 1 0 0 0\"/>";
    }
    const auto loaded = read(model(kCube, items));
    ASSERT_EQ(loaded.size(), 2500u);
    EXPECT_EQ(loaded[7].instances, 2);
    EXPECT_DOUBLE_EQ(signed_volume(loaded[7].mesh), 8 * 8);
}

}  // namespace
}  // namespace spectralpack
