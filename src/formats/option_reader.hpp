#pragma once
/// The options of `pack` as packing files and job files hold them.

#include "formats/json_node.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack {

/// What the option accepts; of anything else it complains.
OptionValue read_value(const Node& node, const Option& option);

/// Sets what the object names of the options that PackOptions hold; null counts as missing. Keys it does not know are
/// the caller's.
void read_options(const Node& node, PackOptions& options);

}  // namespace spectralpack
