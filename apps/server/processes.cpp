#include "processes.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/post.hpp>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

extern char** environ;

namespace spectralpack::server {
namespace {

/// The open files and signals that a child begins with, freed at the end.
class SpawnSettings {
  public:
    explicit SpawnSettings(const Command& command) {
        posix_spawn_file_actions_init(&files_);
        posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_addchdir_np(&files_, command.folder.c_str());
        posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        open(STDOUT_FILENO, command.output);
        open(STDERR_FILENO, command.errors);
        // No connection and no port stays open because a job goes on.
        posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
        sigset_t none, defaults;
        sigemptyset(&none);
        sigemptyset(&defaults);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD}) {
            sigaddset(&defaults, signal);
        }
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &defaults);
        // A group of its own in any case: Ctrl-C in the server's terminal is the server's alone.
        posix_spawnattr_setpgroup(&attributes_, 0);
        const int own = command.apart ? POSIX_SPAWN_SETSID : POSIX_SPAWN_SETPGROUP;
        posix_spawnattr_setflags(&attributes_,
                                 static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | own));
    }
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&files_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    int spawn(std::vector<std::string> arguments) {
        std::vector<char*> pointers;
        for (std::string& argument : arguments) {
            pointers.push_back(argument.data());
        }
        pointers.push_back(nullptr);
        pid_t process = -1;
        const int error = posix_spawnp(&process, pointers.front(), &files_, &attributes_, pointers.data(), environ);
        return error == 0 ? process : -1;
    }

  private:
    void open(int descriptor, const std::filesystem::path& path) {
        const char* name = path.empty() ? "/dev/null" : path.c_str();
        posix_spawn_file_actions_addopen(&files_, descriptor, name, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0644);
    }

    posix_spawn_file_actions_t files_;
    posix_spawnattr_t attributes_;
};

void limit(int process, __rlimit_resource what, std::uint64_t most) {
    if (most == 0) return;
    const rlimit limit{most, most};
    prlimit(process, what, &limit, nullptr);
}

}  // namespace

Processes::Processes(boost::asio::io_context& context) : context_(context), child_ends_(context, SIGCHLD) { wait(); }

int Processes::start(const Command& command, Ended ended) {
    const int process = SpawnSettings(command).spawn(command.arguments);
    if (process < 0) {
        boost::asio::post(context_, [ended = std::move(ended)] { ended({}); });
        return process;
    }
    limit(process, RLIMIT_AS, command.memory);
    limit(process, RLIMIT_CPU, static_cast<std::uint64_t>(command.processor_seconds));
    running_.emplace(process, std::move(ended));
    return process;
}

void Processes::wait() {
    child_ends_.async_wait([this](const boost::system::error_code& error, int) {
        if (error) return;
        collect();
        wait();
    });
}

/// One signal may stand for several children, so each is asked.
void Processes::collect() {
    for (auto it = running_.begin(); it != running_.end();) {
        int status = 0;
        if (waitpid(it->first, &status, WNOHANG) != it->first) {
            ++it;
            continue;
        }
        Ending ending;
        if (WIFEXITED(status)) ending.status = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
        boost::asio::post(context_, [ended = std::move(it->second), ending] { ended(ending); });
        it = running_.erase(it);
    }
}

std::uint64_t began_at(int process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t name_ends = text.rfind(')');  // the name may hold anything
    if (name_ends == std::string::npos) return 0;
    std::istringstream fields(text.substr(name_ends + 1));
    std::string state, skipped;
    fields >> state;
    if (state == "Z") return 0;         // ended; only its parent has not asked yet
    constexpr int kFieldsBetween = 18;  // from the state, the third, to the beginning, the 22nd (proc(5))
    for (int i = 0; i < kFieldsBetween; ++i) {
        fields >> skipped;
    }
    std::uint64_t began = 0;
    fields >> began;
    return fields ? began : 0;
}

bool is_alive(int process, std::uint64_t began) { return began != 0 && process > 0 && began_at(process) == began; }

}  // namespace spectralpack::server
