#pragma once
/// Runs the real program and keeps what it says.

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace spectralpack::test {

struct Ran {
    int status = -1;  ///< exit status; 128 + signal when killed
    std::string out, err;
};

inline std::string read_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// A folder of its own for one test, removed at the end.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "spectralpack-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// What a run may take; 0: as much as it likes.
struct Limits {
    rlim_t memory = 0;       ///< bytes of address space
    rlim_t cpu_seconds = 0;  ///< of all threads together
    unsigned seconds = 0;    ///< of waiting, against hangs
};

inline void limit(int resource, rlim_t most) {
    const rlimit limits{most, most};
    if (most > 0 && setrlimit(resource, &limits) != 0) _exit(125);
}

/// Whether the moment to interrupt a run has come; it is given what the run said on standard error so far.
using Moment = std::function<bool(const std::string& err)>;

/// Runs `arguments` (the first is the program) and waits. It is sent SIGINT once, when `interrupt_when` says so.
inline Ran run(const std::vector<std::string>& arguments, const Moment& interrupt_when = {},
               const Limits& limits = {}) {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string(), err = (folder / "err").string();
    const pid_t child = fork();
    if (child == 0) {
        if (!freopen(out.c_str(), "w", stdout) || !freopen(err.c_str(), "w", stderr)) _exit(126);
        limit(RLIMIT_AS, limits.memory);
        limit(RLIMIT_CPU, limits.cpu_seconds);
        alarm(limits.seconds);
        std::vector<char*> argv;
        for (const std::string& argument : arguments) {
            argv.push_back(const_cast<char*>(argument.c_str()));
        }
        argv.push_back(nullptr);
        execv(argv[0], argv.data());
        _exit(127);
    }
    int status = 0;
    bool interrupted = !interrupt_when;
    while (waitpid(child, &status, interrupted ? 0 : WNOHANG) == 0) {
        if (interrupt_when(read_text(err))) {
            kill(child, SIGINT);
            interrupted = true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, read_text(out), read_text(err)};
}

}  // namespace spectralpack::test
