#include "jobs/job_file_rules.hpp"

#include <algorithm>
#include <array>

#include <spectralpack/option_table.hpp>

#include "jobs/job.hpp"
#include "jobs/names.hpp"
#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

void require_mesh(const Json& value, const std::string& key, const Job& job) {
    if (!value.is_string()) throw Refusal(kBadRequest, key + " is the name of a file");
    const std::string name = value.get<std::string>();
    const std::string problem = problem_of_name(name);
    if (!problem.empty()) throw Refusal(kBadRequest, key + ": " + problem);
    if (!job.files.contains(name)) throw Refusal(kBadRequest, key + ": " + name + " is not among the job's files");
}

/// Meshes of a list of things that each may have one: parts, keep_out, fixed.
void require_meshes(const Json& said, const char* key, const Job& job) {
    const auto list = said.find(key);
    if (list == said.end() || !list->is_array()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& one = (*list)[i];
        if (!one.is_object() || !one.contains("mesh")) continue;
        require_mesh(one["mesh"], std::string(key) + "[" + std::to_string(i) + "].mesh", job);
    }
}

}  // namespace

bool is_allowed_here(const std::string& name) {
    const Option* option = find_option(name);
    if (!option) return true;  // which is no option: pack says so
    // The server's own: how it talks with the program, and what of the machine it gives to one job.
    constexpr std::array kOwn{"progress", "dry-run", "json",    "details", "threads",
                              "memory",   "config",  "profile", "journal", "resume"};
    if (std::find(kOwn.begin(), kOwn.end(), name) != kOwn.end()) return false;
    switch (option->type) {
        case OptionType::file:
        case OptionType::files:
        case OptionType::folder:
            return false;
        default:
            return option->in_pack.get || option->in_job.get;
    }
}

void require_harmless(const Json& said, const Job& job) {
    if (!said.is_object()) throw Refusal(kBadRequest, "a job file is a JSON object");
    for (const char* key : {"parts", "keep_out", "fixed"}) {
        require_meshes(said, key, job);
    }
    if (const auto container = said.find("container"); container != said.end() && container->is_object()) {
        if (container->contains("mesh")) require_mesh((*container)["mesh"], "container.mesh", job);
    }
    for (const char* build : {"onto", "keep"}) {
        if (said.contains(build)) throw Refusal(kBadRequest, std::string(build) + ": a build cannot be named here");
    }
    const auto options = said.find("options");
    if (options == said.end() || !options->is_object()) return;
    for (const auto& [name, value] : options->items()) {
        if (!is_allowed_here(name)) throw Refusal(kBadRequest, "options." + name + " cannot be said here");
    }
}

void require_plain_files(const Job& job) {
    for (const auto& [name, file] : job.files) {
        std::error_code error;
        const fs::file_status status = fs::symlink_status(job.folder.file(name), error);
        if (fs::is_regular_file(status)) continue;
        throw Refusal(kNotNow, name + " is no longer there as it was sent: send it again");
    }
}

}  // namespace spectralpack::server
