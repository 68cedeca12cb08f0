#pragma once
/// Finds out what the files of jobs hold, in processes of their own, several files each.

#include <string>

#include "jobs/jobs.hpp"
#include "tasks.hpp"

namespace spectralpack::server {

class Reader {
  public:
    Reader(Jobs& jobs, Tasks& tasks) : jobs_(jobs), tasks_(tasks) {}

    /// Reads what of the job's files has not been read, unless that is under way. Its files say `reading` until then.
    void read(Job& job);

  private:
    void start(const std::string& id);

    Jobs& jobs_;
    Tasks& tasks_;
    std::map<std::string, bool> busy_;  ///< by job
};

/// As openapi.json has Parts.
Json parts_json(const Job& job);

/// The bundle of openapi.json: all meshes, or those whose ids are in `ids` ("0,3"). `detail`: coarse or fine.
std::string mesh_bundle(const Job& job, const std::string& detail, const std::string& ids);

}  // namespace spectralpack::server
