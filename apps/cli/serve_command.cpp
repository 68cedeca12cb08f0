#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include <spectralpack/spectralpack.hpp>

#include "commands.hpp"
#include "exit_status.hpp"
#include "number_options.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

namespace fs = std::filesystem;

struct ServeArguments {
    std::string folder, address, packing, file_size;
    std::optional<int> port, parallel;
    std::optional<double> time_limit;
    bool no_browser = false;
};

/// The server's program: installed beside this one, or where a build folder has it.
fs::path server_program(const fs::path& own) {
    const fs::path folder = own.parent_path(), name = "spectralpack-server";
    for (const fs::path& place : {folder / name, folder / "../server" / name, folder / "../../server" / name}) {
        std::error_code none;
        if (fs::exists(place, none)) return place;
    }
    throw UsageError("spectralpack-server, which shows the page, is not beside this program: install it, too");
}

/// This process becomes the server.
int become_server(const ServeArguments& arguments) {
    std::error_code error;
    const fs::path own = fs::read_symlink("/proc/self/exe", error);
    std::vector<std::string> words{server_program(own).string(), "--program", own.string()};
    const auto say = [&](const char* name, const std::string& value) {
        if (!value.empty()) words.insert(words.end(), {name, value});
    };
    say("--dir", arguments.folder);
    say("--listen", arguments.address);
    say("--view", arguments.packing);
    if (arguments.port) say("--port", std::to_string(*arguments.port));
    if (arguments.parallel) say("--parallel", std::to_string(*arguments.parallel));
    if (arguments.time_limit) say("--time-limit", fmt::format("{:.0f}", *arguments.time_limit));
    if (!arguments.file_size.empty()) {
        say("--file-size",
            std::to_string(std::get<std::int64_t>(parse_value(*find_option("memory"), arguments.file_size))));
    }
    if (arguments.no_browser) words.emplace_back("--no-browser");
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    std::fflush(stdout);
    execv(pointers.front(), pointers.data());
    throw UsageError(fmt::format("{} cannot be started: {}", words.front(), std::strerror(errno)));
}

void add_options(CLI::App& sub, ServeArguments& a) {
    add_number(sub, "port", "N", {1, 65535}, a.port, "port to listen on [7878, or another where that is taken]");
    sub.add_option("--dir", a.folder, "folder that jobs are kept in [~/.local/share/spectralpack/jobs]");
    sub.add_option(
        "--listen", a.address,
        "address of this machine for others to reach it by, like 0.0.0.0; they need the token that is printed "
        "[127.0.0.1: this machine alone]");
    sub.add_flag("--no-browser", a.no_browser, "do not open the page");
    add_number(sub, "parallel", "N", kFromOne, a.parallel, "jobs to pack at once; others wait [1]");
    add_number(sub, "time-limit", "SECONDS", kFromOne, a.time_limit, "most time for one job");
    sub.add_option("--file-size", a.file_size, "most bytes of a file that is sent, like 500M [4Gi]");
}

}  // namespace

Command add_serve_command(CLI::App& app) {
    auto* sub = app.add_subcommand("serve", "Open the page on which builds are packed and looked at");
    sub->footer(
        "The page brings parts, packs them, shows the build and hands it out. Jobs are kept in a folder and go on when\n"
        "the page, or this program, ends. Programs can use the same: its interface describes itself at /openapi.json.");
    auto arguments = std::make_shared<ServeArguments>();
    add_options(*sub, *arguments);
    return {sub, [arguments] { return become_server(*arguments); }};
}

Command add_view_command(CLI::App& app) {
    auto* sub = app.add_subcommand("view", "Show a packing on that page");
    auto arguments = std::make_shared<ServeArguments>();
    sub->add_option("PACKING", arguments->packing, "packing file (.json)")->required();
    add_options(*sub, *arguments);
    return {sub, [arguments] { return become_server(*arguments); }};
}

}  // namespace spectralpack::cli
