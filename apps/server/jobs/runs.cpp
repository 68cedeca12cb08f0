#include "jobs/runs.hpp"

#include <signal.h>

#include <algorithm>

#include "jobs/job_file_rules.hpp"
#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRevisions = 20;
constexpr auto kLookEvery = std::chrono::milliseconds(150);
// Exit statuses of spectralpack pack (docs/format.md).
constexpr int kDone = 0, kUnusableInput = 3, kOutOfRoom = 4, kLeftOver = 5, kNothingPlaced = 6, kInterrupted = 130;

void remove_if_there(const fs::path& path) {
    std::error_code none;
    fs::remove_all(path, none);
}

/// What an earlier run made; its files are named after the packing.
void remove_results(const JobFolder& folder) {
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.root, none)) {
        if (entry.path().filename().string().starts_with("packing")) remove_if_there(entry.path());
    }
    for (const fs::path& path : {folder.check(), folder.exports()}) {
        remove_if_there(path);
    }
}

/// The packing that it has can be gone back to, while others take its place.
void keep_revision(Job& job) {
    const JobFolder& folder = job.folder;
    if (fs::exists(folder.packing("json"))) {
        fs::create_directories(folder.history());
        std::error_code error;
        fs::create_hard_link(folder.packing("json"), folder.revision(job.revision), error);
        job.revisions.push_back(job.revision);
        for (; job.revisions.size() > kMostRevisions; job.revisions.erase(job.revisions.begin())) {
            remove_if_there(folder.revision(job.revisions.front()));
        }
    }
    ++job.revision;
}

/// Its turn has come: what it has makes room for what the run makes. Until then the run can still be called off.
void make_room(Job& job) {
    const JobFolder& folder = job.folder;
    keep_revision(job);
    if (!job.goes_on) {
        const Json how = read_json(folder.how()).value_or(Json::object());
        remove_results(folder);
        remove_if_there(folder.root / "kept.json");
        if (!how.contains("improve")) remove_if_there(folder.picture());
        job.own_run = !how.contains("keep");
    }
    remove_if_there(folder.events());
    job.events_read = 0;
    job.started = now_text();
    ++job.run;
    read_results(job);
}

/// What a job's state says of a run is forgotten.
void forget_run(Job& job) {
    for (const fs::path& path : {job.folder.end(), job.folder.process()}) {
        remove_if_there(path);
    }
    job.error.clear();
    job.remarks.clear();
    job.progress = nullptr;
    job.cancelling = false;
    job.process = 0;
}

}  // namespace

Runs::Runs(boost::asio::io_context& context, Processes& processes, Jobs& jobs, const Settings& settings)
    : timer_(context), processes_(processes), jobs_(jobs), settings_(settings) {
    find_running();
    look_again();
}

void Runs::find_running() {
    std::vector<Job*> oldest_first = jobs_.list("");
    std::reverse(oldest_first.begin(), oldest_first.end());
    for (Job* job : oldest_first) {
        if (job->status == Status::queued) queue_.push_back(job->id);
        if (job->status != Status::running) continue;
        const std::optional<Json> process = read_json(job->folder.process());
        if (process && process->is_object()) {
            job->process = process->value("process", 0);
            job->began = process->value("began", std::uint64_t{0});
        }
        running_.push_back(job->id);
        look(*job);
    }
    std::erase_if(running_, [&](const std::string& id) { return jobs_.at(id).status != Status::running; });
    start_next();
}

void Runs::start(Job& job, const Json& how) {
    Jobs::require_still(job);
    const std::optional<Json> said = read_json(job.folder.job_file());
    if (!said) throw Refusal(kNotNow, "the job has no job file yet: say first what is to be packed");
    require_harmless(*said, job);
    require_plain_files(job);
    const bool keeps = how.is_object() && how.contains("keep"), improves = how.is_object() && how.contains("improve");
    if (keeps && improves) throw Refusal(kBadRequest, "keep and improve are two ways to go on: say one");
    if (keeps && !job.has_packing()) throw Refusal(kNotNow, "there is no packing yet of which copies could stay");
    if (improves && !job.can_improve()) {
        throw Refusal(kNotNow, "there is no packing that can be made better from where it is: pack it again first");
    }
    job.goes_on = !keeps && !improves && (job.status == Status::interrupted || job.status == Status::cancelled) &&
                  fs::exists(job.folder.journal());
    if (!job.goes_on) {
        remove_if_there(job.folder.how());
        if (!improves) remove_if_there(job.folder.journal());
        if (keeps || improves) write_text(job.folder.how(), how.dump());
    }
    forget_run(job);
    job.status = Status::queued;
    keep(job);
    queue_.push_back(job.id);
    start_next();
}

void Runs::replace(Job& job, const fs::path& packing) {
    keep_revision(job);
    const fs::path safe = job.folder.root / "next.json";  // it may lie among what is removed
    fs::rename(packing, safe);
    remove_results(job.folder);
    remove_if_there(job.folder.journal());
    fs::rename(safe, job.folder.packing("json"));
    job.own_run = false;
    forget_run(job);
    read_results(job);
    judge(job, true);
}

