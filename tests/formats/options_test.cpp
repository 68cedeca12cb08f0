#include <nlohmann/json.hpp>

#include "files.hpp"
#include "formats/job_file.hpp"
#include "formats/packing_file.hpp"
#include "packings.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

json job_with(const json& options) {
    return {{"format", "spectralpack/job"}, {"version", 1}, {"parts", {{{"mesh", "a.stl"}}}}, {"options", options}};
}

json options_of(const PackOptions& options) {
    Packing packing = small_packing();
    packing.options = options;
    return json::parse(packing_to_json(packing, "/elsewhere"))["options"];
}

/// What an option may be set to: its examples, all its words, both values of a flag.
std::vector<OptionValue> values_worth_trying(const Option& option) {
    if (option.type == OptionType::flag) return {true, false};
    std::vector<OptionValue> values;
    for (const std::string_view text : option.examples) {
        values.push_back(parse_value(option, text));
    }
    for (const std::string_view word : option.type == OptionType::word ? option.words : decltype(option.words)()) {
        values.push_back(parse_value(option, word));
    }
    return values;
}

TEST(Options, PackingFilesAndJobFilesHoldThemAlike) {
    for (const Option& option : option_table()) {
        if (!option.in_pack.get) continue;
        for (const OptionValue& value : values_worth_trying(option)) {
            SCOPED_TRACE(std::string(option.name) + " " + text_of(option, value));
            PackOptions options;
            option.in_pack.set(options, value);
            json written = options_of(options)[std::string(option.name)];
            ASSERT_FALSE(written.is_null());
            if (option.name == "tray" && std::get<Vec3>(value).z == 0) continue;  // a packing's tray has a height
            Packing packing = small_packing();
            option.in_pack.set(packing.options, value);
            const Packing read = parse_packing("/elsewhere/p.json", packing_to_json(packing, "/elsewhere"));
            EXPECT_EQ(option.in_pack.get(read.options), value);
            const JobFile job = parse_job("/jobs/job.json", job_with({{option.name, written}}).dump());
            EXPECT_EQ(option.in_pack.get(job.settings.options), value);
        }
    }
}

/// Earlier versions wrote exactly this, and later ones read it.
TEST(Options, APackingFileHoldsTheseKeysInThisOrder) {
    const std::string text = packing_to_json(small_packing(), "/elsewhere");
    const std::string expected =
        R"("options": {"tray":[100.0,80.0,60.5],"trays":1,"try-per-tray":1000,"printer":null,"voxel":1.5,"detail":3,)"
        R"("rotations":"45","upright":true,"gap":0.25,"wall-gap":1.0,"refine":true,"interlock":"place","links":"allow",)"
        R"("take-out":"thinnest","unpack":"top","ray-spacing":0.375,"height-penalty":100000000.0,"height-at":"top","open-height":true,)"
        R"("minimise":"box","fill":true,"max-density":0.5,"max-layer-fill":0.75,"order":"random","restarts":7,"beam":4,)"
        R"("goal":"value","improve":60,"improve-steps":200,)"
        R"("engine":"reference","threads":3,"seed":18446744073709551615,"memory":1099511627776,)"
        R"("verify-with":"reference:10","time-limit":2.5})";
    EXPECT_NE(text.find(expected), std::string::npos) << text.substr(0, 2000);
    Packing packing = small_packing();
    packing.options.trays = 0;
    packing.options.height_penalty.reset();
    const json options = options_of(packing.options);
    EXPECT_EQ(options["trays"], "all");
    EXPECT_EQ(options["height-penalty"], "auto");
}

TEST(Options, AWrongValueIsRefusedByItsPath) {
    const json wrong_of_all = json::object();
    for (const Option& option : option_table()) {
        const bool held = option.in_pack.set || option.in_job.set;
        const InputError error = refusal([&] {
            parse_job("/jobs/job.json", job_with({{option.name, wrong_of_all}}).dump());
        });
        EXPECT_EQ(error.place(), "options." + std::string(option.name));
        EXPECT_EQ(error.cause().find("not a known key") == std::string::npos, held) << error.what();
    }
    const std::pair<const char*, json> out_of_range[] = {
        {"detail", 9},         {"detail", 0},      {"restarts", 0},        {"beam", 101},    {"trays", 0},
        {"gap", -1},           {"voxel", 0},       {"max-density", 1.5},   {"seed", -1},     {"memory", -1},
        {"rotations", "17"},   {"rotations", 17},  {"order", "best"},      {"unit", "yard"}, {"progress", "loud"},
        {"verify-with", "me"}, {"height-at", "x"}, {"height-penalty", -1}, {"report", ""},   {"threads", 1e10}};
    for (const auto& [name, value] : out_of_range) {
        const std::string job = job_with({{name, value}}).dump();
        const InputError error = refusal([&] { parse_job("/jobs/job.json", job); });
        EXPECT_EQ(error.place(), "options." + std::string(name)) << value;
    }
    const InputError detail = refusal([&] { parse_job("/jobs/job.json", job_with({{"detail", 9}}).dump()); });
    EXPECT_NE(detail.cause().find("from 1 to 8"), std::string::npos) << detail.cause();
}

TEST(Options, NullCountsAsMissing) {
    json options;
    for (const Option& option : option_table()) {
        if (option.in_pack.set || option.in_job.set) options[std::string(option.name)] = nullptr;
    }
    const JobFile job = parse_job("/jobs/job.json", job_with(options).dump());
    for (const Option& option : option_table()) {
        if (option.in_pack.get) {
            EXPECT_EQ(option.in_pack.get(job.settings.options), default_of(option)) << option.name;
        }
        if (option.in_job.get) {
            EXPECT_EQ(option.in_job.get(job.settings), default_of(option)) << option.name;
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
