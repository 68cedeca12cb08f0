#pragma once
/// Another program, run to its end.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "spectralpack/stop.hpp"

namespace spectralpack::tools {

struct Ended {
    int status = 0;  ///< as shells have it: 128 + signal where one ended it
    double wall_seconds = 0, cpu_seconds = 0;
    std::int64_t peak_memory = 0;  ///< bytes
    std::string last_words;        ///< the end of what it said on standard error
};

/// Runs `arguments`, the first of which is the program's file, with standard output thrown away and every line of
/// standard error given to `line`. When stopped it gets an interrupt, and its end is waited for. Throws ResourceError
/// where the program cannot be started.
Ended run_program(const std::vector<std::string>& arguments, const std::function<void(const std::string&)>& line,
                  const StopToken& stop);

}  // namespace spectralpack::tools
