#include "disassembly/disassembler.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "disassembly/dismantler.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {

Disassembler::Disassembler(const DisassemblyOptions& options, std::vector<Body> parts, Left left, const Rules& rules)
    : options_(options), left_(std::move(left)), rules_(rules) {
    std::vector<int> names(parts.size());
    std::iota(names.begin(), names.end(), 0);
    dismantlers_.emplace_back(*this, std::move(names), std::move(parts), rules.unpack);
    all_ = standing_ = static_cast<int>(dismantlers_.front().subassembly().movable().size());
}

Disassembler::~Disassembler() = default;

void Disassembler::run() {
    // Dismantlers that are founded meanwhile run at once, where their founder's steps are at.
    std::vector<Dismantler*> dismantlers;
    for (Dismantler& dismantler : dismantlers_) {
        dismantlers.push_back(&dismantler);
    }
    for (Dismantler* dismantler : dismantlers) {
        dismantler->run();
    }
}

std::vector<std::vector<int>> Disassembler::stuck() const {
    std::vector<std::vector<int>> sets;
    for (const Dismantler& dismantler : dismantlers_) {
        const Subassembly& subassembly = dismantler.subassembly();
        if (subassembly.movable().empty()) continue;
        std::vector<int> names;
        for (std::size_t i = 0; i < subassembly.size(); ++i) {
            if (subassembly.present(i)) names.push_back(subassembly.name(i));
        }
        std::sort(names.begin(), names.end());
        sets.push_back(std::move(names));
    }
    return sets;
}

void Disassembler::discard(int part) {
    for (Dismantler& dismantler : dismantlers_) {
        if (dismantler.discard(part)) {
            --standing_;
            return;
        }
    }
    throw InternalError("disassembly: a copy was discarded that does not stand");
}

}  // namespace spectralpack
