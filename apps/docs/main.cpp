/// Writes the documents that are made from the option table and the commands (apps/docs/CMakeLists.txt says when).

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "cli/commands.hpp"
#include "documents.hpp"

namespace {

using namespace spectralpack;

std::string document(const std::string& kind) {
    if (kind == "schema") return docs::job_schema();
    CLI::App app;
    cli::add_commands(app);
    const auto commands = docs::commands_of(app);
    if (kind == "cli") return docs::command_line(commands);
    if (kind == "man") return docs::man_page(commands);
    if (kind == "bash") return docs::bash_completion(commands);
    if (kind == "zsh") return docs::zsh_completion(commands);
    if (kind == "fish") return docs::fish_completion(commands);
    return "";
}

}  // namespace

int main(int argc, char** argv) {
    const std::string text = argc == 2 || argc == 3 ? document(argv[1]) : "";
    if (text.empty()) {
        fmt::print(stderr, "usage: {} schema|cli|man|bash|zsh|fish [FILE]\n", argv[0]);
        return 2;
    }
    if (argc == 2) {
        fmt::print("{}", text);
        return 0;
    }
    std::ofstream file(argv[2], std::ios::binary);
    file << text;
    file.close();
    if (file) return 0;
    fmt::print(stderr, "cannot write {}\n", argv[2]);
    return 4;
}
