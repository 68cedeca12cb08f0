/// The routes by which people change a packing that is done: what stays, what moves, what goes.

#include "jobs/refusal.hpp"
#include "question.hpp"
#include "request_values.hpp"
#include "routes.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostChanges = 10000, kMostKept = 100000;
constexpr int kMostTrays = 100000, kMostCopies = 100000000, kMostSeconds = 86400, kMostRevision = 1000000000;

/// As StartJob of openapi.json; null where nothing is said.
Json how_in(const Request& request) {
    if (request.body.empty()) return nullptr;
    Json how = body_of(request);
    if (!how.is_object()) throw Refusal(kBadRequest, "a JSON object is wanted");
    for (const auto& [key, value] : how.items()) {
        if (key == "improve") {
            integer_in(how, "improve", 1, kMostSeconds);
        } else if (key == "keep") {
            if (value == "all") continue;
            if (!value.is_array() || value.empty() || value.size() > kMostKept) {
                throw Refusal(kBadRequest, "keep is \"all\", or a list of copies");
            }
            for (const Json& copy : value) {
                require_copy_name(copy);
            }
        } else {
            throw Refusal(kBadRequest, "a run can be told keep or improve, not " + key);
        }
    }
    return how.empty() ? Json() : how;
}

/// Why a child gave no answer.
Response failure(const Ending& ending, const std::string& why) {
    constexpr int kUsage = 2, kRoom = 4;
    return error_response(ending.status == kUsage  ? kBadRequest
                          : ending.status == kRoom ? kNoRoom
                                                   : kBroken,
                          why.empty() ? "the memory was short" : why);
}

}  // namespace

void Routes::start(const Request& request, Job& job, const Reply& reply) {
    runs_.start(job, how_in(request));
    reply(json_response(described(job), 202));
}

void Routes::revert(const Request& request, Job& job, const Reply& reply) {
    runs_.revert(job, integer_in(body_of(request), "revision", 0, kMostRevision));
    reply(json_response(described(job), 202));
}

void Routes::change(const Request& request, Job& job, const Reply& reply) {
    Json body = body_of(request);
    if (!body.is_object() || !body.contains("changes")) throw Refusal(kBadRequest, "changes are wanted");
    require_changes(body["changes"], kMostChanges);
    if (body["changes"].empty()) throw Refusal(kBadRequest, "changes: one at least is wanted");
    Jobs::require_still(job);
    if (!job.has_packing()) throw Refusal(kNotThere, "there is no packing of this job yet");
    const Question question(job.folder.questions(), "change-" + std::to_string(++asked_), body);
    Command command = tasks_.child({"change", question.asked.string(), question.answer.string()}, job.folder.root);
    command.errors = question.errors;
    job.changing = true;
    try {
        tasks_.start(std::move(command), [this, question, id = job.id, reply](Ending ending) {
            const std::string why = question.why();
            if (!jobs_.contains(id)) return reply(error_response(kNotThere, "the job was deleted meanwhile"));
            Job& changed = jobs_.at(id);
            changed.changing = false;
            const bool made = ending.status == 0 && fs::exists(question.answer);
            if (made) runs_.replace(changed, question.answer);
            question.remove();
            reply(made ? json_response(described(changed), 202) : failure(ending, why));
        });
    } catch (const Refusal&) {
        job.changing = false;
        question.remove();
        throw;
    }
}

void Routes::clearance(const Request& request, Job& job, const Reply& reply) {
    if (!job.has_packing()) throw Refusal(kNotThere, "there is no packing of this job yet");
    Json asked;
    if (request.method == "POST") {
        asked = body_of(request);
        require_copy_name(asked);
        require_matrix(asked.value("transform", Json()));
        if (asked.contains("changes")) require_changes(asked["changes"], kMostChanges);
    } else {
        asked = {{"tray", number_in(request, "tray", 1, kMostTrays)},
                 {"placement", number_in(request, "placement", 0, kMostCopies)}};
        if (asked["tray"] == 0) throw Refusal(kBadRequest, "trays are counted from 1");
    }
    const Question question(job.folder.questions(), "clearance-" + std::to_string(++asked_), asked);
    Command command = tasks_.child({"clearance", question.asked.string()}, job.folder.root);
    command.output = question.answer;
    command.errors = question.errors;
    try {
        tasks_.start(std::move(command), [question, reply](Ending ending) {
            const std::optional<Json> said = read_json(question.answer);
            const std::string why = question.why();
            question.remove();
            reply(ending.status == 0 && said ? json_response(*said) : failure(ending, why));
        });
    } catch (const Refusal&) {
        question.remove();
        throw;
    }
}

}  // namespace spectralpack::server
