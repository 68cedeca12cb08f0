#pragma once
/// All jobs: made, found, changed, deleted. What is said of one is on disk before it is answered.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "jobs/job.hpp"
#include "settings.hpp"

namespace spectralpack::server {

class Jobs {
  public:
    /// Reads the folder of jobs, which is made where it is not there. Folders that are no jobs are left alone.
    explicit Jobs(const Settings& settings);

    /// Throws Refusal (404) where there is none.
    Job& at(const std::string& id);
    bool contains(const std::string& id) const { return jobs_.contains(id); }

    /// Newest first, of those whose name holds `find` (whatever the case).
    std::vector<Job*> list(const std::string& find);

    /// Throws Refusal where there are too many, or the disk is full.
    Job& create(const std::string& name);
    /// With the files and the job file of another.
    Job& copy(const Job& from, const std::string& name);
    /// Its folder goes, too. Whoever runs it has stopped it before.
    void remove(const std::string& id);
    void rename(Job& job, const std::string& name);

    /// Throws Refusal where a file of this name and so many bytes cannot be taken.
    void require_room(const Job& job, const std::string& name, std::uint64_t bytes) const;
    /// Where the next file is sent to.
    std::filesystem::path incoming(const Job& job);
    /// Moves what was sent to its place. It is to be read then.
    void take_file(Job& job, const std::string& name, const std::filesystem::path& sent);
    /// What lies in the folder of its files, however it came there, is the job's.
    void adopt_files(Job& job);
    void remove_file(Job& job, const std::string& name);
    void put_job_file(Job& job, const Json& said);

    /// Throws Refusal where neither files nor packing can be changed now.
    static void require_still(const Job& job);

  private:
    void require_disk(std::uint64_t bytes) const;

    const Settings& settings_;
    std::map<std::string, std::unique_ptr<Job>> jobs_;
    std::uint64_t sent_ = 0;
};

}  // namespace spectralpack::server
