#pragma once
/// The options of `pack` as packing files and job files hold them.

#include "formats/json_node.hpp"
#include "spectralpack/options.hpp"

namespace spectralpack {

/// Sets what the object names, by the options' names on the command line; null counts as missing.
/// Keys it does not know are the caller's.
void read_options(const Node& node, PackOptions& o);

/// A number of trays, or "all": 0.
int trays_of(const Node& node);

}  // namespace spectralpack
