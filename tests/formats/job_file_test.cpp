#include "formats/job_file.hpp"

#include <nlohmann/json.hpp>

#include "files.hpp"
#include "spectralpack/printers.hpp"
#include "support/data.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

/// The smallest job.
json job() { return {{"format", "spectralpack/job"}, {"version", 1}, {"parts", {{{"mesh", "a.stl"}}}}}; }

JobFile parsed(const json& document) { return parse_job("/jobs/week/job.json", document.dump()); }

InputError refusal_of(const json& document) {
    return refusal([&] { parsed(document); });
}

/// `document` with `value` at `pointer`.
json with(json document, const char* pointer, const json& value) {
    document[json::json_pointer(pointer)] = value;
    return document;
}

const json kMove{{1, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 3}, {0, 0, 0, 1}};

TEST(JobFile, APrintersValuesGiveWayToThoseThatAreSaid) {
    json document = job();
    document["options"] = {{"printer", "hp-mjf-5200"}, {"gap", 0.5}};
    const JobSettings s = parsed(document).settings;
    EXPECT_TRUE(s.sized);
    EXPECT_EQ(s.options.printer, "hp-mjf-5200");
    EXPECT_EQ(s.options.tray, (Vec3{380, 284, 380}));
    EXPECT_EQ(s.options.gap, 0.5);
    EXPECT_EQ(s.options.wall_gap, find_printer("hp-mjf-5200")->wall_gap());
}

TEST(JobFile, LeavesDefaultsWhereItIsSilent) {
    const JobFile file = parsed(job());
    const PackOptions defaults;
    const PackOptions& o = file.settings.options;
    EXPECT_EQ(file.settings.file, "/jobs/week/job.json");
    EXPECT_FALSE(file.settings.unit);
    EXPECT_EQ(o.tray, defaults.tray);
    EXPECT_EQ(o.gap, defaults.gap);
    EXPECT_EQ(o.voxel, defaults.voxel);
    EXPECT_TRUE(file.settings.outputs.empty());
    ASSERT_EQ(file.parts.size(), 1u);
    EXPECT_EQ(file.parts[0].mesh.file(), "/jobs/week/a.stl");
    EXPECT_EQ(file.parts[0].count, 1);
    EXPECT_EQ(file.parts[0].scale, 1);
    EXPECT_TRUE(file.parts[0].name.empty());
    EXPECT_FALSE(file.parts[0].gap);
}

