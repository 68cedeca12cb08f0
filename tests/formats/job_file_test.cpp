#include "formats/job_file.hpp"

#include <nlohmann/json.hpp>

#include "files.hpp"
#include "support/data.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

/// The smallest job.
json job() {
    return {{"format", "spectralpack/job"}, {"version", 1}, {"parts", {{{"mesh", "a.stl"}}}}};
}

JobFile parsed(const json& document) { return parse_job("/jobs/week/job.json", document.dump()); }

InputError refusal_of(const json& document) {
    return refusal([&] { parsed(document); });
}

/// `document` with `value` at `pointer`.
json with(json document, const char* pointer, const json& value) {
    document[json::json_pointer(pointer)] = value;
    return document;
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
    EXPECT_EQ(file.parts[0].mesh, "/jobs/week/a.stl");
    EXPECT_EQ(file.parts[0].count, 1);
    EXPECT_EQ(file.parts[0].scale, 1);
    EXPECT_FALSE(file.parts[0].name || file.parts[0].gap);
}

TEST(JobFile, ReadsEveryKey) {
    json document = job();
    document.update({{"unit", "inch"},
                     {"container", {{"size", {100, 80.5, 60}}}},
                     {"wall_gap", 1.5},
                     {"gap", 0.75},
                     {"trays", 1},
                     {"open_height", true},
                     {"keep_out", json::array()},
                     {"fixed", json::array()}});
    document["parts"].push_back({{"name", "lid"},
                                 {"mesh", "../b.3mf"},
                                 {"count", 12},
                                 {"scale", 0.5},
                                 {"gap", 2},
                                 {"priority", 0},
                                 {"orientations", {{"axes", {"+z", "-x"}}, {"yaw", 45}}}});
    document["options"] = {{"voxel", 1},          {"detail", 3},         {"rotations", 45},      {"refine", false},
                           {"interlock", "off"},  {"order", "random"},    {"height-penalty", 4},
                           {"height-at", "top"},  {"seed", 7},            {"engine", "reference"},
                           {"threads", 3},        {"memory", 1000000000}, {"verify-with", "reference:5"},
                           {"time-limit", 2.5},   {"output", {"b.json"}}, {"report", "/r/r.html"},
                           {"progress", "none"},  {"dry-run", true},      {"skip-unusable", true},
                           {"require-all", true}, {"json", false},        {"material-density", 1.01},
                           {"minimise", "box"},   {"fill", true},         {"max-density", 0.25},
                           {"max-layer-fill", 0.5}};
    const JobFile file = parsed(document);
    const JobSettings& s = file.settings;
    EXPECT_EQ(s.unit, 25.4);
    EXPECT_EQ(s.options.tray, (Vec3{100, 80.5, 60}));
    EXPECT_EQ(s.options.wall_gap, 1.5);
    EXPECT_EQ(s.options.gap, 0.75);
    EXPECT_EQ(s.options.voxel, 1);
    EXPECT_EQ(s.options.detail, 3);
    EXPECT_EQ(s.options.rotations, "45");
    EXPECT_EQ(s.options.order, Order::random);
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
    EXPECT_EQ(s.report, "/r/r.html");
    EXPECT_EQ(s.progress, "none");
    EXPECT_EQ(s.dry_run, true);
    EXPECT_EQ(s.skip_unusable, true);
    EXPECT_EQ(s.require_all, true);
    EXPECT_EQ(s.json, false);
    EXPECT_EQ(s.material_density, 1.01);
    ASSERT_EQ(file.parts.size(), 2u);
    const JobPart& lid = file.parts[1];
    EXPECT_EQ(lid.name, "lid");
    EXPECT_EQ(lid.mesh, "/jobs/week/../b.3mf");
    EXPECT_EQ(lid.count, 12);
    EXPECT_EQ(lid.scale, 0.5);
    EXPECT_EQ(lid.gap, 2);
    EXPECT_EQ(lid.orientations.kind, PartOrientations::Kind::axes);
    EXPECT_EQ(lid.orientations.up, (std::vector<SignedAxis>{{2, true}, {0, false}}));
    EXPECT_EQ(lid.orientations.yaw, 45);
    EXPECT_EQ(file.parts[0].orientations, PartOrientations{});
    EXPECT_EQ(lid.key, "parts[1]");
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

TEST(JobFile, WhatIsNotBuiltIsAUsageErrorWithTheKeysPath) {
    const std::tuple<const char*, json, const char*> foreseen[] = {
        {"/container/mesh", "cup.stl", "container.mesh"},
        {"/container/physical", true, "container.physical"},
        {"/keep_out", json{{{"box", {{0, 0, 0}, {1, 1, 1}}}}}, "keep_out"},
        {"/fixed", json{{{"mesh", "a.stl"}}}, "fixed"},
        {"/trays", 2, "trays"},
        {"/trays", "all", "trays"},
        {"/options/trays", 3, "options.trays"},
        {"/parts/0/priority", 3, "parts[0].priority"},
        {"/parts/0/due", "2026-12-01", "parts[0].due"}};
    for (const auto& [pointer, value, path] : foreseen) {
        try {
            parsed(with(job(), pointer, value));
            ADD_FAILURE() << pointer << " was accepted";
        } catch (const UsageError& error) {
            EXPECT_TRUE(contains(error.what(), "not built yet")) << error.what();
            EXPECT_TRUE(contains(error.what(), std::string(": ") + path + ": ")) << error.what();
        }
    }
}

/// docs/job.schema.json and the reader know the same keys, and the reader takes the schema's examples.
TEST(JobFile, TheSchemaKnowsTheSameKeys) {
    const json schema = json::parse(
        read_text(std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / "docs" / "job.schema.json"));
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
                if (in_job.to_string() == "/container") one["container"].emplace("size", json{1, 2, 3});
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
