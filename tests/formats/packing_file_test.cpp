#include "formats/packing_file.hpp"

#include <rapidcheck.h>

#include <bit>

#include "files.hpp"
#include "packings.hpp"
#include "spectralpack/names.hpp"
#include "support/data.hpp"

namespace spectralpack {
namespace {

using test::contains;
using test::names;
using test::refusal;

std::filesystem::path golden(const std::string& name) {
    return std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / "tests" / "formats" / "golden" / name;
}

Packing read_text_as_packing(const std::string& text) {
    const test::TemporaryFolder folder;
    return read_packing(test::write_bytes(folder / "p.json", text));
}

TEST(PackingFile, TheLayoutIsTheOneOnRecord) {
    EXPECT_EQ(packing_to_json(test::small_packing(), "/elsewhere/out"), test::read_text(golden("packing.json")));
}

TEST(PackingFile, ReadsTheReasonsOfVersion01) {
    const std::pair<const char*, UnplacedReason> earlier[] = {{"tray_full", UnplacedReason::no_place},
                                                              {"interlocked", UnplacedReason::cannot_leave},
                                                              {"unusable", UnplacedReason::bad_file},
                                                              {"stopped", UnplacedReason::not_tried},
                                                              {"too_large", UnplacedReason::too_large}};
    for (const auto& [word, reason] : earlier) {
        std::string text = test::read_text(golden("packing.json"));
        const std::string now = "\"no_place\"";
        text.replace(text.find(now), now.size(), "\"" + std::string(word) + "\"");
        const Packing packing = read_text_as_packing(text);
        EXPECT_EQ(packing.unplaced[0].reason, reason) << word;
        EXPECT_TRUE(contains(packing_to_json(packing, "/"), "\"" + std::string(to_string(reason)) + "\"")) << word;
    }
}

TEST(PackingFile, EveryFieldComesBack) {
    const test::TemporaryFolder folder;
    const Packing written = test::small_packing();
    write_packing(written, folder / "p.json");
    const Packing read = read_packing(folder / "p.json");
    // The text tells all fields apart (see the golden file), so equal text is equal content.
    EXPECT_EQ(packing_to_json(read, folder.path()), packing_to_json(written, folder.path()));
    EXPECT_EQ(read.options.seed, written.options.seed);
    EXPECT_EQ(read.options.verify_with, written.options.verify_with);
    EXPECT_EQ(read.parts[1].object, "7");
    EXPECT_EQ(read.parts[1].item_transform, written.parts[1].item_transform);
    EXPECT_EQ(read.trays[0].placements[1].transform, written.trays[0].placements[1].transform);
    EXPECT_EQ(read.trays[0].bounding_box, written.trays[0].bounding_box);
    EXPECT_TRUE(read.trays[1].bounding_box.empty());
    EXPECT_EQ(read.unplaced[0].reason, UnplacedReason::no_place);
}

TEST(PackingFile, EveryDoubleComesBackBitByBit) {
    EXPECT_TRUE(rc::check([](const std::vector<std::uint64_t>& bits) {
        Packing packing = test::small_packing();
        std::vector<double> numbers;
        for (const std::uint64_t b : bits) {
            const auto number = std::bit_cast<double>(b);
            if (std::isfinite(number)) numbers.push_back(number);
        }
        for (const double special : {-0.0, 5e-324, 1.7976931348623157e308, 0.1, 1.0 / 3}) {
            numbers.push_back(special);
        }
        packing.trays[0].layers.area = numbers;
        const Packing read = read_text_as_packing(packing_to_json(packing, "."));
        RC_ASSERT(read.trays[0].layers.area.size() == numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            RC_ASSERT(std::bit_cast<std::uint64_t>(read.trays[0].layers.area[i]) ==
                      std::bit_cast<std::uint64_t>(numbers[i]));
        }
    }));
}

TEST(PackingFile, MeshPathsAreRelativeToTheFileAndUsableWhenRead) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "out/deep");
    std::filesystem::create_directories(folder / "meshes");
    test::write_bytes(folder / "meshes/a b.stl", "");
    std::filesystem::create_directory_symlink(folder / "out/deep", folder / "link");
    Packing packing = test::small_packing();
    packing.parts[0].mesh = (folder / "meshes/../meshes/a b.stl").string();
    for (const std::string out : {"out/deep/p.json", "link/p.json", "meshes/p.json"}) {
        write_packing(packing, folder / out);
        EXPECT_FALSE(contains(test::read_text(folder / out), "\"/")) << out;  // nothing absolute
        EXPECT_TRUE(std::filesystem::equivalent(read_packing(folder / out).parts[0].mesh, folder / "meshes/a b.stl"))
            << out;
    }
}

