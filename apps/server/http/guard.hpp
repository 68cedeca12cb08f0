#pragma once
/// Who may ask. A page of another site, whatever name it gives to this machine, may not; without the token, where there
/// is one, nobody may.

#include <string>
#include <string_view>
#include <vector>

#include "settings.hpp"

namespace spectralpack::server {

/// Of a request, what says who asks. Empty where it is not said.
struct Asker {
    std::string_view host, origin, fetch_site, authorization, cookie;
};

class Guard {
  public:
    /// `port`: that it listens on.
    Guard(const Settings& settings, std::uint16_t port);

    /// Throws Refusal. `open`: needs no token, as the page itself and its exchange for a cookie do not.
    void require(const Asker& asker, bool open) const;

    bool asks_for_token() const { return !token_.empty(); }
    /// In a time that does not depend on where they differ.
    bool is_token(std::string_view said) const;
    /// The value of the header Set-Cookie.
    std::string cookie() const;

  private:
    std::vector<std::string> hosts_;  ///< names that this server goes by
    std::string token_;
    std::uint16_t port_;
    bool any_address_ = false;
};

}  // namespace spectralpack::server
