#pragma once
/// A job as the server knows it. What lasts is in its folder; this is made from it when the server begins.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "jobs/job_folder.hpp"
#include "jobs/text_files.hpp"

namespace spectralpack::server {

enum class Status { fresh, queued, running, done, cancelled, failed, interrupted };

/// "new" for fresh, else as it is written.
const char* word_of(Status status);
Status status_of(const std::string& word);

/// A file that was sent.
struct JobFile {
    std::uint64_t bytes = 0;
    std::uint32_t number = 0;  ///< its meshes' ids are 1000 times this, and on
    bool reading = false;      ///< what it holds is not known yet
};

struct Job {
    std::string id;
    JobFolder folder;
    std::string name;
    std::string created, changed;  ///< 2026-11-29T22:52:15Z
    std::string started;           ///< its last run; empty: none began
    Status status = Status::fresh;
    std::string error;  ///< of a job that failed
    std::map<std::string, JobFile> files;
    std::uint32_t files_sent = 0;    ///< counts up: the next file's number
    std::uint64_t result_bytes = 0;  ///< of what the run made
    bool cancelling = false;
    bool changing = false;            ///< a change of its packing is being made
    bool goes_on = false;             ///< its run takes up an earlier one where that was
    int process = 0;                  ///< of the run
    std::uint64_t began = 0;          ///< the same, to know it by
    Json progress, summary, verdict;  ///< null: there is none
    Json tray;                        ///< in words, of the job file; null: it does not say
    bool picture = false;             ///< there is one
    std::vector<std::string> remarks;
    std::uint64_t events_read = 0;  ///< bytes of events.jsonl that progress and remarks are from
    int run = 0;                    ///< counts runs: events before belong to an earlier one
    int change = 0;                 ///< counts what watchers should know
    int revision = 0;               ///< of its packing: counts those that it had
    std::vector<int> revisions;     ///< of which there are files, ascending
    bool own_run = false;           ///< the packing is what a run made of the job file, and nobody changed it since

    std::uint64_t bytes() const {
        std::uint64_t sum = result_bytes;
        for (const auto& [file_name, file] : files) {
            sum += file.bytes;
        }
        return sum;
    }
    bool has_packing() const { return !summary.is_null(); }
    /// By going on from where the run ended.
    bool can_improve() const {
        return has_packing() && own_run && (status == Status::done || status == Status::cancelled);
    }
};

/// Now, in UTC: 2026-11-29T22:52:15Z.
std::string now_text();

/// Writes meta.json.
void keep(Job& job);

/// From its folder. Throws Refusal where meta.json is none of ours.
Job read_job(const std::filesystem::path& folder);

/// Reads of the job file what is told of it.
void read_tray(Job& job);

/// Reads what the run left: summary, verdict, sizes. Null where there is nothing.
void read_results(Job& job);

/// Reads the lines that the run has written since: progress and remarks. False where there were none.
bool read_events(Job& job);

/// As openapi.json has a Job; `queue_place` 0: it is in no queue.
Json job_json(const Job& job, int queue_place);

}  // namespace spectralpack::server
