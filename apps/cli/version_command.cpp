#include <fmt/format.h>

#include "commands.hpp"
#include "exit_status.hpp"

namespace spectralpack::cli {

Command add_version_command(CLI::App& app) {
    auto* sub = app.add_subcommand("version", "Say which version this is");
    return {sub, [] {
                fmt::print("spectralpack {}\n", SPECTRALPACK_VERSION);
                return static_cast<int>(kDone);
            }};
}

}  // namespace spectralpack::cli
