/// A job's run: packs, checks, draws. It goes on when the server ends; a server that begins anew finds it by
/// run/process.json, and how it ended by run/end.json.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <vector>

#include "children/children.hpp"
#include "jobs/job_folder.hpp"
#include "jobs/text_files.hpp"
#include "processes.hpp"

extern char** environ;

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

constexpr int kStopped = 130;  // the exit status of a run that Ctrl-C ended

/// Runs it to its end. Ctrl-C, which this process ignores, ends it as on a terminal.
Ending run_to_end(std::vector<std::string> arguments, const fs::path& output, const fs::path& errors, int how) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | how, 0644);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGINT);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    pid_t process = -1;
    const int error = posix_spawnp(&process, pointers.front(), &files, &attributes, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) return {};
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    Ending ending;
    if (WIFEXITED(status)) ending.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
    return ending;
}

void begin_run(const JobFolder& job) {
    signal(SIGINT, SIG_IGN);
    write_text(job.process(), Json{{"process", getpid()}, {"began", began_at(getpid())}}.dump());
}

/// Every tray has a plan that takes out all copies, as far as the packing says.
bool is_planned(const Json& packing) {
    if (packing.at("options").value("interlock", "") == "off") return true;  // nobody wants one
    return std::ranges::all_of(packing.at("trays"), [](const Json& tray) {
        const Json& plan = tray.at("disassembly");
        return !plan.is_null() && plan.at("complete").get<bool>();
    });
}

/// A run that was stopped, and a packing that was changed, have no plan: whether the copies come apart is found out
/// now.
void plan(const JobFolder& job, const std::string& program) {
    const std::optional<Json> packing = read_json(job.packing("json"));
    if (!packing || is_planned(*packing)) return;
    std::ofstream(job.events(), std::ios::app)
        << R"({"phase": "disassemble", "done": 0, "total": 1, "seconds": 0, "left": null})"
        << "\n";
    run_to_end({program, "plan", "packing.json", "-o", "planned.json", "-o", "planned.3mf", "--time-limit", "120"},
               "/dev/null", job.run() / "plan.txt", O_TRUNC);
    std::error_code none;
    for (const char* ending : {"3mf", "json"}) {
        fs::rename(job.root / (std::string("planned.") + ending), job.packing(ending), none);
    }
}

void check_and_draw(const JobFolder& job, const std::string& program) {
    std::error_code none;
    if (!fs::exists(job.packing("json"), none)) return;
    std::ofstream(job.events(), std::ios::app)
        << R"({"phase": "check", "done": 0, "total": 1, "seconds": 0, "left": null})"
        << "\n";
    const fs::path unfinished = job.run() / "check.json";
    run_to_end({program, "check", "--json", "packing.json"}, unfinished, job.run() / "check.txt", O_TRUNC);
    fs::rename(unfinished, job.check(), none);
    run_to_end({program, "render", "packing.json", "--plain", "--size", "640x480", "-o", "picture.png"}, "/dev/null",
               job.run() / "picture.txt", O_TRUNC);
}

void end_run(const JobFolder& job, const Ending& packed) {
    write_text(job.end(), Json{{"status", packed.status}, {"signal", packed.signal}}.dump());
}

/// How a run goes on from the packing of an earlier one.
class Before {
  public:
    /// `file`: that packing; empty: there is none.
    Before(const JobFolder& job, const std::string& file) : job_(job), file_(file) {
        how_ = read_json(job.how()).value_or(Json::object());
        if (!file.empty()) packing_ = read_json(file).value_or(Json());
    }

    /// What it adds to the command.
    std::vector<std::string> options() const {
        if (packing_.is_null()) return {};
        if (how_.contains("keep")) {
            if (!fs::exists(kept_file())) write_text(kept_file(), kept().dump());
            return {"--keep", kept_file().filename().string()};
        }
        if (!how_.contains("improve")) return {};
        const Json& options = packing_.at("options");
        const Json improvement = packing_.at("metrics").value("improvement", Json());
        const double spent = improvement.is_null() ? 0 : improvement.at("seconds").get<double>();
        const int seconds = how_.at("improve").get<int>() + static_cast<int>(std::ceil(spent));
        // On the same grid, so that it is the same run that goes on.
        return {"--improve",   std::to_string(seconds),
                "--voxel",     options.at("voxel").dump(),
                "--rotations", options.at("rotations").get<std::string>()};
    }

