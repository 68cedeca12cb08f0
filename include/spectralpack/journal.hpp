#pragma once
/// The journal of a run: a file that holds what was decided, so that a run that was killed goes on where it was.
///
/// Packing is deterministic, so a run that goes on ends with the placements and the plan of one that was not disturbed
/// (those under a time limit aside). docs/format.md has the file, docs/reliability.md what is promised of it.

#include <cstdint>
#include <filesystem>

namespace spectralpack {

/// What is done with a journal that is there already.
enum class Resume {
    if_it_fits,  ///< go on with it where it is of this job; else begin anew, with a warning
    must,        ///< go on with it; throw InputError naming the first difference where it is of another job, or missing
    never,       ///< begin anew
};

struct JournalOptions {
    std::filesystem::path file;  ///< empty: no journal is kept
    /// It is on disk once the run has taken so long, s. From then on each decision is within two seconds.
    double after = 0;
    Resume resume = Resume::if_it_fits;
};

/// What came of it.
struct JournalUse {
    std::filesystem::path file;
    std::int64_t recalled = 0;  ///< decisions of an earlier run that this one went on from
    bool on_disk = false;       ///< the file is there; whoever has written the packing removes it
};

}  // namespace spectralpack
