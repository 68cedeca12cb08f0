/// The command line: parses, runs one subcommand, and turns errors into messages and exit statuses.

#include <fmt/format.h>
#include <signal.h>

#include <cstdio>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "commands.hpp"
#include "exit_status.hpp"
#include "last_resort.hpp"
#include "misspelt.hpp"
#include "standard_output.hpp"
#include "text.hpp"

namespace {

using namespace spectralpack;
using namespace spectralpack::cli;

int complain(const std::string& message, int status) {
    fmt::print(stderr, "spectralpack: {}\n", message);
    return status;
}

/// "--gap=" would take the next argument for its value.
void require_values(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--") return;
        if (argument.starts_with("--") && argument.find('=') == argument.size() - 1) {
            throw UsageError(fmt::format("{} says no value", printable(argument)));
        }
    }
}

int run(int argc, char** argv) {
    CLI::App app;
    const std::vector<Command> commands = add_commands(app);

    require_values(argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        return complain(
            fmt::format("{}\n'spectralpack --help' shows the commands, 'spectralpack COMMAND --help' their options.",
                        complaint_of(app, error)),
            kUsage);
    }
    for (const Command& command : commands) {
        if (command.app->parsed()) return command.run();
    }
    return kUsage;
}

/// One heap for all threads: with one for each of them, what one gave back is of no use to the others, and a run takes
/// a tenth more memory. What runs most often has room of its own (search/cpu/pass_rooms).
void use_one_heap() {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 1);
#endif
}

/// The exit status of run(), whose errors become messages.
int told(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        return complain(printable(error.what()), status_of(error.kind()));
    } catch (const std::bad_alloc&) {
        return complain("out of memory", kOutOfResources);
    } catch (const std::system_error& error) {
        if (std::ferror(stdout)) return kOutOfResources;  // of which main() tells
        return complain(printable(error.what()), kOutOfResources);
    } catch (const std::exception& error) {
        return complain(fmt::format("internal error: {}", error.what()), kCheckFailed);
    }
}

}  // namespace

int main(int argc, char** argv) {
    begin_main();
    hold_standard_streams();
    use_one_heap();
    signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond its limit is an error where it is written, as a full disk is
    const int status = told(argc, argv);
    const auto loss = lost_output();
    return loss ? complain("cannot write standard output: " + *loss, kOutOfResources) : status;
}
