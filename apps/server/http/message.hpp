#pragma once
/// Requests and responses as the routes see them.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "jobs/text_files.hpp"

namespace spectralpack::server {

struct Request {
    std::string method;             ///< "GET"
    std::vector<std::string> path;  ///< decoded: {"api", "jobs", "0123456789ab"}
    std::map<std::string, std::string> query;
    std::string body;
    std::string if_none_match, last_event_id;
    bool takes_gzip = false;
};

struct Response {
    int status = 200;
    std::string type = "application/json";
    std::string body;
    std::filesystem::path file;  ///< instead of the body
    std::string download;        ///< the name under which a browser keeps it; empty: it shows it
    std::vector<std::pair<std::string, std::string>> headers;
};

using Reply = std::function<void(Response)>;

Response json_response(const Json& json, int status = 200);
Response error_response(int status, const std::string& sentence);

}  // namespace spectralpack::server
