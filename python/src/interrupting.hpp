#pragma once
/// Work of the library that Python can interrupt: it runs on a thread of its own, without the interpreter's lock, while
/// the calling thread looks after signals and clocks.

#include <chrono>
#include <functional>

#include <spectralpack/stop.hpp>

namespace spectralpack::python {

/// Looked at every few hundredths of a second while the work goes on, without the interpreter's lock.
using Watch = std::function<void()>;

/// Calls `work` with a token that Ctrl-C requests. Rethrows what it throws. After Ctrl-C: raises KeyboardInterrupt once
/// the work has ended.
void interruptible(const std::function<void(const StopToken&)>& work);

/// The same with the caller's own way to stop, which Ctrl-C calls; a second Ctrl-C raises KeyboardInterrupt at the end,
/// the first does not. True after Ctrl-C.
bool interruptible(const std::function<void()>& work, const std::function<void()>& stop, const Watch& watch);

}  // namespace spectralpack::python
