#pragma once
/// Other programs that the server starts, and their ends. What may crash, hang or take much memory with somebody's file
/// runs in one of these, never in the server.

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace spectralpack::server {

struct Command {
    std::vector<std::string> arguments;  ///< the program first
    std::filesystem::path folder;        ///< where it runs
    std::filesystem::path output;        ///< its standard output; empty: nowhere
    std::filesystem::path errors;        ///< its standard error; the same
    bool apart = false;                  ///< in a session of its own, so that it outlives the server
    std::uint64_t memory = 0;            ///< most address space, bytes; 0: no limit
    int processor_seconds = 0;           ///< likewise
};

/// How a process ended: by itself with a status, or by a signal.
struct Ending {
    int status = -1;  ///< -1: a signal ended it, or it did not start
    int signal = 0;
};

/// Belongs to one thread, the one that runs the context.
class Processes {
  public:
    using Ended = std::function<void(Ending)>;

    explicit Processes(boost::asio::io_context& context);

    /// Starts it; `ended` is called once, later. Its process, or -1 where it cannot be started (`ended` is called then,
    /// too).
    int start(const Command& command, Ended ended);

  private:
    void wait();
    void collect();

    boost::asio::io_context& context_;
    boost::asio::signal_set child_ends_;
    std::map<int, Ended> running_;
};

/// The process is there, and is the one that began at `began` (began_at()).
bool is_alive(int process, std::uint64_t began);

/// When a process began, in the kernel's clock; 0 where it is not there.
std::uint64_t began_at(int process);

}  // namespace spectralpack::server
