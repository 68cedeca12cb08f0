#pragma once
/// Values of options as a job file holds them.

#include <string>

#include <spectralpack/option_table.hpp>

namespace spectralpack::docs {

/// JSON text.
std::string json_of(const Option& option, const OptionValue& value);

/// Values worth showing: the entry's examples; of a flag, the value that it has not by default.
std::vector<OptionValue> examples_of(const Option& option);

}  // namespace spectralpack::docs
