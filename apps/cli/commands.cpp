#include "commands.hpp"

namespace spectralpack::cli {

std::vector<Command> add_commands(CLI::App& app) {
    app.name("spectralpack");
    app.description("Packs 3D parts densely into trays, without collisions and so that they come apart.");
    app.set_version_flag("-V,--version", "spectralpack " SPECTRALPACK_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Try: spectralpack pack parts/ --printer formlabs-fuse1 -o build.3mf\n"
        "'spectralpack COMMAND --help' explains a command, 'spectralpack help OPTION' an\n"
        "option of pack.");
    return {add_pack_command(app),     add_bench_command(app),   add_check_command(app),   add_plan_command(app),
            add_generate_command(app), add_inspect_command(app), add_prepare_command(app), add_render_command(app),
            add_serve_command(app),    add_view_command(app),    add_help_command(app),    add_version_command(app)};
}

}  // namespace spectralpack::cli
