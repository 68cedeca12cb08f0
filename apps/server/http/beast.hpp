#pragma once
/// The names of Boost's libraries that the connection's code uses.

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

namespace spectralpack::server {

namespace beast = boost::beast;
namespace http = boost::beast::http;
using Stream = beast::tcp_stream;
using ErrorCode = boost::system::error_code;

/// What every answer says: browsers are to guess nothing, to run nothing that is not this server's, and to show it in
/// no other page.
inline constexpr std::pair<const char*, const char*> kSafety[] = {
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
     "font-src 'self'; form-action 'none'; base-uri 'none'; frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
};

}  // namespace spectralpack::server
