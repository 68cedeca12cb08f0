#include "http/guard.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/address.hpp>

#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

constexpr std::string_view kCookie = "spectralpack";

/// The value of our cookie in "a=1; spectralpack=2".
std::string_view cookie_in(std::string_view cookies) {
    while (!cookies.empty()) {
        const std::size_t end = cookies.find(';');
        std::string_view one = cookies.substr(0, end);
        cookies = end == std::string_view::npos ? std::string_view{} : cookies.substr(end + 1);
        one.remove_prefix(std::min(one.find_first_not_of(' '), one.size()));
        const std::size_t equals = one.find('=');
        if (equals != std::string_view::npos && one.substr(0, equals) == kCookie) return one.substr(equals + 1);
    }
    return {};
}

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return small;
}

bool is_address(std::string host) {
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    boost::system::error_code error;
    boost::asio::ip::make_address(host, error);
    return !error;
}

}  // namespace

Guard::Guard(const Settings& settings, std::uint16_t port) : token_(settings.token), port_(port) {
    hosts_ = {"127.0.0.1", "localhost", "[::1]"};
    const auto address = boost::asio::ip::make_address(settings.address);
    if (address.is_loopback()) return;
    any_address_ = address.is_unspecified();
    hosts_.push_back(address.is_v6() ? "[" + settings.address + "]" : settings.address);
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) == 0) hosts_.push_back(lower(name.data()));
}

void Guard::require(const Asker& asker, bool open) const {
    const std::string host = lower(asker.host);
    const std::string port = ":" + std::to_string(port_);
    const std::string name = host.ends_with(port) ? host.substr(0, host.size() - port.size()) : port_ == 80 ? host : "";
    const bool known = std::find(hosts_.begin(), hosts_.end(), name) != hosts_.end();
    if (!known && !(any_address_ && is_address(name))) {
        throw Refusal(kForbidden,
                      "this server does not go by the name in the address: open it as it said when it began");
    }
    if (!asker.origin.empty() && lower(asker.origin) != "http://" + host) {
        throw Refusal(kForbidden, "another site's page may not use this server");
    }
    // A link on another site may lead to the page, and to nothing else.
    if (!open && (asker.fetch_site == "cross-site" || asker.fetch_site == "same-site")) {
        throw Refusal(kForbidden, "another site's page may not use this server");
    }
    if (open || token_.empty()) return;
    constexpr std::string_view kBearer = "Bearer ";
    const bool bears = asker.authorization.starts_with(kBearer) && is_token(asker.authorization.substr(kBearer.size()));
    if (!bears && !is_token(cookie_in(asker.cookie))) {
        throw Refusal(kNoToken, "this server asks for the token that it printed when it began");
    }
}

bool Guard::is_token(std::string_view said) const {
    unsigned difference = said.size() == token_.size() ? 0U : 1U;
    for (std::size_t i = 0; i < token_.size(); ++i) {
        const char other = i < said.size() ? said[i] : '\0';
        difference |= static_cast<unsigned>(static_cast<unsigned char>(token_[i] ^ other));
    }
    return difference == 0 && !token_.empty();
}

std::string Guard::cookie() const {
    return std::string(kCookie) + "=" + token_ + "; Path=/; HttpOnly; SameSite=Strict";
}

}  // namespace spectralpack::server
