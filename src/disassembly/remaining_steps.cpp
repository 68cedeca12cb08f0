#include "disassembly/remaining_steps.hpp"

#include <utility>

namespace spectralpack {

std::vector<RemovalStep> remaining_steps(const std::vector<RemovalStep>& steps, const std::vector<int>& renumbered,
                                         std::size_t fixed) {
    constexpr int kOut = -1;
    std::vector<int> subassembly(renumbered.size(), kOut);
    std::vector<std::size_t> standing(1, fixed);  // by subassembly
    for (std::size_t i = 0; i < renumbered.size(); ++i) {
        if (renumbered[i] < 0) continue;
        subassembly[i] = 0;
        ++standing[0];
    }
    std::vector<RemovalStep> result;
    for (const RemovalStep& step : steps) {
        std::vector<std::size_t> members;
        RemovalStep rest{{}, step.path};
        for (const int i : step.placements) {
            if (subassembly[static_cast<std::size_t>(i)] == kOut) continue;
            members.push_back(static_cast<std::size_t>(i));
            rest.placements.push_back(renumbered[static_cast<std::size_t>(i)]);
        }
        if (members.empty()) continue;
        const auto from = static_cast<std::size_t>(subassembly[members.front()]);
        if (members.size() > 1 && members.size() == standing[from]) continue;
        int to = kOut;
        if (members.size() > 1) {
            to = static_cast<int>(standing.size());
            standing.push_back(members.size());
        }
        standing[from] -= members.size();
        for (const std::size_t i : members) {
            subassembly[i] = to;
        }
        if (standing[from] == 0) rest.path.clear();
        result.push_back(std::move(rest));
    }
    return result;
}

}  // namespace spectralpack
