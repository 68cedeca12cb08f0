#pragma once
/// Files that cannot be used, as people are told of them.

#include <string>
#include <vector>

#include <spectralpack/error.hpp>

namespace spectralpack::cli {

/// "2 files cannot be used and are left out:", and a line for each: its name, the place in it and the cause. The folder
/// stands only where two of them have one name.
std::vector<std::string> unusable_lines(const std::vector<InputError>& errors);

}  // namespace spectralpack::cli
