#pragma once
/// The commands with their options, as the command line itself names them; what is known of values comes from the
/// option table, by the options' names.

#include <string>
#include <vector>

#include <spectralpack/option_table.hpp>

namespace CLI {
class App;
}

namespace spectralpack::docs {

enum class Takes {
    nothing,
    value,  ///< that nobody can guess
    words,  ///< one of `words`, or another
    file,
    folder,
};

struct OptionInfo {
    std::vector<std::string> names;  ///< with dashes: {"-o", "--output"}
    std::string placeholder, line;
    Takes takes = Takes::nothing;
    std::vector<std::string> words;
    bool repeatable = false;
    const Option* entry = nullptr;  ///< of pack's; null for those of other commands
};

struct CommandInfo {
    std::string name, line, footer;
    std::vector<std::string> arguments;  ///< without dashes: "PACKING"
    std::vector<OptionInfo> options;
};

/// In the application's order.
std::vector<CommandInfo> commands_of(const CLI::App& app);

}  // namespace spectralpack::docs
