#pragma once
/// Short work in processes of its own: reading files, estimates, exports. A few at a time; the others wait.

#include <deque>
#include <utility>

#include "processes.hpp"
#include "settings.hpp"

namespace spectralpack::server {

class Tasks {
  public:
    Tasks(Processes& processes, const Settings& settings) : processes_(processes), settings_(settings) {}

    /// Starts it in its turn, within the limits of memory and time for one. `ended` is called once. Throws Refusal
    /// where too many wait.
    void start(Command command, Processes::Ended ended);

    /// This program as a child: `spectralpack-server --child NAME ...`, in `folder`.
    Command child(std::vector<std::string> arguments, const std::filesystem::path& folder) const;

  private:
    void start_next();

    Processes& processes_;
    const Settings& settings_;
    std::deque<std::pair<Command, Processes::Ended>> waiting_;
    int running_ = 0;
};

}  // namespace spectralpack::server
