#include "jobs/job.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>

#include <spectralpack/printers.hpp>

#include "jobs/names.hpp"
#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 7> kWords{"new", "queued", "running", "done", "cancelled", "failed", "interrupted"};
constexpr std::size_t kMostRemarks = 50, kMostFindings = 20;
constexpr std::string_view kOfCommandLine = "the same command goes on";  // here a button says so
constexpr std::uint64_t kMostAtOnce = 8 << 20;

Json summary_of(const Json& packing) {
    const Json& metrics = packing.at("metrics");
    double height = 0;
    for (const Json& tray : packing.at("trays")) {
        height = std::max(height, tray.at("height").get<double>());
    }
    return {{"copies", metrics.at("copies")},
            {"placed", metrics.at("placed")},
            {"trays", packing.at("trays").size()},
            {"density", metrics.at("density")},
            {"height", height},
            {"min_gap", metrics.at("min_gap")},
            {"seconds", metrics.at("seconds").at("total")},
            {"improvement", metrics.value("improvement", Json())}};
}

/// Some copies are known to hold each other.
bool has_held(const Json& packing) {
    const Json& trays = packing.at("trays");
    return std::any_of(trays.begin(), trays.end(), [](const Json& tray) {
        const Json& plan = tray.at("disassembly");
        return !plan.is_null() && !plan.at("interlocked").empty();
    });
}

Json verdict_of(const Json& check, const Json& packing) {
    std::size_t steps = 0;
    bool planned = true, complete = true, fails = has_held(packing);
    for (const Json& plan : check.at("plans")) {
        planned = planned && !plan.is_null();
        if (plan.is_null()) continue;
        steps += plan.at("steps").get<std::size_t>();
        fails = fails || !plan.at("ok").get<bool>();
        complete = complete && plan.at("complete").get<bool>();
    }
    const bool shown = planned && complete && !fails && !check.at("stopped").get<bool>();
    Json findings = Json::array();
    for (const Json& finding : check.at("findings")) {
        if (findings.size() < kMostFindings) findings.push_back(finding.at("message"));
    }
    return {{"ok", check.at("ok").get<bool>() && shown},
            {"apart", fails   ? "no"
                      : shown ? "checked"
                              : "not_checked"},
            {"steps", steps},
            {"min_gap", check.at("min_gap")},
            {"findings", findings}};
}

/// Numbers of the files in history/, ascending.
std::vector<int> revisions_in(const JobFolder& folder) {
    std::vector<int> numbers;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.history(), none)) {
        const std::string name = entry.path().stem().string();
        const bool digits =
            !name.empty() && name.size() < 9 && name.find_first_not_of("0123456789") == std::string::npos;
        if (digits) numbers.push_back(std::stoi(name));
    }
    std::ranges::sort(numbers);
    return numbers;
}

/// "HP Jet Fusion 5200", "Box 300 × 220 × 180 mm".
Json tray_words(const JobFolder& folder) {
    const std::optional<Json> said = read_json(folder.job_file());
    if (!said || !said->is_object()) return nullptr;
    const Json options = said->value("options", Json::object());
    if (const auto name = options.find("printer"); name != options.end() && name->is_string()) {
        const Printer* printer = find_printer(name->get<std::string>());
        return printer ? Json(printer->title) : *name;
    }
    const Json container = said->value("container", Json::object());
    if (container.contains("mesh")) return "Filled mesh " + container["mesh"].get<std::string>();
    const Json size = container.contains("size") ? container["size"] : options.value("tray", Json());
    if (!size.is_array() || size.size() < 2) return nullptr;
    std::string words = "Box";
    for (const Json& side : size) {
        if (!side.is_number()) return nullptr;
        char text[32];
        std::snprintf(text, sizeof(text), "%.6g", side.get<double>());
        words += std::string(words == "Box" ? " " : " × ") + text;
    }
    return words + " mm";
}

}  // namespace

const char* word_of(Status status) { return kWords.at(static_cast<std::size_t>(status)); }

Status status_of(const std::string& word) {
    for (std::size_t i = 0; i < kWords.size(); ++i) {
        if (word == kWords[i]) return static_cast<Status>(i);
    }
    throw Refusal(kBroken, "a job's file says the unknown status " + word);
}

