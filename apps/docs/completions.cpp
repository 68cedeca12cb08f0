#include <fmt/format.h>

#include "documents.hpp"

namespace spectralpack::docs {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
    return fmt::format("{}", fmt::join(words, between));
}

std::vector<std::string> command_names(const std::vector<CommandInfo>& commands) {
    std::vector<std::string> names;
    for (const CommandInfo& command : commands) {
        names.push_back(command.name);
    }
    return names;
}

/// What `help` explains.
std::vector<std::string> topics(const std::vector<CommandInfo>& commands) {
    std::vector<std::string> names = command_names(commands);
    for (const Option& option : option_table()) {
        names.emplace_back(option.name);
    }
    return names;
}

std::vector<std::string> option_names(const CommandInfo& command) {
    std::vector<std::string> names;
    for (const OptionInfo& option : command.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

/// In single quotes of a shell.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result + "'";
}

std::string bash_words(const std::vector<std::string>& words) {
    return fmt::format("mapfile -t COMPREPLY < <(compgen -W {} -- \"$cur\")", quoted(joined(words)));
}

/// Completes the value of the option before the cursor.
std::string bash_value(const OptionInfo& option) {
    switch (option.takes) {
        case Takes::words:
            return bash_words(option.words);
        case Takes::file:
            return "_spectralpack_paths -f";
        case Takes::folder:
            return "_spectralpack_paths -d";
        default:
            return ":";
    }
}

std::string bash_command(const CommandInfo& command) {
    std::string cases;
    for (const OptionInfo& option : command.options) {
        if (option.takes == Takes::nothing) continue;
        cases += fmt::format("                {}) {}; return ;;\n", joined(option.names, "|"), bash_value(option));
    }
    const std::string values =
        cases.empty() ? "" : fmt::format("            case $prev in\n{}            esac\n", cases);
    return fmt::format("        {})\n{}            options={} ;;\n", command.name, values,
                       quoted(joined(option_names(command))));
}

/// A description as _arguments takes it, within brackets within single quotes.
std::string zsh_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result;
}

std::string zsh_value(const OptionInfo& option) {
    const std::string what = ":" + zsh_text(option.placeholder) + ":";
    switch (option.takes) {
        case Takes::nothing:
            return "";
        case Takes::value:
            return what;
        case Takes::words: {
            std::string words;
            for (const std::string& word : option.words) {
                words += (words.empty() ? "" : " ") + zsh_text(word);
            }
            return what + "(" + words + ")";
        }
        case Takes::file:
            return what + "_files";
        case Takes::folder:
            return what + "_files -/";
    }
    return "";
}

std::string zsh_option(const OptionInfo& option) {
    const std::string rest = fmt::format("'[{}]{}'", zsh_text(option.line), zsh_value(option));
    const std::string names =
        option.names.size() == 1 ? option.names.front() : fmt::format("{{{}}}", joined(option.names, ","));
    return fmt::format("                {}{}{} \\\n", option.repeatable ? "'*'" : "", names, rest);
}

std::string fish_option(const std::string& command, const OptionInfo& option) {
    std::string line = fmt::format("complete -c spectralpack -n '__fish_seen_subcommand_from {}'", command);
    for (const std::string& name : option.names) {
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    switch (option.takes) {
        case Takes::nothing:
            break;
        case Takes::value:
            line += " -x";
            break;
        case Takes::words:
            line += " -x -a " + quoted(joined(option.words));
            break;
        case Takes::file:
            line += " -r -F";
            break;
        case Takes::folder:
            line += " -x -a '(__fish_complete_directories)'";
            break;
    }
    std::string text;  // in single quotes of fish, which knows \' there
    for (const char c : option.line) {
        if (c == '\'' || c == '\\') text += '\\';
        text += c;
    }
    return line + " -d '" + text + "'\n";
}

}  // namespace

std::string bash_completion(const std::vector<CommandInfo>& commands) {
    std::string cases;
    for (const CommandInfo& command : commands) {
        cases += command.name == "help" ? fmt::format("        help) {}; return ;;\n", bash_words(topics(commands)))
                                        : bash_command(command);
    }
    std::vector<std::string> first = command_names(commands);
    first.insert(first.end(), {"--help", "--version", "-V"});
    return fmt::format(R"(# Completion of spectralpack for bash.

_spectralpack_paths() {{
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$1" -- "$cur")
}}

_spectralpack() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD - 1]}} options=
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        {}
        return
    fi
    case ${{COMP_WORDS[1]}} in
{}    esac
    if [[ $cur == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
    else
        _spectralpack_paths -f
    fi
}}

complete -F _spectralpack spectralpack
)",
                       bash_words(first), cases);
}

std::string zsh_completion(const std::vector<CommandInfo>& commands) {
    std::string names, cases;
    for (const CommandInfo& command : commands) {
        names += fmt::format("        '{}:{}'\n", command.name, zsh_text(command.line));
        if (command.name == "help") {
            cases += fmt::format("        help) compadd -- {} ;;\n", joined(topics(commands)));
            continue;
        }
        std::string options;
        for (const OptionInfo& option : command.options) {
            options += zsh_option(option);
        }
        cases += fmt::format("        {})\n            _arguments -S \\\n{}                '*:file:_files' ;;\n",
                             command.name, options);
    }
    return fmt::format(R"(#compdef spectralpack
# Completion of spectralpack for zsh.

_spectralpack() {{
    local -a commands=(
{}    )
    if ((CURRENT == 2)); then
        _describe command commands
        return
    fi
    local command=$words[2]
    shift words
    ((CURRENT--))
    case $command in
{}    esac
}}

_spectralpack "$@"
)",
                       names, cases);
}

std::string fish_completion(const std::vector<CommandInfo>& commands) {
    std::string text = "# Completion of spectralpack for fish.\n\n";
    for (const CommandInfo& command : commands) {
        text += fmt::format("complete -c spectralpack -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                            quoted(command.line));
    }
    for (const CommandInfo& command : commands) {
        text += "\n";
        if (command.name == "help") {
            text += fmt::format("complete -c spectralpack -n '__fish_seen_subcommand_from help' -f -a {}\n",
                                quoted(joined(topics(commands))));
            continue;
        }
        for (const OptionInfo& option : command.options) {
            text += fish_option(command.name, option);
        }
    }
    return text;
}

}  // namespace spectralpack::docs
