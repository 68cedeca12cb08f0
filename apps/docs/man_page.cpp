#include <fmt/format.h>

#include "documents.hpp"

#include <spectralpack/error.hpp>

namespace spectralpack::docs {
namespace {

/// As troff prints it as it is. A line may not begin with a point or a quote.
std::string plain(const std::string& text) {
    std::string result;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) result += "\\&";
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else {
            result += c;
        }
        begins = c == '\n';
    }
    return result;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string names_of(const OptionInfo& option) {
    std::string names;
    for (const std::string& name : option.names) {
        names += (names.empty() ? "" : ", ") + bold(name);
    }
    return option.placeholder.empty() ? names : names + " " + italic(option.placeholder);
}

/// Of the table's options all that it says; what stands for --no-NAME, too, once.
std::string item(const OptionInfo& option) {
    const std::string head = fmt::format(".TP\n{}\n", names_of(option));
    const Option* entry = option.entry;
    if (!entry || option.names.back() != fmt::format("--{}", entry->name)) return head + plain(option.line) + "\n";
    std::string text = fmt::format("{}.", entry->line);
    if (!entry->help.empty()) text += fmt::format(" {}", entry->help);
    if (const std::string by_default = default_text(*entry); !by_default.empty()) {
        text += fmt::format(" Default: {}.", by_default);
    }
    return head + plain(text) + "\n";
}

std::string synopsis(const CommandInfo& command) {
    std::string text = fmt::format(".B spectralpack {}\n", command.name);
    for (const std::string& argument : command.arguments) {
        text += fmt::format(".I {}\n", plain(argument));
    }
    return text + (command.options.empty() ? "" : ".RI [ options ]\n") + ".br\n";
}

const CommandInfo& pack_of(const std::vector<CommandInfo>& commands) {
    for (const CommandInfo& command : commands) {
        if (command.name == "pack") return command;
    }
    throw UsageError("there is no command pack");
}

std::string pack_options(const CommandInfo& pack) {
    std::string text;
    for (const OptionGroup group : kOptionGroups) {
        text += fmt::format(".SS {}\n", title_of(group));
        for (const Option* entry : options_under(group)) {
            for (const OptionInfo& option : pack.options) {
                if (option.entry == entry) text += item(option);
            }
        }
    }
    return text;
}

std::string other_commands(const std::vector<CommandInfo>& commands) {
    std::string text;
    for (const CommandInfo& command : commands) {
        if (command.name == "pack") continue;
        text += fmt::format(".SS spectralpack {}\n{}.\n", command.name, plain(command.line));
        if (!command.footer.empty()) text += ".PP\n.nf\n" + plain(command.footer) + "\n.fi\n";
        for (const OptionInfo& option : command.options) {
            text += item(option);
        }
    }
    return text;
}

}  // namespace

std::string man_page(const std::vector<CommandInfo>& commands) {
    std::string lines;
    for (const CommandInfo& command : commands) {
        lines += synopsis(command);
    }
    const CommandInfo& pack = pack_of(commands);
    return ".TH SPECTRALPACK 1 \"\" \"spectralpack " SPECTRALPACK_VERSION
           "\" \"User Commands\"\n"
           ".SH NAME\n"
           "spectralpack \\- pack 3D parts densely into a build volume, without collisions\n"
           ".SH SYNOPSIS\n" +
           lines +
           ".SH DESCRIPTION\n"
           "Fills a box or a closed mesh with copies of 3D parts and writes where each of them stands. Lengths are in "
           "millimetres. Diagnostics go to standard error, results to standard output.\n"
           ".SH PACKING\n"
           ".nf\n" +
           plain(pack.footer) + "\n.fi\n.SH OPTIONS OF PACK\n" + pack_options(pack) + ".SH OTHER COMMANDS\n" +
           other_commands(commands) +
           ".SH SEE ALSO\n"
           "The options as a job file holds them: docs/cli.md and docs/job.schema.json.\n";
}

}  // namespace spectralpack::docs
