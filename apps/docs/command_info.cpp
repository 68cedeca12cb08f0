#include "command_info.hpp"

#include <CLI/CLI.hpp>

namespace spectralpack::docs {
namespace {

Takes takes_of(const Option& option) {
    if (option.type == OptionType::flag) return Takes::nothing;
    if (option.type == OptionType::file || option.type == OptionType::files) return Takes::file;
    if (option.type == OptionType::folder) return Takes::folder;
    const bool words = !option.words.empty() || !option.none_word.empty() || !option.zero_word.empty();
    return words ? Takes::words : Takes::value;
}

void learn_values(const Option& option, OptionInfo& info) {
    info.takes = takes_of(option);
    for (const std::string_view word : {option.none_word, option.zero_word}) {
        if (!word.empty()) info.words.emplace_back(word);
    }
    info.words.insert(info.words.end(), option.words.begin(), option.words.end());
}

/// Line breaks are the help page's own.
std::string in_one_line(std::string text) {
    for (char& c : text) {
        if (c == '\n') c = ' ';
    }
    return text;
}

OptionInfo info_of(const CLI::Option& given, bool of_pack) {
    OptionInfo info;
    for (const std::string& name : given.get_snames()) {
        info.names.push_back("-" + name);
    }
    for (const std::string& name : given.get_lnames()) {
        info.names.push_back("--" + name);
    }
    info.line = in_one_line(given.get_description());
    if (given.get_items_expected_max() == 0) return info;
    info.takes = Takes::file;
    info.placeholder = given.get_type_name();
    info.repeatable = given.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    const Option* known = given.get_lnames().empty() ? nullptr : find_option(given.get_lnames().front());
    if (known) learn_values(*known, info);
    if (of_pack) info.entry = known;
    return info;
}

CommandInfo info_of(const CLI::App& command) {
    CommandInfo info{command.get_name(), command.get_description(), command.get_footer(), {}, {}};
    const bool pack = info.name == "pack";
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) {
            info.arguments.push_back(option->get_name(true));
        } else {
            info.options.push_back(info_of(*option, pack));
        }
    }
    for (OptionInfo& option : info.options) {
        if (!pack || option.takes != Takes::nothing) continue;
        std::string name = option.names.back().substr(2);
        if (!find_option(name) && name.starts_with("no-")) name.erase(0, 3);
        option.entry = find_option(name);
    }
    return info;
}

}  // namespace

std::vector<CommandInfo> commands_of(const CLI::App& app) {
    std::vector<CommandInfo> commands;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        commands.push_back(info_of(*command));
    }
    return commands;
}

}  // namespace spectralpack::docs
