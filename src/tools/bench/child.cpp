#include "tools/bench/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "spectralpack/error.hpp"

namespace spectralpack::tools {
namespace {

constexpr int kPollMilliseconds = 50;
constexpr std::size_t kLastWords = 2000;  // bytes

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

/// In the child: its own process group, so that what the terminal interrupts is this program alone.
[[noreturn]] void become(const std::vector<std::string>& arguments, int errors) {
    setpgid(0, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
}

/// Reads lines until the other end is closed.
class Lines {
  public:
    Lines(int file, const std::function<void(const std::string&)>& line) : file_(file), line_(line) {}

    /// Waits for some; false at the end.
    bool read_some() {
        pollfd wait{file_, POLLIN, 0};
        if (poll(&wait, 1, kPollMilliseconds) <= 0) return true;
        std::array<char, 4096> bytes;
        const ssize_t count = read(file_, bytes.data(), bytes.size());
        if (count < 0) return errno == EINTR;
        if (count == 0) return false;
        text_.append(bytes.data(), static_cast<std::size_t>(count));
        for (std::size_t end; (end = text_.find('\n')) != std::string::npos; text_.erase(0, end + 1)) {
            line_(text_.substr(0, end));
        }
        return true;
    }

  private:
    int file_;
    const std::function<void(const std::string&)>& line_;
    std::string text_;
};

}  // namespace

Ended run_program(const std::vector<std::string>& arguments, const std::function<void(const std::string&)>& line,
                  const StopToken& stop) {
    int errors[2];
    if (pipe2(errors, O_CLOEXEC) != 0) throw ResourceError(std::string("cannot make a pipe: ") + std::strerror(errno));
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) become(arguments, errors[1]);
    close(errors[1]);
    if (child < 0) {
        close(errors[0]);
        throw ResourceError("cannot start " + arguments.front() + ": " + std::strerror(errno));
    }
    Ended ended;
    const std::function<void(const std::string&)> keep = [&](const std::string& text) {
        ended.last_words = (ended.last_words + text + "\n");
        if (ended.last_words.size() > kLastWords) ended.last_words.erase(0, ended.last_words.size() - kLastWords);
        line(text);
    };
    Lines lines(errors[0], keep);
    bool told = false;
    while (lines.read_some()) {
        if (stop.stopped() && !told) {
            kill(-child, SIGINT);
            told = true;
        }
    }
    close(errors[0]);
    int status = 0;
    rusage used{};
    while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
    }
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ended.cpu_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
    ended.peak_memory = static_cast<std::int64_t>(used.ru_maxrss) * 1024;
    return ended;
}

}  // namespace spectralpack::tools
