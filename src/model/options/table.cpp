#include <algorithm>

#include "model/options/entries.hpp"

namespace spectralpack {
namespace {

/// In the order of packing files.
std::vector<Option> all_options() {
    std::vector<Option> all;
    for (const auto& entries :
         {output_options(), input_options(), container_options(), grid_options(), gap_options(), placing_options(),
          filling_options(), order_options(), run_options(), program_options()}) {
        all.insert(all.end(), entries.begin(), entries.end());
    }
    return all;
}

}  // namespace

std::span<const Option> option_table() {
    static const std::vector<Option> table = all_options();
    return table;
}

const Option* find_option(std::string_view name) {
    const auto found = std::ranges::find(option_table(), name, &Option::name);
    return found == option_table().end() ? nullptr : &*found;
}

std::vector<const Option*> options_under(OptionGroup group) {
    std::vector<const Option*> options;
    for (const Option& option : option_table()) {
        if (option.group == group) options.push_back(&option);
    }
    std::ranges::stable_sort(options, {}, [](const Option* option) {
        return option->help_place > 0 ? option->help_place : std::numeric_limits<int>::max();
    });
    return options;
}

std::string_view title_of(OptionGroup group) {
    switch (group) {
        case OptionGroup::parts:
            return "Parts";
        case OptionGroup::tray:
            return "Tray";
        case OptionGroup::gap:
            return "Gap";
        case OptionGroup::packing:
            return "Packing";
        case OptionGroup::result:
            return "Result";
    }
    return "";
}

}  // namespace spectralpack
