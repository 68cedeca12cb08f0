#pragma once
/// The plan of a finished tray as people follow it (disassembly/unpacking.hpp).

#include <vector>

#include "disassembly/unpacking.hpp"
#include "packing/interlocking/placed_bodies.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

struct FinalPlanOptions : BodyOptions {
    const Container& container;  ///< whose walls and keep-outs are there for Unpack::top, physical or not
    Unpack unpack = Unpack::any;
    Disassembler::Left left;  ///< told while planning
};

/// `plan` is one of `placed`, by index, which `tray` holds.
Disassembly final_plan(const FinalPlanOptions& options, const Tray& tray, const std::vector<PlacedCopy>& placed,
                       const TrayContext& context, Disassembly plan, InterlockCounts& counts);

}  // namespace spectralpack
