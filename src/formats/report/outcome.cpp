#include "formats/report/outcome.hpp"

#include <algorithm>

namespace spectralpack {

int PartOutcome::placed_count() const {
    std::size_t count = 0;
    for (const std::vector<int>& numbers : placed) {
        count += numbers.size();
    }
    return static_cast<int>(count);
}

int PartOutcome::left_over_count() const {
    std::size_t count = 0;
    for (const auto& [reason, some] : left_over) {
        count += some.numbers.size();
    }
    return static_cast<int>(count);
}

std::vector<PartOutcome> outcomes_of(const Packing& packing) {
    const CopyNumbers numbers(packing.parts);
    std::vector<PartOutcome> outcomes(packing.parts.size());
    for (PartOutcome& outcome : outcomes) {
        outcome.placed.resize(packing.trays.size());
    }
    for (std::size_t tray = 0; tray < packing.trays.size(); ++tray) {
        for (const Placement& placement : packing.trays[tray].placements) {
            outcomes.at(static_cast<std::size_t>(placement.part)).placed[tray].push_back(numbers.of(placement));
        }
    }
    for (const Unplaced& copy : packing.unplaced) {
        auto& some = outcomes.at(static_cast<std::size_t>(copy.part)).left_over[copy.reason];
        some.numbers.push_back(numbers.of(copy.part, copy.copy));
        if (some.detail.empty()) some.detail = copy.detail;
    }
    for (PartOutcome& outcome : outcomes) {
        for (std::vector<int>& placed : outcome.placed) {
            std::sort(placed.begin(), placed.end());
        }
        for (auto& [reason, some] : outcome.left_over) {
            std::sort(some.numbers.begin(), some.numbers.end());
        }
    }
    return outcomes;
}

std::string runs_of(const std::vector<int>& numbers, const char* dash) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
            ++last;
        }
        if (last == i + 1) last = i;  // two are no run
        if (!text.empty()) text += ", ";
        text += std::to_string(numbers[i]);
        if (last > i) text += dash + std::to_string(numbers[last]);
        i = last + 1;
    }
    return text;
}

}  // namespace spectralpack
