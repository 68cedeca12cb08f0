#pragma once
/// Whether files are still what they were when a run began: it may take hours, and what is built in the end are the
/// files.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/job.hpp"

namespace spectralpack {

/// Size, and when contents and the rest were changed last.
using FileState = std::array<std::int64_t, 5>;
using FileHash = std::array<std::uint64_t, 2>;

class FileStamps {
  public:
    FileStamps() = default;

    /// Remembers size, times and a hash of every mesh file of the job that can be read. To be made before they are
    /// read, so that no change goes unnoticed.
    FileStamps(const Job& job, const Workers& workers);

    /// Names the files that changed or are gone. Reads only those whose size or times are others.
    void warn_of_changes(Listener& listener) const;

  private:
    struct Stamp {
        std::string file;
        std::optional<FileState> state = {};
        std::optional<FileHash> hash = {};  ///< none: it could not be read
    };

    std::vector<Stamp> stamps_;  ///< by name
};

}  // namespace spectralpack
