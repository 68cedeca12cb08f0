#include "jobs/jobs.hpp"

#include <algorithm>
#include <cctype>

#include <spectralpack/error.hpp>

#include "jobs/job_file_rules.hpp"
#include "jobs/names.hpp"
#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

std::string in_small_letters(std::string text) {
    for (char& c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return text;
}

/// "640 MB"
std::string bytes_text(std::uint64_t bytes) {
    constexpr std::uint64_t kMB = 1000 * 1000, kGB = 1000 * kMB;
    return bytes >= 10 * kGB ? std::to_string(bytes / kGB) + " GB" : std::to_string(bytes / kMB) + " MB";
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw ResourceError("cannot make the folder " + folder.string() + ": " + error.message());
}

void remove_found(const Job& job, const std::string& name) {
    for (const fs::path& path : job.folder.found_of(name)) {
        std::error_code none;
        fs::remove(path, none);
    }
}

}  // namespace

Jobs::Jobs(const Settings& settings) : settings_(settings) {
    make_folder(settings.jobs);
    for (const fs::directory_entry& entry : fs::directory_iterator(settings.jobs)) {
        if (!entry.is_directory() || entry.is_symlink() || !is_job_id(entry.path().filename().string())) continue;
        try {
            auto job = std::make_unique<Job>(read_job(entry.path()));
            for (const fs::path& path : {job->folder.incoming(), job->folder.questions()}) {
                std::error_code none;
                fs::remove_all(path, none);  // what an earlier server did not take to its end
            }
            jobs_.emplace(job->id, std::move(job));
        } catch (const Refusal& refusal) {
            std::fprintf(stderr, "left out: %s\n", refusal.what());
        }
    }
}

Job& Jobs::at(const std::string& id) {
    const auto job = jobs_.find(id);
    if (job == jobs_.end()) throw Refusal(kNotThere, "there is no such job: it may have been deleted");
    return *job->second;
}

std::vector<Job*> Jobs::list(const std::string& find) {
    std::vector<Job*> found;
    const std::string wanted = in_small_letters(find);
    for (const auto& [id, job] : jobs_) {
        if (in_small_letters(job->name).find(wanted) != std::string::npos) found.push_back(job.get());
    }
    std::sort(found.begin(), found.end(), [](const Job* a, const Job* b) {
        return a->created != b->created ? a->created > b->created : a->id < b->id;
    });
    return found;
}

Job& Jobs::create(const std::string& name) {
    if (jobs_.size() >= static_cast<std::size_t>(settings_.limits.jobs)) {
        throw Refusal(kTooMany, "there are " + std::to_string(jobs_.size()) + " jobs, as many as allowed: delete some");
    }
    require_disk(0);
    auto job = std::make_unique<Job>();
    do {
        job->id = new_job_id();
    } while (jobs_.contains(job->id) || fs::exists(settings_.jobs / job->id));
    job->folder = {settings_.jobs / job->id};
    job->name = name.empty() ? "Build of " + now_text().substr(0, 10) : name;
    job->created = now_text();
    for (const fs::path& folder : {job->folder.files(), job->folder.previews(), job->folder.run()}) {
        make_folder(folder);
    }
    keep(*job);
    return *jobs_.emplace(job->id, std::move(job)).first->second;
}

Job& Jobs::copy(const Job& from, const std::string& name) {
    Job& job = create(name.empty() ? from.name + " (copy)" : name);
    job.files = from.files;
    job.files_sent = from.files_sent;
    std::error_code error;
    for (const auto& [source, target] : {std::pair{from.folder.files(), job.folder.files()},
                                         std::pair{from.folder.previews(), job.folder.previews()}}) {
        // Hard links: files that were sent are replaced, never written to.
        for (const fs::directory_entry& entry : fs::directory_iterator(source, error)) {
            if (!entry.is_regular_file() || entry.is_symlink()) continue;
            const fs::path copy = target / entry.path().filename();
            fs::create_hard_link(entry.path(), copy, error);
            if (error) fs::copy_file(entry.path(), copy);
        }
    }
    keep(job);
    read_tray(job);
    return job;
}

void Jobs::remove(const std::string& id) {
    const Job& job = at(id);
    // Out of the way at once, so that nothing is half there.
    const fs::path gone = settings_.jobs / ("." + id + ".deleted");
    std::error_code error;
    fs::rename(job.folder.root, gone, error);
    fs::remove_all(error ? job.folder.root : gone, error);
    jobs_.erase(id);
}

void Jobs::rename(Job& job, const std::string& name) {
    job.name = name;
    keep(job);
}

void Jobs::require_disk(std::uint64_t bytes) const {
    std::error_code error;
    const fs::space_info space = fs::space(settings_.jobs, error);
    if (!error && space.available < settings_.limits.spare_bytes + bytes) {
        throw Refusal(kNoRoom, "the disk is nearly full: " + bytes_text(space.available) + " are left at " +
                                   settings_.jobs.string());
    }
}

void Jobs::require_still(const Job& job) {
    if (job.status == Status::running || job.status == Status::queued) {
        throw Refusal(kNotNow, "the job is being packed: stop it first");
    }
    if (job.changing) throw Refusal(kNotNow, "the packing is being changed: ask again in a moment");
}

void Jobs::require_room(const Job& job, const std::string& name, std::uint64_t bytes) const {
    const Limits& limits = settings_.limits;
    const std::string problem = problem_of_name(name);
    if (!problem.empty()) throw Refusal(kBadRequest, problem);
    require_still(job);
    if (!job.files.contains(name) && job.files.size() >= static_cast<std::size_t>(limits.files)) {
        throw Refusal(kTooLarge, "the job has " + std::to_string(limits.files) + " files, as many as allowed");
    }
    if (bytes > limits.file_bytes) {
        throw Refusal(kTooLarge, name + " is larger than " + bytes_text(limits.file_bytes) + ", the most allowed");
    }
    if (job.bytes() + bytes > limits.job_bytes) {
        throw Refusal(kTooLarge,
                      "the job's files would be more than " + bytes_text(limits.job_bytes) + ", the most allowed");
    }
    require_disk(bytes);
}

fs::path Jobs::incoming(const Job& job) {
    make_folder(job.folder.incoming());
    return job.folder.incoming() / std::to_string(++sent_);
}

void Jobs::take_file(Job& job, const std::string& name, const fs::path& sent) {
    require_room(job, name, 0);
    const std::uint64_t bytes = fs::file_size(sent);
    remove_found(job, name);
    fs::rename(sent, job.folder.file(name));
    job.files[name] = {bytes, ++job.files_sent, true};
    keep(job);
}

void Jobs::adopt_files(Job& job) {
    for (const fs::directory_entry& entry : fs::directory_iterator(job.folder.files())) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_regular_file() || entry.is_symlink() || !problem_of_name(name).empty()) continue;
        job.files[name] = {entry.file_size(), ++job.files_sent, true};
    }
    keep(job);
    read_tray(job);
}

void Jobs::remove_file(Job& job, const std::string& name) {
    if (!job.files.contains(name)) throw Refusal(kNotThere, "the job has no file " + name);
    require_still(job);
    std::error_code none;
    fs::remove(job.folder.file(name), none);
    remove_found(job, name);
    job.files.erase(name);
    keep(job);
}

void Jobs::put_job_file(Job& job, const Json& said) {
    require_still(job);
    require_harmless(said, job);
    write_text(job.folder.job_file(), said.dump(1));
    read_tray(job);
    keep(job);
}

}  // namespace spectralpack::server
