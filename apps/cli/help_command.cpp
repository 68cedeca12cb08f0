#include <fmt/format.h>

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

int run_help(const CLI::App& app, std::string topic) {
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
    topic.erase(0, topic.find_first_not_of('-'));
    const Option* option = find_option(topic.starts_with("no-") && !find_option(topic) ? topic.substr(3) : topic);
    if (!option) {
        throw UsageError(fmt::format(
            "there is no command and no option of pack called '{}'; spectralpack --help and spectralpack pack --help-all "
            "show those there are",
            printable(topic)));
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
