#include "server.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/post.hpp>

#include <spectralpack/error.hpp>

#include "http/beast.hpp"
#include "http/session.hpp"
#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;
using boost::asio::ip::tcp;

}  // namespace

/// Held as long as the server lives: two of them would start the same jobs.
class Server::FolderLock {
  public:
    explicit FolderLock(const fs::path& folder) {
        std::error_code error;
        fs::create_directories(folder, error);
        const fs::path path = folder / ".lock";
        file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (file_ < 0) throw UsageError("--dir " + folder.string() + ": files cannot be written there");
        if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
        close(file_);
        throw UsageError("--dir " + folder.string() + ": another spectralpack serve uses it: " +
                         read_text(path).value_or("") + "; open that, or name another folder");
    }
    ~FolderLock() { close(file_); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// What one who comes later is told.
    void say(const std::string& text) const {
        if (ftruncate(file_, 0) != 0 || pwrite(file_, text.data(), text.size(), 0) < 0) {
            std::fprintf(stderr, "spectralpack: the lock of the folder of jobs cannot be written\n");
        }
    }

  private:
    int file_ = -1;
};

Server::Server(const Settings& settings)
    : settings_(settings),
      lock_(std::make_unique<FolderLock>(settings.jobs)),
      processes_(context_),
      jobs_(settings),
      tasks_(processes_, settings),
      reader_(jobs_, tasks_),
      runs_(context_, processes_, jobs_, settings),
      routes_(settings, jobs_, reader_, runs_, tasks_),
      acceptor_(context_) {
    listen();
    guard_ = std::make_unique<Guard>(settings, acceptor_.local_endpoint().port());
    lock_->say(address());
    for (Job* job : jobs_.list("")) {
        reader_.read(*job);
    }
    accept();
}

/// The connections' own ends, which come with that of the context, are not to ask for more.
Server::~Server() { ending_ = true; }

void Server::listen() {
    ErrorCode error;
    const auto ip = boost::asio::ip::make_address(settings_.address, error);
    if (error)
        throw UsageError("--listen " + settings_.address + ": an IP address of this machine is wanted, like 0.0.0.0");
    const auto listen_on = [&](std::uint16_t port) {
        const tcp::endpoint endpoint(ip, port);
        acceptor_.open(endpoint.protocol(), error);
        if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
        if (!error) acceptor_.bind(endpoint, error);
        if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
        if (error) acceptor_.close();
        return !error;
    };
    if (listen_on(settings_.port)) return;
    const ErrorCode first = error;
    if (!settings_.port_said && listen_on(0)) return;
    throw UsageError("cannot listen on " + settings_.address + ", port " + std::to_string(settings_.port) + ": " +
                     first.message());
}

std::string Server::address() const {
    const tcp::endpoint endpoint = acceptor_.local_endpoint();
    const std::string host = endpoint.address().is_v6() ? "[" + settings_.address + "]" : settings_.address;
    return "http://" + host + ":" + std::to_string(endpoint.port()) + "/";
}

void Server::accept() {
    if (accepting_ || connections_ >= settings_.limits.connections) return;
    accepting_ = true;
    acceptor_.async_accept([this](const ErrorCode& error, tcp::socket socket) {
        accepting_ = false;
        if (!error) {
            ++connections_;
            serve(std::move(socket), routes_, *guard_, [this] {
                --connections_;
                if (ending_) return;
                // Not from within the end of a connection, which may be that of the server.
                boost::asio::post(context_, [this] { accept(); });
            });
        }
        accept();
    });
}

std::string Server::import(const fs::path& packing) {
    Job& job = jobs_.create(packing.stem().string());
    const std::string id = job.id;
    Command command = tasks_.child({"import", fs::absolute(packing).string()}, job.folder.root);
    command.errors = job.folder.run() / "import.txt";
    const fs::path errors = command.errors;
    std::optional<Ending> ended;
    tasks_.start(std::move(command), [&ended](Ending ending) { ended = ending; });
    while (!ended && context_.run_one() > 0) {
    }
    if (ended->status != 0) {
        const std::string why = read_text(errors).value_or("");
        jobs_.remove(id);
        throw Refusal(kBadRequest, why.empty() ? packing.string() + " cannot be shown" : why.substr(0, why.find('\n')));
    }
    jobs_.adopt_files(job);
    reader_.read(job);
    runs_.judge(job);
    return id;
}

void Server::run() {
    boost::asio::signal_set signals(context_, SIGINT, SIGTERM, SIGHUP);
    signals.async_wait([this](const ErrorCode& error, int) {
        if (!error) context_.stop();
    });
    context_.run();
}

}  // namespace spectralpack::server
