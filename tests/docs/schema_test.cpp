#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/data.hpp"
#include "support/process.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

/// Judges jobs by docs/job.schema.json with Python's jsonschema.
class JobSchema : public testing::Test {
  protected:
    void SetUp() override {
        const std::string python = SPECTRALPACK_PYTHON;
        if (python.empty() || run({python, "-c", "import jsonschema"}).status != 0) {
            GTEST_SKIP() << "Python's jsonschema is not here";
        }
    }

    /// For each job: nothing wrong was found.
    static std::vector<bool> verdicts(const std::vector<json>& jobs) {
        const TemporaryFolder folder;
        std::ofstream(folder / "jobs.json") << json(jobs);
        const std::string schema =
            (std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / "docs" / "job.schema.json").string();
        const Ran ran = run({SPECTRALPACK_PYTHON, "-c",
                             "import json, sys, jsonschema\n"
                             "schema = json.load(open(sys.argv[1]))\n"
                             "jsonschema.Draft202012Validator.check_schema(schema)\n"
                             "judge = jsonschema.Draft202012Validator(schema)\n"
                             "print(json.dumps([judge.is_valid(job) for job in json.load(open(sys.argv[2]))]))\n",
                             schema, (folder / "jobs.json").string()});
        EXPECT_EQ(ran.status, 0) << ran.err;
        return json::parse(ran.out).get<std::vector<bool>>();
    }

    static json job(const json& options = json::object()) {
        return {{"format", "spectralpack/job"},
                {"version", 1},
                {"parts", {{{"mesh", "a.stl"}, {"count", 3}}}},
                {"options", options}};
    }
};

TEST_F(JobSchema, TakesItsOwnExamples) {
    const json schema =
        json::parse(read_text(std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / "docs" / "job.schema.json"));
    std::vector<json> jobs{job()};
    for (const json& example : schema["examples"]) {
        jobs.push_back(example);
    }
    for (const auto& [name, rule] : schema["properties"]["options"]["properties"].items()) {
        EXPECT_FALSE(rule["examples"].empty()) << name;
        for (const json& example : rule["examples"]) {
            jobs.push_back(job({{name, example}}));
        }
        jobs.push_back(job({{name, nullptr}}));
        if (rule.contains("default")) jobs.push_back(job({{name, rule["default"]}}));
    }
    const std::vector<bool> fine = verdicts(jobs);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        EXPECT_TRUE(fine[i]) << jobs[i];
    }
}

TEST_F(JobSchema, RefusesWhatTheReaderRefuses) {
    const json wrong[] = {{{"gaps", 1}},           {{"gap", "1"}},        {{"gap", -1}},
                          {{"voxel", 0}},          {{"detail", 9}},       {{"detail", 1.5}},
                          {{"trays", 0}},          {{"trays", "few"}},    {{"order", "best"}},
                          {{"refine", "yes"}},     {{"max-density", 2}},  {{"restarts", 0}},
                          {{"tray", {1}}},         {{"tray", {1, 2, 0}}}, {{"verify-with", "me"}},
                          {{"height-at", "side"}}, {{"seed", -1}},        {{"output", {1}}},
                          {{"report", ""}},        {{"unit", "yard"}},    {{"height-penalty", "much"}}};
    std::vector<json> jobs;
    for (const json& options : wrong) {
        jobs.push_back(job(options));
    }
    jobs.push_back({{"format", "spectralpack/job"}, {"version", 1}});
    jobs.push_back(job());
    jobs.back()["wall_gap"] = -1;
    jobs.push_back(job());
    jobs.back()["parts"][0]["count"] = 0;
    const std::vector<bool> fine = verdicts(jobs);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        EXPECT_FALSE(fine[i]) << jobs[i];
    }
}

}  // namespace
}  // namespace spectralpack::test