void Runs::revert(Job& job, int revision) {
    Jobs::require_still(job);
    const fs::path earlier = job.folder.revision(revision);
    if (!fs::exists(earlier)) throw Refusal(kNotThere, "there is no such revision any more");
    const fs::path copy = job.folder.root / "reverted.json";
    remove_if_there(copy);
    fs::copy_file(earlier, copy);
    replace(job, copy);
}

void Runs::cancel(Job& job) {
    if (job.status == Status::queued) {
        std::erase(queue_, job.id);
        remove_if_there(job.folder.how());
        job.status = job.has_packing() ? Status::done : Status::fresh;
        keep(job);
    } else if (job.status == Status::running) {
        job.cancelling = true;
        keep(job);
        if (job.process > 0) ::kill(-job.process, SIGINT);
    } else {
        throw Refusal(kNotNow, "the job is not being packed");
    }
}

void Runs::kill(Job& job) {
    std::erase(queue_, job.id);
    std::erase(running_, job.id);
    if (job.status == Status::running && job.process > 0) ::kill(-job.process, SIGKILL);
    job.status = Status::interrupted;
    start_next();
}

int Runs::queue_place(const Job& job) const {
    const auto place = std::find(queue_.begin(), queue_.end(), job.id);
    return place == queue_.end() ? 0 : static_cast<int>(place - queue_.begin()) + 1;
}

void Runs::judge(Job& job, bool plans) {
    begin(job, {"judge", settings_.program.string(), plans ? "plan" : "as it is"});
}

void Runs::start_next() {
    const std::string limit =
        settings_.limits.time_limit ? std::to_string(static_cast<int>(*settings_.limits.time_limit)) : "";
    while (!queue_.empty() && running_.size() < static_cast<std::size_t>(settings_.limits.parallel)) {
        const std::string id = queue_.front();
        queue_.erase(queue_.begin());
        Job& job = jobs_.at(id);
        make_room(job);
        const fs::path before = job.folder.revision(job.revision - 1);
        begin(job, {"run", settings_.program.string(), limit, fs::exists(before) ? before.string() : ""});
    }
}

void Runs::begin(Job& job, const std::vector<std::string>& child) {
    Command command{{settings_.self.string(), "--child"}, job.folder.root, {}, job.folder.run() / "errors.txt"};
    command.arguments.insert(command.arguments.end(), child.begin(), child.end());
    command.apart = true;
    job.status = Status::running;
    job.process = processes_.start(command, [this, id = job.id](Ending) {
        if (!jobs_.contains(id)) return;
        Job& ended = jobs_.at(id);
        if (ended.status == Status::running) finish(ended);
    });
    job.began = began_at(job.process);
    running_.push_back(job.id);
    keep(job);
}

void Runs::look_again() {
    timer_.expires_after(kLookEvery);
    timer_.async_wait([this](const boost::system::error_code& error) {
        if (error) return;
        for (const std::string& id : std::vector(running_)) {
            if (jobs_.contains(id)) look(jobs_.at(id));
        }
        look_again();
    });
}

/// A process of an earlier server cannot be waited for: it is looked whether it is still there.
void Runs::look(Job& job) {
    if (read_events(job)) ++job.change;
    if (!is_alive(job.process, job.began)) finish(job);
}

void Runs::finish(Job& job) {
    while (read_events(job)) {
    }
    const std::string last_words = job.error;
    read_results(job);
    const std::optional<Json> end = read_json(job.folder.end());
    const int status = end && end->is_object() ? end->value("status", -1) : -1;
    const int signal = end && end->is_object() ? end->value("signal", 0) : 0;
    if (!end) {
        job.status = Status::interrupted;
    } else if (job.cancelling || status == kInterrupted) {
        job.status = job.cancelling ? Status::cancelled : Status::interrupted;
    } else if (job.has_packing() && (status == kDone || status == kLeftOver || status == kUnusableInput)) {
        job.status = Status::done;
    } else {
        job.status = Status::failed;
        job.error = status == kNothingPlaced ? "no copy fits into the tray"
                    : signal == SIGKILL      ? "the packing ended by force: perhaps the memory was short"
                    : signal != 0            ? "the packing ended unexpectedly (signal " + std::to_string(signal) + ")"
                    : !last_words.empty()    ? last_words
                    : status == kOutOfRoom   ? "memory or disk did not suffice"
                                             : "the packing failed (status " + std::to_string(status) + ")";
        constexpr std::string_view kProgram = "spectralpack: ";
        if (job.error.starts_with(kProgram)) job.error.erase(0, kProgram.size());
    }
    job.cancelling = false;
    std::erase(running_, job.id);
    keep(job);
    start_next();
}

}  // namespace spectralpack::server
