#pragma once
/// A plan as people follow it: in the order in which one unpacks, by ways with few moves. What comes apart by the plan
/// given, comes apart by the one that is made of it.

#include <optional>
#include <vector>

#include "disassembly/disassembler.hpp"

namespace spectralpack {

struct Unpacking {
    Unpack unpack = Unpack::any;
    /// The walls among the bodies that are there for Unpack::top alone, and give way.
    std::optional<std::size_t> walls = {};
    Disassembler::Left left = [](int, int) {};  ///< told while planning
};

/// Of `bodies`, named by their index, which stand together and come apart by `plan`; walls that give way are not in it.
/// With Unpack::top they are planned anew by that rule, and what has no way out then goes by `plan`. Where it was
/// stopped meanwhile, or `plan` is not complete, the order is that of `plan`. `counts` gets the ways that were found.
Disassembly unpacked(const DisassemblyOptions& options, const std::vector<Body>& bodies, const Unpacking& unpacking,
                     Disassembly plan, InterlockCounts& counts);

}  // namespace spectralpack
