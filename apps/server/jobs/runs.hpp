#pragma once
/// Packs jobs, one after the other or a few at a time. A run is a process that outlives the server; a server that
/// begins finds those that still run, and says of the others how they ended, or that they were interrupted.

#include <boost/asio/steady_timer.hpp>
#include <string>
#include <vector>

#include "jobs/jobs.hpp"
#include "processes.hpp"

namespace spectralpack::server {

class Runs {
  public:
    Runs(boost::asio::io_context& context, Processes& processes, Jobs& jobs, const Settings& settings);

    /// Into the queue. `how` as StartJob of openapi.json; null: one that was interrupted or cancelled goes on where it
    /// was, another begins anew. Throws Refusal where it has no job file, or is packed already, or has no packing of
    /// which something could stay.
    void start(Job& job, const Json& how = nullptr);
    /// Checks and draws the packing that it has, which came from elsewhere; `plans`: one without a plan gets one
    /// before.
    void judge(Job& job, bool plans = false);
    /// This packing, a file, takes the place of the one that it has, and is judged.
    void replace(Job& job, const std::filesystem::path& packing);
    /// The packing of that revision does. Throws Refusal where there is none.
    void revert(Job& job, int revision);
    /// Ends it: what it has by then is its result. One in the queue leaves it.
    void cancel(Job& job);
    /// Ends it, whatever becomes of it.
    void kill(Job& job);
    /// From 1 on; 0: it is not in the queue.
    int queue_place(const Job& job) const;

  private:
    void find_running();
    void look_again();
    void look(Job& job);
    void start_next();
    void begin(Job& job, const std::vector<std::string>& child);
    void finish(Job& job);

    boost::asio::steady_timer timer_;
    Processes& processes_;
    Jobs& jobs_;
    const Settings& settings_;
    std::vector<std::string> queue_, running_;  ///< ids
};

}  // namespace spectralpack::server
