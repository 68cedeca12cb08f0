#include "help_page.hpp"

#include <fmt/format.h>

#include <sstream>

#include "text.hpp"

#include <spectralpack/option_table.hpp>

namespace spectralpack::cli {
namespace {

constexpr std::size_t kHeading = 9, kCall = 22;

std::string call_of(const Option& option) {
    const std::string letter = option.letter ? fmt::format("-{}, ", option.letter) : "";
    const std::string call = fmt::format("{}--{}", letter, option.name);
    return option.placeholder.empty() ? call : fmt::format("{} {}", call, option.placeholder);
}

/// Option and meaning in two columns; a call too long for its own stands above the meaning.
std::string entry_of(const std::string& heading, const std::string& call, const std::string& meaning) {
    const std::size_t indent = kHeading + kCall;
    std::string text = fmt::format("{:<{}}{:<{}}", heading, kHeading, call, kCall);
    bool beside = call.size() < kCall;
    std::istringstream rest(wrapped(meaning, kScreenWidth - indent));
    for (std::string line; std::getline(rest, line);) {
        if (!beside) text += fmt::format("\n{:<{}}", "", indent);
        text += line;
        beside = false;
    }
    return text + "\n";
}

std::string meaning_of(const Option& option) {
    const std::string by_default = short_default_text(option);
    return by_default.empty() ? std::string(option.line) : fmt::format("{} [{}]", option.line, by_default);
}

std::string options_text(bool all) {
    std::string text;
    for (const OptionGroup group : kOptionGroups) {
        std::string heading(title_of(group));
        for (const Option* option : options_under(group)) {
            if (!all && option->help_place == 0) continue;
            text += entry_of(heading, call_of(*option), meaning_of(*option));
            heading.clear();
            if (!all || option->off_line.empty()) continue;
            text += entry_of("", fmt::format("--no-{}", option->name), std::string(option->off_line));
        }
    }
    return text;
}

}  // namespace

std::string pack_help_head() {
    return "Packs parts into a tray, without collisions and so that they come apart.\n"
           "\n"
           "  spectralpack pack parts/ --printer formlabs-fuse1 -o build.3mf\n"
           "  spectralpack pack bracket.stl:12 cup.stl@1.02 --tray 160x120x100 -o build.3mf\n"
           "  spectralpack pack week48.csv --trays all -o week48.3mf --report week48.html\n"
           "\n"
           "PART: a mesh (.stl .3mf .obj .ply .off .binvox), FILE:COUNT, FILE@SCALE,\n"
           "      a folder, a set file (.csv) or a job file (.json)\n"
           "\n";
}

std::string pack_help_foot() {
    return "Exit: 0 done, 2 wrong usage, 3 a bad file, 4 no memory or disk,\n"
           "5 left over with --require-all, 6 nothing placed, 130 interrupted.\n";
}

std::string PackHelp::make_help(const CLI::App*, std::string, CLI::AppFormatMode mode) const {
    const bool all = mode == CLI::AppFormatMode::All;
    const char* more = all ? "'spectralpack help OPTION' explains an option, docs/cli.md all of them.\n"
                           : "--help-all shows all options, 'spectralpack help OPTION' explains one.\n";
    return fmt::format("{}{}\n{}{}", pack_help_head(), options_text(all), more, pack_help_foot());
}

}  // namespace spectralpack::cli
