#include "standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace spectralpack::cli {

void hold_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
        // The lowest number that is free is this one. To a stream opened for reading nothing can be written.
        static_cast<void>(open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY));
    }
}

std::optional<std::string> lost_output() {
    errno = 0;
    const bool failed = std::ferror(stdout) != 0, flushed = std::fflush(stdout) == 0;
    if (!failed && flushed) return std::nullopt;
    return errno == 0 ? "it was cut off" : std::generic_category().message(errno);
}

}  // namespace spectralpack::cli
