#include "request_values.hpp"

#include <algorithm>
#include <cmath>

#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

constexpr int kMostTrays = 100000, kMostCopies = 100000000;
constexpr double kMostNumber = 1e9;

}  // namespace

Json body_of(const Request& request) {
    Json body = Json::parse(request.body, nullptr, false);
    if (body.is_discarded()) throw Refusal(kBadRequest, "what was sent is no JSON");
    return body;
}

std::string text_in(const Json& body, const char* key) {
    if (!body.is_object()) throw Refusal(kBadRequest, "a JSON object is wanted");
    const auto value = body.find(key);
    if (value == body.end() || value->is_null()) return "";
    if (!value->is_string()) throw Refusal(kBadRequest, std::string(key) + " is a text");
    std::string text = value->get<std::string>();
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20)
            throw Refusal(kBadRequest, std::string(key) + " holds a control character");
    }
    return text;
}

int integer_in(const Json& body, const char* key, int least, int most) {
    const auto value = body.is_object() ? body.find(key) : body.end();
    if (value == body.end() || !value->is_number_integer() || value->get<std::int64_t>() < least ||
        value->get<std::int64_t>() > most) {
        throw Refusal(kBadRequest, std::string(key) + ": a whole number from " + std::to_string(least) + " to " +
                                       std::to_string(most) + " is wanted");
    }
    return value->get<int>();
}

std::size_t number_in(const Request& request, const char* key, std::size_t otherwise, std::size_t most) {
    const auto said = request.query.find(key);
    if (said == request.query.end()) return otherwise;
    const std::string& text = said->second;
    const bool digits = !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || std::stoul(text) > most) {
        throw Refusal(kBadRequest, std::string(key) + ": a number up to " + std::to_string(most) + " is wanted");
    }
    return std::stoul(text);
}

void require_matrix(const Json& matrix) {
    const auto is_row = [](const Json& row) {
        return row.is_array() && row.size() == 4 && std::ranges::all_of(row, [](const Json& number) {
                   return number.is_number() && std::abs(number.get<double>()) <= kMostNumber;
               });
    };
    if (!matrix.is_array() || matrix.size() != 4 || !std::ranges::all_of(matrix, is_row)) {
        throw Refusal(kBadRequest, "transform: four rows of four numbers are wanted");
    }
}

void require_copy_name(const Json& copy) {
    integer_in(copy, "tray", 1, kMostTrays);
    integer_in(copy, "part", 0, kMostCopies);
    integer_in(copy, "copy", 0, kMostCopies);
}

void require_changes(const Json& changes, std::size_t most) {
    if (!changes.is_array() || changes.size() > most) {
        throw Refusal(kBadRequest, "changes: a list of " + std::to_string(most) + " at most is wanted");
    }
    for (const Json& change : changes) {
        require_copy_name(change);
        if (!change.contains("transform")) throw Refusal(kBadRequest, "a change says where the copy stands: transform");
        if (!change["transform"].is_null()) require_matrix(change["transform"]);
    }
}

}  // namespace spectralpack::server
