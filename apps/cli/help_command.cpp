#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

void print_option(const Option& option) {
    fmt::print("--{}{}{}\n\n", option.name, option.placeholder.empty() ? "" : " ", option.placeholder);
    fmt::print("{}.\n", wrapped(std::string(option.line), kScreenWidth));
    if (!option.help.empty()) fmt::print("\n{}\n", wrapped(std::string(option.help), kScreenWidth));
    if (!option.off_line.empty()) fmt::print("\n--no-{}: {}.\n", option.name, option.off_line);
    fmt::print("\n");
    if (option.type != OptionType::flag) fmt::print("takes     {}\n", values_of(option));
    if (const std::string by_default = default_text(option); !by_default.empty()) {
        fmt::print("default   {}\n", by_default);
    }
    for (const std::string_view example : option.examples) {
        fmt::print("example   --{} {}\n", option.name, example);
    }
    const bool in_job = option.in_pack.get || option.in_job.get;
    fmt::print("in files  {}\n", in_job ? fmt::format("\"{}\" in the options of a job file", option.name) : "no");
}

/// By its name, with or without dashes and "no-", or by its letter; null where there is none.
const Option* option_called(std::string name) {
    const bool letter = name.size() == 2 && name.front() == '-' && name.back() != '-';
    if (letter) {
        const auto known = std::ranges::find(option_table(), name.back(), &Option::letter);
        return known == option_table().end() ? nullptr : &*known;
    }
    name.erase(0, std::min(name.find_first_not_of('-'), name.size()));
    return find_option(name.starts_with("no-") && !find_option(name) ? name.substr(3) : name);
}

/// " Did you mean ...?", of commands and options; empty where nothing is near.
std::string suggestion(const CLI::App& app, const std::string& topic) {
    std::vector<std::string> known;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        known.push_back(command->get_name());
    }
    for (const Option& option : option_table()) {
        known.emplace_back(option.name);
    }
    const auto near = nearest_word(topic.substr(std::min(topic.find_first_not_of('-'), topic.size())), known);
    return near ? fmt::format("; did you mean '{}'?", *near) : "";
}

int run_help(const CLI::App& app, const std::string& topic) {
    if (topic.empty()) {
        // app.help() would be that of the command that was given: this one's.
        fmt::print("{}", app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
        return kDone;
    }
    const auto commands = app.get_subcommands([&](const CLI::App* command) { return command->get_name() == topic; });
    if (!commands.empty()) {
        fmt::print("{}", commands.front()->help(app.get_name()));
        return kDone;
    }
    const Option* option = option_called(topic);
    if (!option) {
        const std::string near = suggestion(app, topic);
        throw UsageError(fmt::format("there is no command and no option of pack called '{}'{}{}", printable(topic),
                                     near,
                                     near.empty() ? "; spectralpack --help and spectralpack pack --help-all show those "
                                                    "there are"
                                                  : ""));
    }
    print_option(*option);
    return kDone;
}

}  // namespace

Command add_help_command(CLI::App& app) {
    auto* sub = app.add_subcommand("help", "Explain a command, or an option of pack");
    sub->footer(
        "  spectralpack help check\n"
        "  spectralpack help wall-gap");
    sub->allow_extras();  // so that an option may be named with its dashes
    auto topic = std::make_shared<std::string>();
    sub->add_option("TOPIC", *topic, "a command, or an option");
    return {sub, [&app, sub, topic] {
                const std::vector<std::string> extras = sub->remaining();
                return run_help(app, topic->empty() && !extras.empty() ? extras.front() : *topic);
            }};
}

}  // namespace spectralpack::cli
