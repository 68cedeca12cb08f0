#include "http/message.hpp"

namespace spectralpack::server {

Response json_response(const Json& json, int status) {
    Response response;
    response.status = status;
    response.body = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return response;
}

Response error_response(int status, const std::string& sentence) {
    return json_response({{"error", sentence}}, status);
}

}  // namespace spectralpack::server
