#pragma once
/// How the server runs, and what it lets others do.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace spectralpack::server {

/// What one user of the server may take of the machine. Bytes, seconds.
struct Limits {
    std::uint64_t file_bytes = std::uint64_t{4} << 30;
    std::uint64_t job_bytes = std::uint64_t{16} << 30;   ///< all files of a job
    std::uint64_t spare_bytes = std::uint64_t{1} << 30;  ///< of the disk: no file is taken where less would be left
    int files = 5000;                                    ///< of a job
    int jobs = 10000;
    int parallel = 1;                       ///< jobs that pack at once; others wait
    int tasks = 2;                          ///< files read, estimates and exports made at once, beside them
    int connections = 1000;                 ///< further ones wait to be accepted
    std::optional<double> time_limit = {};  ///< for one job; none: as long as it takes
#ifdef SPECTRALPACK_SANITIZED
    std::uint64_t task_memory = 0;
#else
    std::uint64_t task_memory = std::uint64_t{8}
                                << 30;  ///< of one process that reads a file or makes an export; 0: any
#endif
    int task_seconds = 600;  ///< of processor time, likewise
    int idle_seconds = 30;   ///< a client that neither sends nor takes anything for so long is let go
};

struct Settings {
    std::filesystem::path jobs;     ///< the folder of all jobs
    std::filesystem::path program;  ///< spectralpack
    std::filesystem::path self;     ///< this program, for its children
    std::string address = "127.0.0.1";
    std::uint16_t port = 7878;
    bool port_said = false;  ///< else another is taken where this one is not free
    std::string token;       ///< empty: none is asked for
    bool browser = true;
    Limits limits;
};

}  // namespace spectralpack::server
