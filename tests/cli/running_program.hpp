#pragma once
/// The built program while it runs: what it says so far, and signals to it.

#include <functional>
#include <optional>

#include "cli/program.hpp"
#include "support/eventually.hpp"

namespace spectralpack::test {

class RunningProgram {
  public:
    /// `prepare` is called in the process before the program starts in it.
    explicit RunningProgram(std::vector<std::string> arguments, const std::function<void()>& prepare = {}) {
        arguments.insert(arguments.begin(), SPECTRALPACK_PROGRAM);
        process_ = fork();
        if (process_ != 0) return;
        if (!freopen((folder_ / "out").c_str(), "w", stdout) || !freopen((folder_ / "err").c_str(), "w", stderr)) {
            _exit(126);
        }
        alarm(kHangs);
        if (prepare) prepare();
        std::vector<char*> argv;
        for (std::string& argument : arguments) {
            argv.push_back(argument.data());
        }
        argv.push_back(nullptr);
        execv(argv[0], argv.data());
        _exit(127);
    }
    ~RunningProgram() {
        if (!status_) {
            signal(SIGKILL);
            wait();
        }
    }
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    std::string out() const { return read_text(folder_ / "out"); }
    std::string err() const { return read_text(folder_ / "err"); }
    void signal(int number) const { kill(process_, number); }

    /// Waits until it has said so; false where it never does.
    bool says(const Moment& moment) {
        return eventually([&] { return moment(err()) || ended(); }) && moment(err());
    }

    /// Waits until it ends. 128 + signal when killed.
    int wait() {
        eventually([&] { return ended(); });
        return status_.value_or(-1);
    }

  private:
    static constexpr unsigned kHangs = 300;  // seconds

    bool ended() {
        int status = 0;
        if (!status_ && waitpid(process_, &status, WNOHANG) == process_) {
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        return status_.has_value();
    }

    TemporaryFolder folder_;
    pid_t process_ = 0;
    std::optional<int> status_;
};

/// A job that runs for many seconds, whose first copies stand soon.
inline std::vector<std::string> long_job(const std::filesystem::path& output) {
    return {"pack", kSamples + ":20", "--tray", "400x300x200", "--voxel",      "1", "--rotations",
            "45",   "--progress",     "json",   "-o",          output.string()};
}

/// Whether so many copies stand.
inline Moment placed(int copies) {
    return reported(
        [copies](const nlohmann::json& line) { return line.value("phase", "") == "search" && line["done"] >= copies; });
}

}  // namespace spectralpack::test
