#include "routes.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "http/page.hpp"
#include "jobs/job_file_rules.hpp"
#include "jobs/names.hpp"
#include "jobs/refusal.hpp"
#include "question.hpp"
#include "request_values.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostName = 100, kMostListed = 1000, kListed = 50;

/// What can be asked of a packing, by the ending of its name.
struct ResultKind {
    const char *ending, *type;
};
constexpr std::array<ResultKind, 5> kExports{{{"3mf", "model/3mf"},
                                              {"stl", "model/stl"},
                                              {"csv", "text/csv"},
                                              {"png", "image/png"},
                                              {"html", "text/html; charset=utf-8"}}};

std::string name_in(const Json& body) {
    std::string name = text_in(body, "name");
    if (name.size() > kMostName) throw Refusal(kBadRequest, "a job's name has at most 100 bytes");
    return name;
}

[[noreturn]] void no_such_thing() { throw Refusal(kNotThere, "there is nothing at this address"); }

/// The samples' set file as a job: mesh, count and scale a line.
Json sample_job(std::string_view set) {
    Json parts = Json::array();
    std::istringstream lines{std::string(set)};
    std::string mesh, count;
    std::getline(lines, mesh);  // the heading
    while (std::getline(lines, mesh, ',') && std::getline(lines, count, ',')) {
        parts.push_back({{"mesh", mesh}, {"count", std::stoi(count)}});
        std::getline(lines, mesh);  // the scale, 1 of all of them
    }
    return {{"format", "spectralpack/job"},
            {"version", 1},
            {"container", {{"size", {160, 120, 120}}}},
            {"gap", 1},
            {"parts", parts},
            {"options", {{"height-at", "top"}}}};
}

Response page_response(const Request& request) {
    const PageFile* file = request.path.empty() ? find_page_file("index.html") : nullptr;
    if (!file) {
        std::string path;
        for (const std::string& folder : request.path) {
            path += (path.empty() ? "" : "/") + folder;
        }
        file = find_page_file(path);
    }
    if (!file) no_such_thing();
    Response response;
    response.type = file->type;
    // Names in assets/ change with what they hold.
    const bool lasting = file->path.starts_with("assets/");
    response.headers = {{"ETag", std::string(file->etag)},
                        {"Cache-Control", lasting ? "public, max-age=31536000, immutable" : "no-cache"},
                        {"Vary", "Accept-Encoding"}};
    if (request.if_none_match == file->etag) {
        response.status = 304;
        return response;
    }
    response.body = request.takes_gzip ? file->packed : file->bytes;
    if (request.takes_gzip) response.headers.emplace_back("Content-Encoding", "gzip");
    return response;
}

}  // namespace

bool Routes::is_upload(const Request& request) const {
    return request.method == "PUT" && request.path.size() == 5 && request.path[1] == "jobs" &&
           request.path[0] == "api" && request.path[3] == "files";
}

bool Routes::is_watching(const Request& request) const {
    return request.method == "GET" && request.path.size() == 4 && request.path[0] == "api" &&
           request.path[1] == "jobs" && request.path[3] == "events";
}

bool Routes::is_open(const Request& request) const {
    if (request.path.empty() || request.path[0] != "api") return true;
    return request.path.size() == 2 && request.path[1] == "session";
}

void Routes::answer(const Request& request, const Guard& guard, const Reply& reply) {
    if (request.path.empty() || request.path[0] != "api") {
        if (request.method != "GET") throw Refusal(405, "the page can only be read");
        if (request.path.size() == 1 && request.path[0] == "openapi.json") {
            Response response;
            response.body = api_description();
            return reply(std::move(response));
        }
        return reply(page_response(request));
    }
    if (request.path.size() < 2) no_such_thing();
    const std::string& what = request.path[1];
    if (what == "jobs") return answer_jobs(request, reply);
    if (request.path.size() != 2) no_such_thing();
    if (what == "info" && request.method == "GET") return reply(json_response(info_json(settings_)));
    if (what == "session" && request.method == "POST") {
        if (guard.asks_for_token() && !guard.is_token(text_in(body_of(request), "token"))) {
            throw Refusal(kNoToken, "this is not the token that the server printed when it began");
        }
        Response response;
        response.status = 204;
        if (guard.asks_for_token()) response.headers.emplace_back("Set-Cookie", guard.cookie());
        return reply(std::move(response));
    }
    no_such_thing();
}

