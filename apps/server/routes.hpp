#pragma once
/// What each request does: the API of openapi.json, and the page.

#include <filesystem>
#include <string>

#include "http/guard.hpp"
#include "http/message.hpp"
#include "jobs/jobs.hpp"
#include "jobs/reader.hpp"
#include "jobs/runs.hpp"
#include "tasks.hpp"

namespace spectralpack::server {

/// A file that is being sent: where it goes, and how large it may become.
struct Upload {
    std::string job, name;
    std::filesystem::path to;
    std::uint64_t most_bytes = 0;
};

class Routes {
  public:
    Routes(const Settings& settings, Jobs& jobs, Reader& reader, Runs& runs, Tasks& tasks)
        : settings_(settings), jobs_(jobs), reader_(reader), runs_(runs), tasks_(tasks) {}

    /// Answers by `reply`, at once or when a process has ended. Throws Refusal.
    void answer(const Request& request, const Guard& guard, const Reply& reply);

    /// PUT /api/jobs/ID/files/NAME: its body is not held in memory. `bytes`: so many are announced; 0: it is not said.
    bool is_upload(const Request& request) const;
    Upload begin_upload(const Request& request, std::uint64_t bytes);
    Response end_upload(const Upload& upload);
    /// More of the disk than this may not be taken.
    bool has_room() const;

    /// GET /api/jobs/ID/events.
    bool is_watching(const Request& request) const;

    /// What needs no token.
    bool is_open(const Request& request) const;

    Jobs& jobs() { return jobs_; }
    Runs& runs() { return runs_; }
    const Settings& settings() const { return settings_; }

  private:
    void answer_jobs(const Request& request, const Reply& reply);
    void answer_job(const Request& request, Job& job, const Reply& reply);
    void answer_file(const Request& request, Job& job, const Reply& reply);
    void answer_result(const Request& request, Job& job, const std::string& name, const Reply& reply);
    void estimate(Job& job, const Reply& reply);
    void start(const Request& request, Job& job, const Reply& reply);
    void change(const Request& request, Job& job, const Reply& reply);
    void revert(const Request& request, Job& job, const Reply& reply);
    void clearance(const Request& request, Job& job, const Reply& reply);
    void exported(const Request& request, Job& job, const std::string& ending, const Reply& reply);
    Job& create(const Request& request);
    Json described(const Job& job) const { return job_json(job, runs_.queue_place(job)); }

    const Settings& settings_;
    Jobs& jobs_;
    Reader& reader_;
    Runs& runs_;
    Tasks& tasks_;
    std::uint64_t asked_ = 0;  ///< counts what is made anew for each who asks
};

/// As openapi.json has Info.
Json info_json(const Settings& settings);

}  // namespace spectralpack::server
