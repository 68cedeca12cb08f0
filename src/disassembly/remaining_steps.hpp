#pragma once
/// A disassembly plan of some of the copies that it was made for.

#include <cstddef>
#include <vector>

#include "spectralpack/disassembly.hpp"

namespace spectralpack {

/// The steps without the copies that are not there any more, `renumbered` to -1. Groups that are one copy then, or all
/// that is left of their subassembly, are groups no more: a copy's first step alone is its own. `fixed` more copies
/// stand with all, and never leave.
std::vector<RemovalStep> remaining_steps(const std::vector<RemovalStep>& steps, const std::vector<int>& renumbered,
                                         std::size_t fixed);

}  // namespace spectralpack