TEST(PackingFile, NamesOfAnyKindSurvive) {
    Packing packing = test::small_packing();
    const std::string name = "a \"b\" \\ \n\t\x01 \u00e4 \U0001F9CA </script>";
    packing.parts[0].name = name;
    EXPECT_EQ(read_text_as_packing(packing_to_json(packing, ".")).parts[0].name, name);
    packing.parts[0].name = "not utf-8: \xff";
    EXPECT_EQ(read_text_as_packing(packing_to_json(packing, ".")).parts[0].name, "not utf-8: \ufffd");
    packing.parts[0].mesh = "m\xff.stl";
    EXPECT_THROW(packing_to_json(packing, "."), UsageError);
}

TEST(PackingFile, LittleIsNeededAndTheRestHasDefaults) {
    const Packing packing = read_text_as_packing(
        R"({"format": "spectralpack/packing", "version": 1, "container": {"size": [10, 20, 30]}, "later": {},
            "parts": [{"mesh": "sub/a.stl"}],
            "trays": [{"placements": [{"part": 0, "transform": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]}]})");
    EXPECT_EQ(packing.container.size, (Vec3{10, 20, 30}));
    EXPECT_EQ(packing.options.tray, (Vec3{10, 20, 30}));
    EXPECT_EQ(packing.parts[0].name, "a");
    EXPECT_EQ(packing.trays[0].placements[0].transform, Transform{});
}

TEST(PackingFile, HoldsContainersAndKeepOuts) {
    Packing packing;
    packing.container.size = {10, 20, 30};
    packing.container.mesh = StandingMesh{"/jobs/cup.stl", {2 * Mat3{}, {1, 2, 3}}};
    packing.container.keep_out = {{Box{{0, 0, 0}, {1, 2, 3}}}, {{}, StandingMesh{"/jobs/pin.stl", {}}}};
    packing.container.physical = true;
    const Packing read = parse_packing("/jobs/a/b.json", packing_to_json(packing, "/jobs/a"));
    EXPECT_EQ(read.container.mesh->file, "/jobs/cup.stl");
    EXPECT_EQ(read.container.mesh->transform, packing.container.mesh->transform);
    ASSERT_EQ(read.container.keep_out.size(), 2u);
    EXPECT_EQ(read.container.keep_out[0].box, packing.container.keep_out[0].box);
    EXPECT_EQ(read.container.keep_out[1].mesh->file, "/jobs/pin.stl");
    EXPECT_TRUE(read.container.physical);
}