Job& Routes::create(const Request& request) {
    const Json body = request.body.empty() ? Json::object() : body_of(request);
    const std::string name = name_in(body), from = text_in(body, "copy_of");
    const auto sample = body.find("sample");
    if (sample != body.end() && !sample->is_boolean()) throw Refusal(kBadRequest, "sample is true or false");
    if (!from.empty()) {
        Job& job = jobs_.copy(jobs_.at(from), name);
        reader_.read(job);
        return job;
    }
    const bool with_samples = sample != body.end() && sample->get<bool>();
    Job& job = jobs_.create(name.empty() && with_samples ? "Sample" : name);
    if (!with_samples) return job;
    std::string_view set;
    for (const SampleFile& file : sample_files()) {
        if (kind_of(file.name) == FileKind::set) {
            set = file.bytes;
            continue;
        }
        const fs::path sent = jobs_.incoming(job);
        write_text(sent, std::string(file.bytes));
        jobs_.take_file(job, std::string(file.name), sent);
    }
    jobs_.put_job_file(job, sample_job(set));
    reader_.read(job);
    return job;
}

void Routes::answer_jobs(const Request& request, const Reply& reply) {
    if (request.path.size() > 2) {
        if (!is_job_id(request.path[2])) throw Refusal(kNotThere, "there is no such job");
        return answer_job(request, jobs_.at(request.path[2]), reply);
    }
    if (request.method == "POST") return reply(json_response(described(create(request)), 201));
    if (request.method != "GET") no_such_thing();
    const auto find = request.query.find("find");
    const std::vector<Job*> all = jobs_.list(find == request.query.end() ? "" : find->second);
    const std::size_t first = number_in(request, "from", 0, 1000000);
    const std::size_t most = number_in(request, "most", kListed, kMostListed);
    Json jobs = Json::array();
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bytes += all[i]->bytes();
        if (i >= first && jobs.size() < most) jobs.push_back(described(*all[i]));
    }
    reply(json_response({{"total", all.size()}, {"bytes", bytes}, {"jobs", jobs}}));
}

void Routes::answer_job(const Request& request, Job& job, const Reply& reply) {
    const std::string what = request.path.size() > 3 ? request.path[3] : "";
    const std::string& method = request.method;
    if (request.path.size() > 5 || (request.path.size() == 5 && what != "files")) no_such_thing();
    if (what.empty()) {
        if (method == "GET") return reply(json_response(described(job)));
        if (method == "PATCH") {
            const std::string name = name_in(body_of(request));
            if (name.empty()) throw Refusal(kBadRequest, "a job's name cannot be empty");
            jobs_.rename(job, name);
            return reply(json_response(described(job)));
        }
        if (method == "DELETE") {
            runs_.kill(job);
            jobs_.remove(std::string(job.id));
            return reply({204, "", "", {}, "", {}});
        }
        no_such_thing();
    }
    if (what == "files" && request.path.size() == 5) return answer_file(request, job, reply);
    if (method == "POST") {
        if (what == "start") return start(request, job, reply);
        if (what == "change") return change(request, job, reply);
        if (what == "revert") return revert(request, job, reply);
        if (what == "clearance") return clearance(request, job, reply);
        if (what == "cancel") {
            runs_.cancel(job);
            return reply(json_response(described(job), 202));
        }
        if (what == "estimate") return estimate(job, reply);
        no_such_thing();
    }
    if (what == "job.json" && method == "PUT") {
        jobs_.put_job_file(job, body_of(request));
        return reply({204, "", "", {}, "", {}});
    }
    if (method != "GET") no_such_thing();
    if (what == "parts") return reply(json_response(parts_json(job)));
    if (what == "meshes.bin") {
        const auto detail = request.query.find("detail"), ids = request.query.find("ids");
        const std::string wanted = detail == request.query.end() ? "coarse" : detail->second;
        if (std::find(kMeshDetails.begin(), kMeshDetails.end(), wanted) == kMeshDetails.end()) {
            throw Refusal(kBadRequest, "detail is rough, coarse or fine");
        }
        Response response;
        response.type = "application/octet-stream";
        response.body = mesh_bundle(job, wanted, ids == request.query.end() ? "" : ids->second);
        return reply(std::move(response));
    }
    if (what == "job.json") {
        if (!fs::exists(job.folder.job_file())) throw Refusal(kNotThere, "the job has no job file yet");
        return reply({200, "application/json", "", job.folder.job_file(), "", {}});
    }
    if (what == "clearance") return clearance(request, job, reply);
    answer_result(request, job, what, reply);
}

void Routes::answer_file(const Request& request, Job& job, const Reply& reply) {
    const std::string& name = request.path[4];
    if (request.method == "DELETE") {
        jobs_.remove_file(job, name);
        return reply({204, "", "", {}, "", {}});
    }
    if (request.method != "GET") no_such_thing();
    if (!job.files.contains(name)) throw Refusal(kNotThere, "the job has no file " + name);
    require_plain_files(job);
    reply({200, "application/octet-stream", "", job.folder.file(name), name, {}});
}

