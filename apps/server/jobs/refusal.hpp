#pragma once
/// What the server answers to a request that it does not do, in the user's words.

#include <stdexcept>
#include <string>

namespace spectralpack::server {

class Refusal : public std::runtime_error {
  public:
    /// `status` of HTTP.
    Refusal(int status, const std::string& sentence) : std::runtime_error(sentence), status_(status) {}
    int status() const { return status_; }

  private:
    int status_;
};

inline constexpr int kBadRequest = 400, kNoToken = 401, kForbidden = 403, kNotThere = 404, kNotNow = 409,
                     kTooLarge = 413, kTooMany = 429, kBroken = 500, kBusy = 503, kNoRoom = 507;

}  // namespace spectralpack::server