TEST(PackingFile, WhatIsWrongIsRefusedWithItsPath) {
    struct Case {
        const char *old_text, *new_text, *place;
    };
    const Case cases[] = {
        {"\"spectralpack/packing\"", "\"other\"", "format"},
        {"\"format\":", "\"form\":", "format"},
        {"\"version\": 1", "\"version\": 2", "version"},
        {"\"version\": 1", "\"version\": \"1\"", "version"},
        {"\"version\": 1", "\"version\": 1.0", "version"},
        {"\"units\": \"mm\"", "\"units\": \"inch\"", "units"},
        {"[100.0,80.0,60.5]", "[100.0,80.0]", "container.size"},
        {"[100.0,80.0,60.5]", "[100.0,-80.0,60.5]", "container.size[1]"},
        {"\"physical\":false", "\"physical\":1", "container.physical"},
        {"\"keep_out\":[]", "\"keep_out\":[{}]", "container.keep_out[0].box"},
        {"\"keep_out\":[]", "\"keep_out\":[{\"box\":[[0,0,0],[1,1,0]]}]", "container.keep_out[0].box"},
        {"\"mesh\":null,\"tr", "\"mesh\":\"cup.stl\",\"tr", "container.transform"},
        {"\"transform\":null", "\"transform\":\"here\"", "container.transform"},
        {"\"transform\":null", "\"transform\":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "container.transform"},
        {"\"is\":null", "\"is\":7", "container.is"},
        {"\"keep_out\":[]", "\"keep_out\":[{\"box\":[[0,0,0],[1,1,1]],\"transform\":5}]",
         "container.keep_out[0].transform"},
        {"\"keep_out\":[]", "\"keep_out\":[{\"box\":5,\"mesh\":\"a.stl\"}]", "container.keep_out[0].box"},
        {"\"version\": 1", "\"version\": 1, \"version\": 1", "version"},
        {"\"voxel\":1.5", "\"voxel\":0", "options.voxel"},
        {"\"interlock\":\"place\"", "\"interlock\":\"maybe\"", "options.interlock"},
        {"\"seed\":18446744073709551615", "\"seed\":-1", "options.seed"},
        {"\"threads\":3", "\"threads\":3000000000", "options.threads"},
        {"\"verify-with\":\"reference:10\"", "\"verify-with\":\"reference:0\"", "options.verify-with"},
        {"\"id\":1", "\"id\":2", "parts[1].id"},
        {"\"scale\":0.5", "\"scale\":0", "parts[0].scale"},
        {"\"count\":3", "\"count\":-3", "parts[0].count"},
        {"\"count\":3", "\"count\":3.5", "parts[0].count"},
        {"\"repairs\":[\"", "\"repairs\":[7,\"", "parts[0].repairs[0]"},
        {"\"mesh\":\"../meshes/bracket.stl\"", "\"mesh\":\"\"", "parts[0].mesh"},
        {"\"mesh\":\"../meshes/bracket.stl\"", "\"mesh\":\"a\\u0000b\"", "parts[0].mesh"},
        {"{\"part\":1,", "{\"part\":2,", "trays[0].placements[1].part"},
        {"{\"part\":1,", "{\"part\":-1,", "trays[0].placements[1].part"},
        {"{\"part\":1,", "{", "trays[0].placements[1].part"},
        {"[0.0,0.0,25.4,0.0]", "[0.0,0.0,25.4]", "trays[0].placements[1].transform[2]"},
        {"[0.0,0.0,25.4,0.0]", "[0.0,0.0,\"x\",0.0]", "trays[0].placements[1].transform[2][2]"},
        {"[0.0,0.0,25.4,0.0]", "[0.0,0.0,0.0,0.0]", "trays[0].placements[1].transform"},
        {"[0.0,0.0,0.0,1.0]", "[0.0,0.0,0.0,2.0]", "parts[1].item_transform[3]"},
        {"\"orientation\":2", "\"orientation\":-2", "trays[0].placements[1].orientation"},
        {"\"fixed\":true", "\"fixed\":1", "trays[0].placements[1].fixed"},
        {"[12.5,0.0,3.0]", "[12.5,null,3.0]", "trays[0].layers.area[1]"},
        {"\"no_place\"", "\"bored\"", "unplaced[0].reason"},
        {"\"peak_memory\":123456789", "\"peak_memory\":\"much\"", "metrics.peak_memory"},
        {"\"min_gap\":0.3", "\"min_gap\":{}", "metrics.min_gap"},
        {"\"complete\": true", "\"complete\": 1", "trays[0].disassembly.complete"},
        {"\"complete\": true", "\"finished\": true", "trays[0].disassembly.complete"},
        {"\"steps\":[]", "\"steps\":{}", "trays[1].disassembly.steps"},
        {"\"placements\":[0]", "\"placements\":[]", "trays[0].disassembly.steps[0].placements"},
        {"\"placements\":[0]", "\"placements\":[2]", "trays[0].disassembly.steps[0].placements[0]"},
        {"\"placements\":[0]", "\"placements\":[-1]", "trays[0].disassembly.steps[0].placements[0]"},
        {"\"placements\":[0]", "\"placements\":[0,0]", "trays[0].disassembly.steps[0].placements"},
        {"\"placements\":[0]", "\"placements\":[1]", "trays[0].disassembly.steps[0].placements"},
        {"[-70.0,0.25,0.0]", "[-70.0,null,0.0]", "trays[0].disassembly.steps[0].path[1][1]"},
        {"[-70.0,0.25,0.0]", "[-70.0,0.25]", "trays[0].disassembly.steps[0].path[1]"},
        {"\"unpack\": \"top\"", "\"unpack\": \"up\"", "trays[0].disassembly.unpack"},
        {"\"through_walls\": [0]", "\"through_walls\": [1]", "trays[0].disassembly.through_walls[0]"},
        {"\"through_walls\": [0]", "\"through_walls\": [-1]", "trays[0].disassembly.through_walls[0]"},
        {"\"through_walls\": [0]", "\"through_walls\": [0,0]", "trays[0].disassembly.through_walls[1]"},
        {"\"interlocked\":[[0]]", "\"interlocked\":[[0,1]]", "trays[1].disassembly.interlocked[0][1]"},
        {"\"interlocked\":[[0]]", "\"interlocked\":[[0,0]]", "trays[1].disassembly.interlocked[0]"},
    };
    const std::string whole = test::read_text(golden("packing.json"));
    for (const Case& c : cases) {
        std::string text = whole;
        const std::size_t at = text.find(c.old_text);
        ASSERT_NE(at, std::string::npos) << c.old_text;
        text.replace(at, std::string_view(c.old_text).size(), c.new_text);
        const InputError error = refusal([&] { read_text_as_packing(text); });
        EXPECT_EQ(error.place(), c.place) << c.new_text << ": " << error.what();
        EXPECT_FALSE(error.cause().empty());
    }
}

/// A tray of five copies (the last one fixed) with these steps.
Packing with_steps(const std::vector<RemovalStep>& steps) {
    Packing packing = test::small_packing();
    TrayPacking& tray = packing.trays[0];
    tray.placements.assign(5, tray.placements[0]);
    tray.placements[4].fixed = true;
    tray.disassembly = Disassembly{true, steps, {{1, 3}, {2}}};
    return packing;
}

TEST(PackingFile, PlansWithGroupsComeBack) {
    const std::vector<RemovalStep> steps{{{0, 1, 2}, {{0, 0, 1e3}}}, {{3}, {}}, {{1, 2}, {{5, 0, 0}, {0, -9, 0.1}}},
                                         {{2}, {{1, 0, 0}}},         {{1}, {}}, {{0}, {}}};
    const Packing read = read_text_as_packing(packing_to_json(with_steps(steps), "."));
    const Disassembly& plan = read.trays[0].disassembly.value();
    EXPECT_TRUE(plan.complete);
    EXPECT_EQ(plan.interlocked, (std::vector<std::vector<int>>{{1, 3}, {2}}));
    ASSERT_EQ(plan.steps.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_EQ(plan.steps[i].placements, steps[i].placements);
        EXPECT_EQ(plan.steps[i].path, steps[i].path);
    }
}

TEST(PackingFile, PlansThatTakeOutWhatIsNotThereAreRefused) {
    struct Case {
        std::vector<RemovalStep> steps;
        std::vector<test::Fact> named;  ///< by the cause
    };
    const Case cases[] = {
        {{{{0}, {}}, {{0}, {}}}, {"steps[0]"}}, {{{{0}, {}}, {{0, 1}, {}}}, {"steps[0]"}},
        {{{{0, 1}, {}}, {{1, 2}, {}}}, {}},     {{{{0, 1}, {}}, {{0, 1}, {}}}, {}},
        {{{{0, 1}, {}}, {{4}, {}}}, {"fixed"}},
    };
    for (const Case& c : cases) {
        const std::string text = packing_to_json(with_steps(c.steps), ".");
        const InputError error = refusal([&] { read_text_as_packing(text); });
        EXPECT_EQ(error.place(), "trays[0].disassembly.steps[1].placements");
        EXPECT_TRUE(names(error.cause(), c.named));
    }
}

TEST(PackingFile, AllMayLeaveTogetherWhatPhysicalWallsStandRound) {
    Packing packing = with_steps({{{0, 1, 2, 3}, {{0, 0, 9}}}});
    packing.trays[0].placements.resize(4);
    for (Placement& placement : packing.trays[0].placements) {
        placement.fixed = false;
    }
    EXPECT_EQ(refusal([&] { read_text_as_packing(packing_to_json(packing, ".")); }).place(),
              "trays[0].disassembly.steps[0].placements");
    packing.container.physical = true;
    EXPECT_EQ(read_text_as_packing(packing_to_json(packing, ".")).trays[0].disassembly->steps.size(), 1u);
}

TEST(PackingFile, WhatIsNoJsonIsRefused) {
    const std::string whole = test::read_text(golden("packing.json"));
    for (std::size_t length = 0; length + 2 < whole.size(); length += 97) {
        EXPECT_TRUE(names(refusal([&] { read_text_as_packing(whole.substr(0, length)); }).cause(), {"JSON"}));
    }
    const std::string deep(1'000'000, '[');
    for (const std::string& text : {std::string("{\"version\": 1e999}"), std::string("\xff\xfe"), deep,
                                    std::string("null"), std::string("[]"), std::string("{} {}")}) {
        EXPECT_FALSE(refusal([&] { read_text_as_packing(text); }).cause().empty());
    }
    EXPECT_THROW(read_packing("/no/such/file.json"), InputError);
}

TEST(PackingFile, WhatIsAnotherKindOfFileIsCalledThat) {
    EXPECT_TRUE(names(refusal([] { read_text_as_packing("PK\x03\x04 {"); }).cause(), {"-o", ".json"}));
    EXPECT_TRUE(names(refusal([] { read_text_as_packing(R"({"format": "spectralpack/job"})"); }).cause(), {"job"}));
}

}  // namespace
}  // namespace spectralpack
