#pragma once
/// One connection: reads requests, lets the guard and the routes judge them, writes the answers. It waits for nobody:
/// who neither sends nor takes anything for a while is let go.

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "http/guard.hpp"
#include "routes.hpp"

namespace spectralpack::server {

/// Serves the connection until it ends. `done` is called then.
void serve(boost::asio::ip::tcp::socket socket, Routes& routes, const Guard& guard, std::function<void()> done);

}  // namespace spectralpack::server
