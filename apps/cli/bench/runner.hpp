#pragma once
/// Runs the rows of tables, each `pack` a process of its own.

#include <optional>
#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

#include "bench_sets.hpp"
#include "outcome.hpp"
#include "run_display.hpp"
#include "table.hpp"

namespace spectralpack::cli {

/// A program to compare with, through its own command line.
struct Peer {
    std::string name;
    std::string command;  ///< for a shell; {set} {files} {counted} {tray} {out} are filled in
};

struct RunnerOptions {
    std::vector<std::string> pack;     ///< options of every run of pack
    std::optional<double> time_limit;  ///< seconds, of every run
};

struct RanRow {
    Row row;
    std::optional<Outcome> tray, fixed;
};

class Runner {
  public:
    /// `display` is told what is run, what came of it and what went wrong. All that is referred to outlives the runner.
    Runner(OutcomeStore& store, BenchSets& sets, RunnerOptions options, RunDisplay& display, const StopToken& stop);

    /// Runs what was not run before: what has the same command, program and inputs is taken from the store. None where
    /// it was stopped or failed; the failure is told. What a run says on standard error stays in the store's folder.
    RanRow run(const Row& row);

    /// A peer on the row's set, its container a tray. Its outcome is measured from the one mesh file it leaves.
    RanRow run(const Peer& peer, const Row& row);

    bool failed() const { return failed_; }  ///< some run was neither done nor stopped

  private:
    /// `what`: of the run, for people.
    std::optional<Outcome> run(const std::string& what, const Task& task, const std::vector<std::string>& options);
    /// `tray`: for the peer; where `closed`, the density is told of it.
    std::optional<Outcome> run_peer(const std::string& what, const Peer& peer, const Task& task,
                                    const std::string& tray, bool closed);
    std::optional<Outcome> found(const std::string& key);
    void keep(const std::string& key, const Outcome& outcome) const;
    void stamp(Outcome& outcome) const;

    OutcomeStore& store_;
    BenchSets& sets_;
    RunnerOptions options_;
    RunDisplay& display_;
    StopToken stop_;
    std::uint64_t program_;  // its own bytes
    bool failed_ = false;
};

}  // namespace spectralpack::cli
