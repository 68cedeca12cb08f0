#include "disassembly/unpacking.hpp"

#include <utility>

#include "disassembly/smoothing.hpp"

namespace spectralpack {

Disassembly unpacked(const DisassemblyOptions& options, const std::vector<Body>& bodies, const Unpacking& unpacking,
                     Disassembly plan, InterlockCounts& counts) {
    if (unpacking.unpack == Unpack::top && plan.complete && !options.stop.stopped()) {
        Disassembler disassembler(options, bodies, unpacking.left,
                                  {.told = &plan.steps, .unpack = Unpack::top, .walls = unpacking.walls});
        disassembler.run();
        counts.fills += disassembler.counts().fills;
        if (disassembler.standing() == 0) {
            plan.steps = disassembler.steps();
            plan.through_walls = disassembler.through_walls();
            plan.unpack = Unpack::top;
            counts.straight = disassembler.counts().straight;
            counts.flooded = disassembler.counts().flooded;
            counts.groups = disassembler.counts().groups;
        }
    }
    smooth(options, bodies, unpacking.walls, plan);
    return plan;
}

}  // namespace spectralpack
