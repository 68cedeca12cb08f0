#pragma once
/// The subcommands. Each adds itself to the application and returns what runs it when it was chosen.

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace spectralpack::cli {

struct Command {
    CLI::App* app;
    std::function<int()> run;  ///< returns the exit status
};

/// Gives the application its name, its help and all commands.
std::vector<Command> add_commands(CLI::App& app);

Command add_pack_command(CLI::App& app);
Command add_bench_command(CLI::App& app);
Command add_check_command(CLI::App& app);
Command add_generate_command(CLI::App& app);
Command add_inspect_command(CLI::App& app);
Command add_prepare_command(CLI::App& app);
Command add_render_command(CLI::App& app);
Command add_plan_command(CLI::App& app);
Command add_serve_command(CLI::App& app);
Command add_view_command(CLI::App& app);
Command add_help_command(CLI::App& app);
Command add_version_command(CLI::App& app);

}  // namespace spectralpack::cli