Upload Routes::begin_upload(const Request& request, std::uint64_t bytes) {
    if (!is_job_id(request.path[2])) throw Refusal(kNotThere, "there is no such job");
    const Job& job = jobs_.at(request.path[2]);
    jobs_.require_room(job, request.path[4], bytes);
    const Limits& limits = settings_.limits;
    const std::uint64_t most = std::min(limits.file_bytes, limits.job_bytes - std::min(limits.job_bytes, job.bytes()));
    return {job.id, request.path[4], jobs_.incoming(job), most};
}

Response Routes::end_upload(const Upload& upload) {
    Job& job = jobs_.at(upload.job);
    jobs_.take_file(job, upload.name, upload.to);
    reader_.read(job);
    return json_response({{"name", upload.name}, {"bytes", job.files.at(upload.name).bytes}}, 201);
}

bool Routes::has_room() const {
    std::error_code error;
    const fs::space_info space = fs::space(settings_.jobs, error);
    return error || space.available >= settings_.limits.spare_bytes;
}

void Routes::answer_result(const Request& request, Job& job, const std::string& name, const Reply& reply) {
    if (name == "picture.png") {
        if (!job.picture) throw Refusal(kNotThere, "there is no picture of this job yet");
        return reply({200, "image/png", "", job.folder.picture(), "", {}});
    }
    if (name == "check") {
        if (job.verdict.is_null()) throw Refusal(kNotThere, "the packing has not been checked yet");
        return reply({200, "application/json", "", job.folder.check(), "", {}});
    }
    constexpr std::string_view kPacking = "packing.";
    if (!name.starts_with(kPacking)) no_such_thing();
    if (!job.has_packing()) throw Refusal(kNotThere, "there is no packing of this job yet");
    const std::string ending = name.substr(kPacking.size());
    if (ending == "json") return reply({200, "application/json", "", job.folder.packing("json"), "", {}});
    exported(request, job, ending, reply);
}

void Routes::exported(const Request& request, Job& job, const std::string& ending, const Reply& reply) {
    const ResultKind* kind = nullptr;
    for (const ResultKind& one : kExports) {
        if (ending == one.ending) kind = &one;
    }
    if (!kind) no_such_thing();
    const std::size_t trays = job.summary.at("trays").get<std::size_t>(), tray = number_in(request, "tray", 0, trays);
    const std::string tail = tray > 0 ? "-" + std::to_string(tray) : "";
    Response response{200, kind->type, "", {}, job.name + tail + "." + ending, {}};
    // The report brings its own look, and nothing that runs.
    if (ending == "html") {
        response.headers.emplace_back("Content-Security-Policy",
                                      "sandbox; default-src 'none'; style-src 'unsafe-inline'; img-src data:");
    }
    if (ending == "3mf" && tray == 0 && fs::exists(job.folder.packing("3mf"))) {
        response.file = job.folder.packing("3mf");
        return reply(std::move(response));
    }
    fs::create_directories(job.folder.exports());
    response.file = job.folder.exports() / ("run" + std::to_string(job.run) + tail + "." + ending);
    if (fs::exists(response.file)) return reply(std::move(response));
    Command command = tasks_.child({"export", "packing.json", response.file.string(), std::to_string(tray), job.name},
                                   job.folder.root);
    const fs::path errors = job.folder.exports() / ("errors" + tail + "." + ending);
    command.errors = errors;
    tasks_.start(std::move(command), [response, errors, reply](Ending ended) {
        if (ended.status == 0) return reply(response);
        const std::string why = last_line(errors);
        reply(error_response(ended.status == 4 ? kNoRoom : kBroken,
                             "the file could not be made: " + (why.empty() ? "the memory was short" : why)));
    });
}

void Routes::estimate(Job& job, const Reply& reply) {
    const std::optional<Json> said = read_json(job.folder.job_file());
    if (!said) throw Refusal(kNotNow, "the job has no job file yet: say first what is to be packed");
    require_harmless(*said, job);
    const Question question(job.folder.questions(), "estimate-" + std::to_string(++asked_));
    Command command{
        {settings_.program.string(), "pack", "files/.job.json", "--dry-run", "--json", "--progress", "none"},
        job.folder.root,
        question.answer,
        question.errors};
    tasks_.start(std::move(command), [question, reply](Ending ending) {
        const std::optional<Json> estimate = read_json(question.answer);
        const std::string why = question.why();
        question.remove();
        if (estimate && estimate->is_object()) return reply(json_response(*estimate));
        reply(error_response(ending.status == 4 ? kNoRoom : kBadRequest,
                             why.empty() ? "what it will take cannot be told" : why));
    });
}

}  // namespace spectralpack::server
