#pragma once
/// The paper's tables, made anew. A row packs a set twice: into a tray that overflows, and as a fixed set whose height
/// or number of trays is to be as small as can be. Each run is a process of its own, so that it is measured from
/// outside.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/stop.hpp"

namespace spectralpack::tools {

enum class BenchScale {
    quick,  ///< toys, to see that it works
    full,   ///< the paper's sizes
};

/// A program to compare with, through its own command line.
struct BenchPeer {
    std::string name;
    /// For a shell. Filled in are {set}: the set file; {files}: every copy's mesh; {counted}: count and mesh, part by
    /// part; {tray}: like 480x245x200; {out}: the STL file to leave with all placed copies in it, which is measured.
    std::string command;
};

struct BenchOptions {
    std::filesystem::path program = {};    ///< the command line spectralpack, whose `pack` is run
    std::filesystem::path folder = {};     ///< of tables, sets and runs; made where it is not there
    std::vector<std::string> tables = {};  ///< names of bench_tables(); "all": those with a wanted row
    std::vector<std::string> rows = {};    ///< only rows with one of these texts in "set, setting"; empty: all
    BenchScale scale = BenchScale::full;
    std::optional<std::filesystem::path> sets = {};  ///< folder of set files; none: sets are generated with seed 0
    std::string mesh_dir = {};                   ///< that the paths in those files start from; empty: their own folder
    std::vector<std::string> pack_options = {};  ///< of every run, as on the command line
    std::optional<double> time_limit = {};       ///< seconds, of every run; what it has by then counts
    std::vector<BenchPeer> peers = {};           ///< for table 4
};

/// A run that begins.
struct BenchRun {
    int number = 0, runs = 0;  ///< from 1; of how many, with those that were done before
    std::string what;          ///< "mixtures, random, tray"
};

/// Where the run that goes on has come to.
struct BenchProgress {
    std::string phase;
    std::int64_t done = 0, total = 0;
    double seconds = 0;          ///< since the phase began
    std::optional<double> left;  ///< seconds, where it can tell
};

/// A run that came to its end.
struct BenchDone {
    std::string command;  ///< for people to repeat it
    double seconds = 0;
    bool cut_off = false;  ///< by the time limit
};

/// Is told what happens, by the thread that called bench().
class BenchListener {
  public:
    virtual ~BenchListener() = default;
    virtual void on_run(const BenchRun&) {}  ///< not for runs that were done before
    virtual void on_progress(const BenchProgress&) {}
    virtual void on_done(const BenchDone&) {}
    virtual void on_failure(const std::string& /*why*/) {}     ///< a run came to nothing; the others go on
    virtual void on_table(const std::string& /*markdown*/) {}  ///< all rows of a table were run, or it was stopped
};

struct BenchSummary {
    int failed = 0;  ///< runs
    StopReason stopped = StopReason::none;
};

/// "1" to "5", "order", "height", "letters", "tori", "polyhedra", "segments": the tables there are.
const std::vector<std::string>& bench_tables();

/// Runs the tables' rows one after the other and writes `folder`/table-NAME.md, .csv and, where a run took long enough
/// to see how its time grows, .svg, and benchmarks.md with all tables that are there. Each run is kept in `folder`/runs
/// as it ends, with its packing and its log: what has the same command, program and inputs is not run again. Throws
/// UsageError, before anything is written, for a table or row that does not exist; InputError where a set is missing;
/// ResourceError where the folder cannot be written or a process not be started. POSIX only.
BenchSummary bench(const BenchOptions& options, BenchListener& listener, const StopToken& stop);

}  // namespace spectralpack::tools
