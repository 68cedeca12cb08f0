/// spectralpack-server: what `spectralpack serve` and `view` start (docs/server.md). Its arguments are theirs, in
/// words:
///
///     --program FILE --dir DIR --listen ADDRESS --port N --parallel N --time-limit SECONDS --file-size BYTES
///     --token TOKEN --no-browser --view PACKING

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <boost/asio/ip/address.hpp>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>

#include <spectralpack/error.hpp>

#include "children/children.hpp"
#include "jobs/refusal.hpp"
#include "server.hpp"

extern char** environ;

namespace {

using namespace spectralpack;
using namespace spectralpack::server;
namespace fs = std::filesystem;

constexpr int kUsageStatus = 2, kInputStatus = 3, kRoomStatus = 4;
constexpr std::size_t kTokenLength = 40;

fs::path own_path() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error);
}

std::string new_token() {
    constexpr std::string_view kLetters = "abcdefghijkmnpqrstuvwxyz23456789";
    std::random_device random;
    std::uniform_int_distribution<std::size_t> letter(0, kLetters.size() - 1);
    std::string token;
    while (token.size() < kTokenLength) {
        token += kLetters[letter(random)];
    }
    return token;
}

struct Arguments {
    std::map<std::string, std::string> values;

    Arguments(int argc, char** argv) {
        for (int i = 1; i < argc; ++i) {
            const std::string name = argv[i];
            if (name == "--no-browser") {
                values[name] = "yes";
            } else if (i + 1 < argc && name.starts_with("--")) {
                values[name] = argv[++i];
            } else {
                throw UsageError("spectralpack-server is started by 'spectralpack serve'");
            }
        }
    }
    std::string text(const char* name, const std::string& otherwise = "") const {
        const auto value = values.find(name);
        return value == values.end() ? otherwise : value->second;
    }
};

fs::path default_jobs() {
    const char* data = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    if (data && *data) return fs::path(data) / "spectralpack" / "jobs";
    if (home && *home) return fs::path(home) / ".local" / "share" / "spectralpack" / "jobs";
    throw UsageError("there is no home folder to keep jobs in: say --dir");
}

Settings settings_of(const Arguments& arguments) {
    Settings settings;
    settings.self = own_path();
    settings.program = arguments.text("--program", (settings.self.parent_path() / "spectralpack").string());
    const std::string jobs = arguments.text("--dir");
    settings.jobs = fs::absolute(jobs.empty() ? default_jobs() : fs::path(jobs));
    settings.address = arguments.text("--listen", settings.address);
    if (const std::string port = arguments.text("--port"); !port.empty()) {
        settings.port = static_cast<std::uint16_t>(std::stoul(port));
        settings.port_said = true;
    }
    Limits& limits = settings.limits;
    if (const std::string n = arguments.text("--parallel"); !n.empty()) limits.parallel = std::stoi(n);
    if (const std::string s = arguments.text("--time-limit"); !s.empty()) limits.time_limit = std::stod(s);
    if (const std::string b = arguments.text("--file-size"); !b.empty()) limits.file_bytes = std::stoull(b);
    settings.browser = arguments.text("--no-browser").empty();
    settings.token = arguments.text("--token");
    if (settings.token.empty()) {
        const char* said = std::getenv("SPECTRALPACK_TOKEN");
        boost::system::error_code error;
        const auto address = boost::asio::ip::make_address(settings.address, error);
        if (said && *said) {
            settings.token = said;
        } else if (!error && !address.is_loopback()) {
            settings.token = new_token();
        }
    }
    unsetenv("SPECTRALPACK_TOKEN");  // children need not know it
    return settings;
}

/// On a desktop; says nothing where there is none.
void open_browser(const std::string& address) {
    if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
    std::string program = "xdg-open", url = address;
    std::array<char*, 3> arguments{program.data(), url.data(), nullptr};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    posix_spawnp(&process, program.c_str(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
}

int run(const Arguments& arguments) {
    const Settings settings = settings_of(arguments);
    Server server(settings);
    std::string page = server.address();
    if (const std::string packing = arguments.text("--view"); !packing.empty()) {
        page += "#/job/" + server.import(packing) + "/build";
    }
    // Behind #, so that it is sent to nobody: the page reads it and exchanges it for a cookie.
    if (!settings.token.empty()) page = server.address() + "#token=" + settings.token;
    std::cout << "spectralpack: open " << page << "\nJobs are kept in " << settings.jobs.string()
              << " and go on when this ends. Ctrl-C ends it." << std::endl;
    if (settings.browser) open_browser(page);
    server.run();
    return 0;
}

int complain(const std::string& message, int status) {
    std::cerr << "spectralpack: " << message << "\n";
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::string(argv[1]) == "--child") return run_child({argv + 2, argv + argc});
    try {
        return run(Arguments(argc, argv));
    } catch (const Refusal& refusal) {
        return complain(refusal.what(), kInputStatus);
    } catch (const Error& error) {
        return complain(error.what(), error.kind() == ErrorKind::usage ? kUsageStatus : kRoomStatus);
    } catch (const std::exception& error) {
        return complain(error.what(), 1);
    }
}