std::string now_text() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    return {text, std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

void keep(Job& job) {
    job.changed = now_text();
    ++job.change;
    Json files = Json::object();
    for (const auto& [name, file] : job.files) {
        files[name] = {{"bytes", file.bytes}, {"number", file.number}};
    }
    const Json meta{{"name", job.name},       {"created", job.created},
                    {"changed", job.changed}, {"status", word_of(job.status)},
                    {"error", job.error},     {"cancelling", job.cancelling},
                    {"run", job.run},         {"files_sent", job.files_sent},
                    {"started", job.started}, {"revision", job.revision},
                    {"own_run", job.own_run}, {"goes_on", job.goes_on},
                    {"files", files}};
    write_text(job.folder.meta(), meta.dump(1));
}

Job read_job(const fs::path& folder) {
    Job job;
    job.id = folder.filename().string();
    job.folder = {folder};
    const std::optional<Json> meta = read_json(job.folder.meta());
    if (!meta) throw Refusal(kBroken, folder.string() + " is no job: it has no meta.json that can be read");
    try {
        job.name = meta->at("name").get<std::string>();
        job.created = meta->at("created").get<std::string>();
        job.changed = meta->at("changed").get<std::string>();
        job.status = status_of(meta->at("status").get<std::string>());
        job.error = meta->at("error").get<std::string>();
        job.cancelling = meta->at("cancelling").get<bool>();
        job.run = meta->at("run").get<int>();
        job.started = meta->value("started", "");
        job.revision = meta->value("revision", 0);
        job.own_run = meta->value("own_run", false);
        job.goes_on = meta->value("goes_on", false);
        job.files_sent = meta->at("files_sent").get<std::uint32_t>();
        for (const auto& [name, file] : meta->at("files").items()) {
            if (!problem_of_name(name).empty()) continue;
            job.files[name] = {file.at("bytes").get<std::uint64_t>(), file.at("number").get<std::uint32_t>(), false};
        }
    } catch (const Json::exception& error) {
        throw Refusal(kBroken, job.folder.meta().string() + ": " + error.what());
    }
    read_tray(job);
    read_results(job);
    while (read_events(job)) {
    }
    return job;
}

void read_tray(Job& job) {
    try {
        job.tray = tray_words(job.folder);
    } catch (const Json::exception&) {
        job.tray = nullptr;  // of a type that packing will refuse, and say so
    }
}

void read_results(Job& job) {
    job.picture = fs::exists(job.folder.picture());
    job.summary = job.verdict = nullptr;
    job.revisions = revisions_in(job.folder);
    job.result_bytes = bytes_in(job.folder.root) - bytes_in(job.folder.files());
    try {
        const std::optional<Json> packing = read_json(job.folder.packing("json"));
        if (!packing) return;
        job.summary = summary_of(*packing);
        if (const auto check = read_json(job.folder.check())) job.verdict = verdict_of(*check, *packing);
    } catch (const Json::exception&) {
        // A file that somebody changed by hand: then there is no figure of it, and the check says what is wrong.
    }
}

bool read_events(Job& job) {
    std::ifstream file(job.folder.events(), std::ios::binary);
    if (!file) return false;
    file.seekg(static_cast<std::streamoff>(job.events_read));
    std::string text(kMostAtOnce, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    text.resize(text.rfind('\n') + 1);  // whole lines; npos + 1 is 0
    if (text.empty()) return false;
    job.events_read += text.size();
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        const std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        if (line.starts_with("{\"event\"")) continue;  // of which there are many
        const Json said = Json::parse(line, nullptr, false);
        if (said.is_object() && said.contains("phase")) {
            job.progress = said;
        } else if (said.is_object() && job.remarks.size() < kMostRemarks) {
            for (const char* key : {"warning", "error"}) {
                if (!said.contains(key) || !said[key].is_string()) continue;
                const std::string remark = said[key].get<std::string>();
                if (!remark.starts_with(kOfCommandLine)) job.remarks.push_back(remark);
            }
        } else if (!said.is_object() && !line.empty()) {
            job.error = line;  // the last plain line says why a run ended
        }
    }
    return true;
}

Json job_json(const Job& job, int queue_place) {
    const bool running = job.status == Status::running;
    return {{"id", job.id},
            {"name", job.name},
            {"created", job.created},
            {"changed", job.changed},
            {"started", job.started.empty() ? Json() : Json(job.started)},
            {"status", word_of(job.status)},
            {"stopping", running && job.cancelling},
            {"files", job.files.size()},
            {"bytes", job.bytes()},
            {"queue_place", queue_place > 0 ? Json(queue_place) : Json()},
            {"error", job.status == Status::failed && !job.error.empty() ? Json(job.error) : Json()},
            {"remarks", job.remarks},
            {"has_packing", job.has_packing()},
            {"has_job_file", fs::exists(job.folder.job_file())},
            {"can_improve", job.can_improve()},
            {"has_picture", job.picture},
            {"revision", job.has_packing() ? Json(job.revision) : Json()},
            {"revisions", job.revisions},
            {"tray", job.tray},
            {"progress", running ? job.progress : Json()},
            {"summary", job.summary},
            {"verdict", job.verdict}};
}

}  // namespace spectralpack::server