TEST(JobFile, ReadsEveryKey) {
    json document = job();
    document.update({{"unit", "inch"},
                     {"container", {{"size", {100, 80.5, 60}}}},
                     {"wall_gap", 1.5},
                     {"gap", 0.75},
                     {"trays", "all"},
                     {"open_height", true},
                     {"keep_out", {{{"box", {{1, 2, 3}, {4, 5, 6}}}}, {{"mesh", "pin.stl"}, {"unit", "m"}}}},
                     {"fixed", {{{"mesh", "bar.stl"}, {"transform", kMove}, {"gap", 3}, {"name", "bar"}}}}});
    document["container"]["physical"] = true;
    document["parts"].push_back({{"name", "lid"},
                                 {"mesh", "../b.3mf"},
                                 {"object", "4"},
                                 {"count", 12},
                                 {"scale", 0.5},
                                 {"gap", 2},
                                 {"priority", 2.5},
                                 {"due", "2026-12-01"},
                                 {"orientations", {{"axes", {"+z", "-x"}}, {"yaw", 45}}}});
    document["options"] = {{"voxel", 1},
                           {"detail", 3},
                           {"rotations", 45},
                           {"refine", false},
                           {"interlock", "off"},
                           {"links", "allow"},
                           {"take-out", "smallest"},
                           {"ray-spacing", 0.75},
                           {"order", "random"},
                           {"height-penalty", 4},
                           {"height-at", "top"},
                           {"seed", 7},
                           {"engine", "reference"},
                           {"threads", 3},
                           {"memory", 1000000000},
                           {"verify-with", "reference:5"},
                           {"try-per-tray", 30},
                           {"onto", "old.json"},
                           {"keep", "half.json"},
                           {"time-limit", 2.5},
                           {"output", {"b.json"}},
                           {"report", "/r/r.html"},
                           {"progress", "none"},
                           {"dry-run", true},
                           {"skip-unusable", true},
                           {"require-all", true},
                           {"json", false},
                           {"material-density", 1.01},
                           {"minimise", "box"},
                           {"fill", true},
                           {"max-density", 0.25},
                           {"max-layer-fill", 0.5}};
    const JobFile file = parsed(document);
    const JobSettings& s = file.settings;
    EXPECT_EQ(s.unit, LengthUnit::inch);
    EXPECT_EQ(s.options.tray, (Vec3{100, 80.5, 60}));
    EXPECT_EQ(s.options.trays, 0);
    EXPECT_EQ(s.options.try_per_tray, 30);
    EXPECT_TRUE(s.sized);
    EXPECT_EQ(s.onto, "/jobs/week/old.json");
    EXPECT_EQ(s.keep, "/jobs/week/half.json");
    EXPECT_TRUE(s.container.physical);
    ASSERT_EQ(s.container.keep_out.size(), 2u);
    EXPECT_EQ(s.container.keep_out[0].box, (Box{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(s.container.keep_out[1].mesh->file, "/jobs/week/pin.stl");
    EXPECT_EQ(s.container.keep_out[1].mesh->unit, 1000);
    ASSERT_EQ(s.fixed.size(), 1u);
    EXPECT_EQ(s.fixed[0].mesh.file, "/jobs/week/bar.stl");
    EXPECT_EQ(s.fixed[0].mesh.transform, (Transform{Mat3{}, {1, 2, 3}}));
    EXPECT_EQ(s.fixed[0].gap, 3);
    EXPECT_EQ(s.options.wall_gap, 1.5);
    EXPECT_EQ(s.options.gap, 0.75);
    EXPECT_EQ(s.options.voxel, 1);
    EXPECT_EQ(s.options.detail, 3);
    EXPECT_EQ(s.options.rotations, "45");
    EXPECT_EQ(s.options.order, Order::random);
    EXPECT_EQ(s.options.links, Links::allow);
    EXPECT_EQ(s.options.take_out, TakeOut::smallest);
    EXPECT_EQ(s.options.ray_spacing, 0.75);
    EXPECT_EQ(s.options.height_penalty, 4);
    EXPECT_EQ(s.options.height_at, HeightReference::top);
    EXPECT_EQ(s.options.seed, 7u);
    EXPECT_TRUE(s.options.open_height);
    EXPECT_EQ(s.options.minimise, Minimise::box);
    EXPECT_TRUE(s.options.fill);
    EXPECT_EQ(s.options.max_density, 0.25);
    EXPECT_EQ(s.options.max_layer_fill, 0.5);
    EXPECT_EQ(s.options.engine, EngineKind::reference);
    EXPECT_EQ(s.options.threads, 3);
    EXPECT_EQ(s.options.memory, 1'000'000'000);
    EXPECT_EQ(s.options.verify_with, (VerifyWith{EngineKind::reference, 5}));
    EXPECT_EQ(s.options.time_limit, 2.5);
    EXPECT_EQ(s.outputs, std::vector<std::string>{"/jobs/week/b.json"});
    EXPECT_EQ(s.reports, (std::vector<std::string>{"/r/r.html"}));
    EXPECT_EQ(s.progress, ProgressStyle::none);
    EXPECT_EQ(s.dry_run, true);
    EXPECT_EQ(s.skip_unusable, true);
    EXPECT_EQ(s.require_all, true);
    EXPECT_EQ(s.json, false);
    EXPECT_EQ(s.material_density, 1.01);
    ASSERT_EQ(file.parts.size(), 2u);
    const Part& lid = file.parts[1];
    EXPECT_EQ(lid.name, "lid");
    EXPECT_EQ(lid.mesh.file(), "/jobs/week/../b.3mf");
    EXPECT_EQ(lid.object, "4");
    EXPECT_EQ(lid.count, 12);
    EXPECT_EQ(lid.scale, 0.5);
    EXPECT_EQ(lid.gap, 2);
    EXPECT_EQ(lid.priority, 2.5);
    EXPECT_EQ(lid.due, "2026-12-01");
    EXPECT_EQ(lid.orientations.kind, PartOrientations::Kind::axes);
    EXPECT_EQ(lid.orientations.up, (std::vector<SignedAxis>{{2, true}, {0, false}}));
    EXPECT_EQ(lid.orientations.yaw, 45);
    EXPECT_EQ(file.parts[0].orientations, PartOrientations{});
    EXPECT_EQ(lid.origin, "parts[1]");
}

TEST(JobFile, NamesThePathOfWhatIsWrong) {
    const std::tuple<const char*, json, const char*> faults[] = {
        {"/format", "spectralpack/packing", "format"},
        {"/version", 2, "version"},
        {"/parts", "a.stl", "parts"},
        {"/parts/0/mesh", 7, "parts[0].mesh"},
        {"/parts/0/mesh", "", "parts[0].mesh"},
        {"/parts/0/count", 0, "parts[0].count"},
        {"/parts/0/count", 1.5, "parts[0].count"},
        {"/parts/0/count", "12", "parts[0].count"},
        {"/parts/0/count", 4294967297, "parts[0].count"},
        {"/parts/0/scale", -1, "parts[0].scale"},
        {"/parts/0/gap", -0.5, "parts[0].gap"},
        {"/parts/0/name", json::array(), "parts[0].name"},
        {"/parts/0/orientations", "sideways", "parts[0].orientations"},
        {"/parts/0/orientations", 90, "parts[0].orientations"},
        {"/parts/0/orientations", json{{"yaw", 90}}, "parts[0].orientations"},
        {"/parts/0/orientations", json{{"axes", json::array()}}, "parts[0].orientations.axes"},
        {"/parts/0/orientations", json{{"axes", {"+z", "up"}}}, "parts[0].orientations.axes[1]"},
        {"/parts/0/orientations", json{{"axes", {"+z"}}, {"yaw", 50}}, "parts[0].orientations.yaw"},
        {"/parts/0/orientations", json{{"axes", {"+z"}}, {"roll", 90}}, "parts[0].orientations.roll"},
        {"/parts/0/orientations", json{{"matrices", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}}}}},
         "parts[0].orientations.matrices[1]"},
        {"/parts/0/orientations", json{{"matrices", {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}}},
         "parts[0].orientations.matrices[0]"},
        {"/parts/0/orientations", json{{"matrices", {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}}},
         "parts[0].orientations.matrices[0]"},
        {"/parts/0/colour", "red", "parts[0].colour"},
        {"/part", json::array(), "part"},
        {"/unit", "cubit", "unit"},
        {"/container/size", json{1}, "container.size"},
        {"/options/minimise", "height", "options.minimise"},
        {"/options/fill", 1, "options.fill"},
        {"/options/max-density", 0, "options.max-density"},
        {"/options/max-layer-fill", 40, "options.max-layer-fill"},
        {"/container/size", json{1, 2, 0}, "container.size[2]"},
        {"/container/colour", 1, "container.colour"},
        {"/container", json::object(), "container.size"},
        {"/container", json{{"mesh", "cup.stl"}, {"size", {1, 2, 3}}}, "container.size"},
        {"/container", json{{"size", {1, 2, 3}}, {"transform", kMove}}, "container.transform"},
        {"/container", json{{"mesh", "cup.stl"}, {"transform", {1, 2}}}, "container.transform"},
        {"/keep_out", json{{{"box", {{0, 0, 0}, {1, 0, 1}}}}}, "keep_out[0].box"},
        {"/keep_out", json::array({json::object()}), "keep_out[0].mesh"},
        {"/keep_out", json{{{"box", {{0, 0, 0}, {1, 1, 1}}}, {"mesh", "a.stl"}}}, "keep_out[0].box"},
        {"/fixed", json{{{"transform", kMove}}}, "fixed[0].mesh"},
        {"/fixed", json{{{"mesh", "a.stl"}, {"at", 1}}}, "fixed[0].at"},
        {"/parts/0/priority", "high", "parts[0].priority"},
        {"/parts/0/due", "tomorrow", "parts[0].due"},
        {"/parts/0/due", "2026-02-30", "parts[0].due"},
        {"/options/printer", "typewriter", "options.printer"},
        {"/options/try-per-tray", -1, "options.try-per-tray"},
        {"/options/trays", "1.5", "options.trays"},
        {"/gap", "wide", "gap"},
        {"/open_height", 1, "open_height"},
        {"/trays", "some", "trays"},
        {"/trays", 0, "trays"},
        {"/options/voxel", "2", "options.voxel"},
        {"/options/voxel", 0, "options.voxel"},
        {"/options/gaps", 2, "options.gaps"},
        {"/options/tray", json{1, 2, -3}, "options.tray[2]"},
        {"/options/order", "best", "options.order"},
        {"/options/json", "yes", "options.json"},
        {"/options/output", json{"a.json", 3}, "options.output[1]"},
        {"/options", json::array(), "options"}};
    for (const auto& [pointer, value, place] : faults) {
        SCOPED_TRACE(std::string(pointer) + " = " + value.dump());
        const InputError error = refusal_of(with(job(), pointer, value));
        EXPECT_EQ(error.file(), "/jobs/week/job.json");
        EXPECT_EQ(error.place(), place);
        EXPECT_FALSE(error.cause().empty());
    }
}

TEST(JobFile, AMissingKeyIsNamed) {
    for (const char* key : {"format", "version", "parts"}) {
        json document = job();
        document.erase(key);
        EXPECT_EQ(refusal_of(document).place(), key);
    }
    json document = job();
    document["parts"][0].erase("mesh");
    EXPECT_EQ(refusal_of(document).place(), "parts[0].mesh");
    EXPECT_TRUE(contains(refusal([] { parse_job("j.json", "{\"format\": "); }).cause(), "not valid JSON"));
    document = job();
    document["format"] = "spectralpack/packing";
    EXPECT_TRUE(contains(refusal_of(document).cause(), "--onto"));
}

TEST(JobFile, WhatIsSaidTwiceIsRefused) {
    const std::tuple<const char*, json, const char*, json, const char*> twice[] = {
        {"/gap", 1, "/options/gap", 2, "gap"},
        {"/open_height", true, "/options/open-height", false, "open_height"},
        {"/wall_gap", 1, "/options/wall-gap", 2, "wall_gap"},
        {"/container/size", json{9, 9, 9}, "/options/tray", json{8, 8, 8}, "container.size"},
        {"/unit", "mm", "/options/unit", "m", "options.unit"}};
    for (const auto& [one, first, two, second, place] : twice) {
        const InputError error = refusal_of(with(with(job(), one, first), two, second));
        EXPECT_EQ(error.place(), place);
        EXPECT_TRUE(contains(error.cause(), "twice")) << error.cause();
    }
}

TEST(JobFile, AKeySaidTwiceIsRefusedWhereverItStands) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"format": "spectralpack/job", "version": 1, "parts": [], "version": 1})", "version"},
        {R"({"parts": [{"mesh": "a.stl"}, {"mesh": "b.stl", "count": 1, "count": 2}]})", "parts[1].count"},
        {R"({"keep_out": [{"box": [[0, 0, 0], [1, 1, 1]]}, [], {"mesh": 1, "mesh": 1}]})", "keep_out[2].mesh"},
        {R"({"options": {"gap": 1, "voxel": 2, "gap": 1}})", "options.gap"}};
    for (const auto& one : cases) {
        const InputError error = refusal([&] { parse_job("j.json", one.first); });
        EXPECT_EQ(error.place(), one.second);
        EXPECT_TRUE(contains(error.cause(), "twice")) << error.cause();
    }
}