    /// A run that came to nothing, or to nothing better, leaves the packing as it was.
    void restore_unless_better() const {
        if (packing_.is_null() || how_.empty()) return;
        const std::optional<Json> now = read_json(job_.packing("json"));
        if (now && (how_.contains("keep") || !is_worse(*now))) return;
        std::error_code none;
        fs::remove(job_.packing("3mf"), none);
        fs::remove(job_.packing("json"), none);
        fs::copy_file(file_, job_.packing("json"), none);
    }

  private:
    fs::path kept_file() const { return job_.root / "kept.json"; }

    Json kept() const {
        Json packing = packing_;
        const Json& keep = how_.at("keep");
        std::set<std::array<int, 3>> stay;
        for (const Json& copy : keep.is_array() ? keep : Json::array()) {
            stay.insert({copy.at("tray").get<int>(), copy.at("part").get<int>(), copy.at("copy").get<int>()});
        }
        int number = 0;
        for (Json& tray : packing.at("trays")) {
            ++number;
            tray["disassembly"] = nullptr;
            if (!keep.is_array()) continue;
            Json placements = Json::array();
            for (const Json& one : tray.at("placements")) {
                if (stay.contains({number, one.at("part").get<int>(), one.at("copy").get<int>()}))
                    placements.push_back(one);
            }
            tray["placements"] = std::move(placements);
        }
        return packing;
    }

    /// What improving `what` makes greater; the first that differs counts. Empty: a packing file does not tell.
    static std::vector<double> merits(const Json& packing, const std::string& what) {
        const Json &metrics = packing.at("metrics"), &trays = packing.at("trays");
        const auto placed = metrics.at("placed").get<double>(), density = metrics.at("density").get<double>();
        if (what == "value") return {};
        if (what == "density") return {density};
        if (what == "copies") return {placed};
        if (what == "box") return {placed, density};  // of the box
        double height = 0;
        for (const Json& tray : trays) {
            height += tray.at("height").get<double>();
        }
        if (what == "height") return {placed, -height};
        const auto number = static_cast<double>(trays.size());
        return {placed, -number, -trays.back().at("density").get<double>(), -height};
    }

    bool is_worse(const Json& now) const {
        const Json& improvement = now.at("metrics").at("improvement");
        if (improvement.is_null()) return true;  // it was stopped before the first order
        const auto what = improvement.at("what").get<std::string>();
        const std::vector<double> after = merits(now, what), before = merits(packing_, what);
        constexpr double kRounding = 1e-9;  // of sums over the same copies in another order
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (std::abs(after[i] - before[i]) > kRounding * std::abs(before[i])) return after[i] < before[i];
        }
        return false;
    }

    JobFolder job_;
    std::string file_;
    Json how_, packing_;
};

}  // namespace

int pack_job(const std::vector<std::string>& arguments) {
    const std::string &program = arguments.at(0), &time_limit = arguments.at(1);
    const JobFolder job{fs::current_path()};
    begin_run(job);
    const Before before(job, arguments.at(2));
    std::vector<std::string> pack{program,      "pack",        "files/.job.json", "-o",          "packing.json",
                                  "-o",         "packing.3mf", "--journal",       "run/journal", "--keep-journal",
                                  "--progress", "json"};
    const std::vector<std::string> goes_on = before.options();
    pack.insert(pack.end(), goes_on.begin(), goes_on.end());
    if (!time_limit.empty()) pack.insert(pack.end(), {"--time-limit", time_limit});
    const Ending packed = run_to_end(std::move(pack), job.run() / "said.txt", job.events(), O_APPEND);
    before.restore_unless_better();
    if (packed.status == kStopped || !goes_on.empty()) plan(job, program);
    check_and_draw(job, program);
    end_run(job, packed);
    return 0;
}

int judge_packing(const std::vector<std::string>& arguments) {
    const JobFolder job{fs::current_path()};
    begin_run(job);
    if (arguments.at(1) == "plan") plan(job, arguments.at(0));
    check_and_draw(job, arguments.at(0));
    end_run(job, {0, 0});
    return 0;
}

}  // namespace spectralpack::server
