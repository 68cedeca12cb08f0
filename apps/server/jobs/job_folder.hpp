#pragma once
/// Where a job's files lie. A job is its folder: whoever copies it has copied the job.
///
// clang-format off
///     ID/meta.json           what the server knows of it
///     ID/files/NAME          what was sent; paths in job and packing files begin here
///     ID/files/.job.json     the job file
///     ID/previews/NAME.json  what a file holds; NAME.rough, .coarse, .fine: its meshes to look at
///     ID/run/                of the run: how.json (StartJob of openapi.json), events.jsonl, journal, process.json, end.json
///     ID/packing.json ...    what came of it: also check.json, picture.png, packing.3mf
///     ID/history/3.json      the packing of an earlier revision, to go back to; read from ID/, where its paths begin
///     ID/exports/            files made when they were asked for
///     ID/incoming/           what is being sent
///     ID/questions/          what children of the server are asked and answer; a run or a change does not touch it
// clang-format on

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace spectralpack::server {

/// How finely meshes to look at are kept: `rough` for thousands of copies, `fine` for a few that fill the window.
inline constexpr std::array<const char*, 3> kMeshDetails{"rough", "coarse", "fine"};

struct JobFolder {
    std::filesystem::path root;

    std::filesystem::path meta() const { return root / "meta.json"; }
    std::filesystem::path files() const { return root / "files"; }
    std::filesystem::path file(const std::string& name) const { return files() / name; }
    std::filesystem::path job_file() const { return files() / ".job.json"; }
    std::filesystem::path previews() const { return root / "previews"; }
    std::filesystem::path preview(const std::string& name) const { return previews() / (name + ".json"); }
    /// `detail`: one of kMeshDetails.
    std::filesystem::path meshes(const std::string& name, const std::string& detail) const {
        return previews() / (name + "." + detail);
    }
    /// All that was found of a file.
    std::vector<std::filesystem::path> found_of(const std::string& name) const {
        std::vector<std::filesystem::path> paths{preview(name)};
        for (const char* detail : kMeshDetails) {
            paths.push_back(meshes(name, detail));
        }
        return paths;
    }
    std::filesystem::path run() const { return root / "run"; }
    std::filesystem::path events() const { return run() / "events.jsonl"; }
    std::filesystem::path journal() const { return run() / "journal"; }
    std::filesystem::path how() const { return run() / "how.json"; }
    std::filesystem::path process() const { return run() / "process.json"; }
    std::filesystem::path end() const { return run() / "end.json"; }
    std::filesystem::path packing(const char* ending) const { return root / (std::string("packing.") + ending); }
    std::filesystem::path history() const { return root / "history"; }
    std::filesystem::path revision(int number) const { return history() / (std::to_string(number) + ".json"); }
    std::filesystem::path check() const { return root / "check.json"; }
    std::filesystem::path picture() const { return root / "picture.png"; }
    std::filesystem::path exports() const { return root / "exports"; }
    std::filesystem::path incoming() const { return root / "incoming"; }
    std::filesystem::path questions() const { return root / "questions"; }
};

}  // namespace spectralpack::server
