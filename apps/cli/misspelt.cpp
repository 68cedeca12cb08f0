#include "misspelt.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "text.hpp"

#include <spectralpack/typed_text.hpp>

namespace spectralpack::cli {
namespace {

bool is_option(const std::string& argument) { return argument.size() > 1 && argument.front() == '-'; }

std::string no_command(const CLI::App& app, const std::string& typed) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        names.push_back(command->get_name());
    }
    const std::string said = fmt::format("There is no command '{}'.", printable(typed));
    if (const auto near = nearest_word(typed, names)) return fmt::format("{} Did you mean '{}'?", said, *near);
    std::error_code unknown;
    if (std::filesystem::exists(typed, unknown)) {
        return fmt::format("{} To pack it: spectralpack pack {}", said, printable(typed));
    }
    return said;
}

std::string no_option(const CLI::App& command, std::string typed) {
    typed.erase(std::min(typed.find('='), typed.size()));
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    const std::string said = fmt::format("There is no option {}.", printable(typed));
    if (const auto near = nearest_word(typed, names)) return fmt::format("{} Did you mean {}?", said, *near);
    if (typed.starts_with("--")) return said;
    return fmt::format("{} A file whose name starts with a dash is named like ./{}.", said, printable(typed));
}

/// That may be given once and is there more often; null where there is none.
const CLI::Option* given_again(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const bool once = option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw;
        if (once && option->nonpositional() && static_cast<int>(option->count()) > option->get_items_expected_max()) {
            return option;
        }
    }
    return nullptr;
}

}  // namespace

std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::vector<std::string> not_taken = app.remaining(true);
    for (const std::string& argument : not_taken) {
        if (chosen.empty() && !is_option(argument)) return no_command(app, argument);
        if (is_option(argument)) return no_option(command, argument);
    }
    if (const CLI::Option* option = given_again(command)) {
        return fmt::format("{} is given {} times; once is enough.", option->get_name(), option->count());
    }
    std::string list;
    for (const std::string& argument : not_taken) {
        list += " " + printable(argument);
    }
    return list.empty() ? error.what() : fmt::format("{} (not understood:{})", error.what(), list);
}

}  // namespace spectralpack::cli
