#pragma once
/// The server: one thread that waits for nothing but the network, timers and the ends of processes.

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <string>

#include "routes.hpp"

namespace spectralpack::server {

class Server {
  public:
    /// Listens, and finds the jobs that are there. Throws UsageError where the address or port cannot be had, and where
    /// another server uses the folder of jobs.
    explicit Server(const Settings& settings);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// "http://127.0.0.1:7878/"
    std::string address() const;

    /// Makes a job of a packing file; its id. Throws Refusal.
    std::string import(const std::filesystem::path& packing);

    /// Until Ctrl-C. Jobs that are being packed go on.
    void run();

  private:
    class FolderLock;

    void listen();
    void accept();

    const Settings& settings_;
    std::unique_ptr<FolderLock> lock_;
    boost::asio::io_context context_{1};
    Processes processes_;
    Jobs jobs_;
    Tasks tasks_;
    Reader reader_;
    Runs runs_;
    Routes routes_;
    boost::asio::ip::tcp::acceptor acceptor_;
    std::unique_ptr<Guard> guard_;
    int connections_ = 0;
    bool accepting_ = false, ending_ = false;
};

}  // namespace spectralpack::server
