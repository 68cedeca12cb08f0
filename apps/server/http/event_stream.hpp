#pragma once
/// GET /api/jobs/ID/events: what a run has written, and goes on to write, as server-sent events.

#include <functional>
#include <memory>
#include <string>

#include "http/beast.hpp"
#include "routes.hpp"

namespace spectralpack::server {

/// Tells of the job until it is deleted or the other end is gone; then calls `done`. `last` is the id of the last event
/// that the other end has seen, or empty.
void watch_job(Stream stream, Routes& routes, const std::string& job, const std::string& last,
               std::function<void()> done);

}  // namespace spectralpack::server
