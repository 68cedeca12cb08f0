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

std::string_view title_of(OptionGroup group) {
    switch (group) {
        case OptionGroup::output:
            return "Output";
        case OptionGroup::container:
            return "Container";
        case OptionGroup::input:
            return "Input";
        case OptionGroup::search:
            return "Search";
        case OptionGroup::run:
            return "Run";
    }
    return "";
}

}  // namespace spectralpack