/// docs/job.schema.json and the reader know the same keys, and the reader takes the schema's examples.
TEST(JobFile, TheSchemaKnowsTheSameKeys) {
    const json schema =
        json::parse(read_text(std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / "docs" / "job.schema.json"));
    const std::tuple<json::json_pointer, json::json_pointer> places[] = {
        {json::json_pointer("/properties"), json::json_pointer("")},
        {json::json_pointer("/properties/container/properties"), json::json_pointer("/container")},
        {json::json_pointer("/properties/parts/items/properties"), json::json_pointer("/parts/0")},
        {json::json_pointer("/properties/options/properties"), json::json_pointer("/options")}};
    for (const auto& [in_schema, in_job] : places) {
        EXPECT_FALSE(schema.at(in_schema.parent_pointer()).at("additionalProperties").get<bool>());
        for (const auto& [key, rule] : schema.at(in_schema).items()) {
            if (key == "format" || key == "version" || rule.contains("properties") || key == "parts") continue;
            ASSERT_TRUE(rule.contains("examples")) << key;
            for (const json& example : rule["examples"]) {
                json one = with(job(), (in_job / key).to_string().c_str(), example);
                const bool of_mesh = key == "mesh" || key == "transform" || key == "unit" || key == "is";
                if (in_job.to_string() == "/container" && of_mesh) {
                    one["container"].emplace("mesh", "cup.stl");
                } else if (in_job.to_string() == "/container") {
                    one["container"].emplace("size", json{1, 2, 3});
                }
                EXPECT_NO_THROW(parsed(one)) << key << ": " << example;
            }
        }
    }
    for (const json& example : schema.at("examples")) {
        EXPECT_NO_THROW(parsed(example));
    }
}

}  // namespace
}  // namespace spectralpack::test
