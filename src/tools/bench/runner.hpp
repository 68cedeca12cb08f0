#pragma once
/// Runs the rows of tables, each `pack` a process of its own.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/stop.hpp"
#include "spectralpack/tools/bench.hpp"
#include "tools/bench/bench_sets.hpp"
#include "tools/bench/outcome.hpp"
#include "tools/bench/table.hpp"

namespace spectralpack::tools {

struct RanRow {
    Row row;
    std::optional<Outcome> tray, fixed;
};

class Runner {
  public:
    /// For `runs` runs in all. All that is referred to outlives the runner.
    Runner(OutcomeStore& store, BenchSets& sets, const BenchOptions& options, int runs, BenchListener& listener,
           const StopToken& stop);

    /// Runs what was not run before: what has the same command, program and inputs is taken from the store. None where
    /// it was stopped or failed; the failure is told. What a run says on standard error stays in the store's folder.
    RanRow run(const Row& row);

    /// A peer on the row's set, its container a tray. Its outcome is measured from the one mesh file it leaves.
    RanRow run(const BenchPeer& peer, const Row& row);

    int failed() const { return failed_; }  ///< runs that were neither done nor stopped

  private:
    /// `what`: of the run, for people.
    std::optional<Outcome> run(const std::string& what, const Task& task, const std::vector<std::string>& options);
    /// `tray`: for the peer; where `closed`, the density is told of it.
    std::optional<Outcome> run_peer(const std::string& what, const BenchPeer& peer, const Task& task,
                                    const std::string& tray, bool closed);
    std::optional<Outcome> found(const std::string& key);
    void begin(const std::string& what);
    void fail(const std::string& why);
    void keep(const std::string& key, const Outcome& outcome) const;
    void stamp(Outcome& outcome) const;

    OutcomeStore& store_;
    BenchSets& sets_;
    const BenchOptions& options_;
    int runs_;
    BenchListener& listener_;
    StopToken stop_;
    std::uint64_t program_;  // its bytes
    int run_ = 0;
    int failed_ = 0;
};

}  // namespace spectralpack::tools
