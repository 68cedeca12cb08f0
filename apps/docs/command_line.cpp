#include <fmt/format.h>

#include "documents.hpp"
#include "json_values.hpp"

namespace spectralpack::docs {
namespace {

/// In a cell of a table.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c;
    }
    return result;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

std::string call_of(const Option& option) {
    const std::string letter = option.letter ? fmt::format("-{}, ", option.letter) : "";
    const std::string call = fmt::format("{}--{}", letter, option.name);
    return option.placeholder.empty() ? call : fmt::format("{} {}", call, option.placeholder);
}

std::string row(const Option& option) {
    return fmt::format("| [{}](#{}) | {} | {} |\n", code(fmt::format("--{}", option.name)), option.name,
                       cell(default_text(option)), cell(std::string(option.line)));
}

std::string with_capital(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string in_job_file(const Option& option) {
    if (!option.in_pack.get && !option.in_job.get) return "on the command line only";
    std::string examples;
    for (const OptionValue& value : examples_of(option)) {
        examples +=
            (examples.empty() ? "" : ", ") + code(fmt::format("\"{}\": {}", option.name, json_of(option, value)));
    }
    return examples;
}

std::string section(const Option& option) {
    std::string text =
        fmt::format("### {}\n\n{}\n\n{}.", option.name, code(call_of(option)), with_capital(std::string(option.line)));
    if (!option.help.empty()) text += fmt::format(" {}", option.help);
    if (!option.off_line.empty())
        text += fmt::format(" {}: {}.", code(fmt::format("--no-{}", option.name)), option.off_line);
    text += "\n\n";
    if (option.type != OptionType::flag) text += fmt::format("- takes: {}\n", values_of(option));
    if (const std::string by_default = default_text(option); !by_default.empty()) {
        text += fmt::format("- default: {}\n", by_default);
    }
    text += fmt::format("- in a job file: {}\n", in_job_file(option));
    text += fmt::format("- placements depend on it: {}\n\n", option.hash_place > 0 ? "yes" : "no");
    return text;
}

std::string overview(const std::vector<CommandInfo>& commands) {
    std::string text = "| command | |\n| --- | --- |\n";
    for (const CommandInfo& command : commands) {
        text += fmt::format("| [{}](#{}) | {} |\n", code(command.name), command.name, cell(command.line));
    }
    return text + "\n";
}

/// A command whose options are not in the table.
std::string command_section(const CommandInfo& command) {
    std::string call = fmt::format("spectralpack {}", command.name);
    for (const std::string& argument : command.arguments) {
        call += fmt::format(" {}", argument);
    }
    std::string text = fmt::format("## {}\n\n{}: {}.\n\n", command.name, code(call), command.line);
    if (!command.options.empty()) text += "| option | |\n| --- | --- |\n";
    for (const OptionInfo& option : command.options) {
        std::string names;
        for (const std::string& name : option.names) {
            names += (names.empty() ? "" : ", ") + name;
        }
        if (!option.placeholder.empty()) names += fmt::format(" {}", option.placeholder);
        text += fmt::format("| {} | {} |\n", code(names), cell(option.line));
    }
    if (!command.options.empty()) text += "\n";
    if (!command.footer.empty()) text += fmt::format("```\n{}\n```\n\n", command.footer);
    return text;
}

}  // namespace

std::string command_line(const std::vector<CommandInfo>& commands) {
    std::string text =
        "# The command line\n"
        "\n"
        "<!-- Made from the commands and the option table (src/model/options): `cmake --build build --target write_docs` "
        "writes it\n"
        "anew. -->\n"
        "\n";
    text += overview(commands);
    for (const CommandInfo& command : commands) {
        if (command.name != "pack") text += command_section(command);
    }
    text +=
        "## pack\n"
        "\n"
        "`spectralpack pack PART... [options]`. In a job file ([format.md](format.md#job-files)) an option stands by its "
        "name\n"
        "in `options`; the command line overrides the file. A packing file records every option that decided "
        "placements.\n"
        "`spectralpack help NAME` shows the same in a terminal.\n\n";
    std::string sections;
    for (const OptionGroup group : kOptionGroups) {
        text += fmt::format("**{}**\n\n| option | default | |\n| --- | --- | --- |\n", title_of(group));
        sections += fmt::format("## {}\n\n", title_of(group));
        for (const Option* option : options_under(group)) {
            text += row(*option);
            sections += section(*option);
        }
        text += "\n";
    }
    text += sections;
    text.pop_back();  // one line feed ends a file
    return text;
}

}  // namespace spectralpack::docs
