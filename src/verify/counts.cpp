#include "verify/counts.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "verify/words.hpp"

namespace spectralpack {
namespace {

bool exists(const Packing& packing, int part, int copy) {
    return part >= 0 && static_cast<std::size_t>(part) < packing.parts.size() && copy >= 0 &&
           copy < packing.parts[static_cast<std::size_t>(part)].count;
}

std::string beyond_count(const Packing& packing, const Placement& placement) {
    const auto part = static_cast<std::size_t>(placement.part);
    if (placement.part < 0 || part >= packing.parts.size()) {
        return copy_name(packing, placement) + " is of no part there is";
    }
    return copy_name(packing, placement) + " is beyond its part's count of " +
           std::to_string(packing.parts[part].count);
}

/// "4, 7 and 12 more"
std::string listed(const std::vector<int>& numbers) {
    constexpr std::size_t kShown = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(numbers.size(), kShown); ++i) {
        text += (i > 0 ? ", " : "") + std::to_string(numbers[i]);
    }
    if (numbers.size() > kShown) text += " and " + std::to_string(numbers.size() - kShown) + " more";
    return text;
}

}  // namespace

std::vector<Finding> count_findings(const Packing& packing) {
    std::vector<Finding> findings;
    struct Place {
        int tray, placement;
    };
    std::map<std::pair<int, int>, Place> placed;
    for (std::size_t t = 0; t < packing.trays.size(); ++t) {
        const auto& placements = packing.trays[t].placements;
        for (std::size_t i = 0; i < placements.size(); ++i) {
            const Placement& placement = placements[i];
            const Place here{static_cast<int>(t), static_cast<int>(i)};
            const auto report = [&](std::vector<int> which, const std::string& message) {
                findings.push_back(
                    {FindingKind::count, here.tray, std::move(which), 0, tray_prefix(packing, here.tray) + message});
            };
            if (!exists(packing, placement.part, placement.copy)) {
                report({here.placement}, beyond_count(packing, placement));
                continue;
            }
            const auto [first, fresh] = placed.try_emplace({placement.part, placement.copy}, here);
            if (fresh) continue;
            const std::string name = copy_name(packing, placement);
            if (first->second.tray == here.tray) {
                report({first->second.placement, here.placement}, name + " is placed twice");
            } else {
                report({here.placement}, name + " is placed in " + tray_name(first->second.tray) + " too");
            }
        }
    }
    const auto report = [&](const std::string& message) {
        findings.push_back({FindingKind::count, kWholePacking, {}, 0, message});
    };
    std::map<std::pair<int, int>, bool> left_over;
    for (const Unplaced& unplaced : packing.unplaced) {
        const Placement copy{unplaced.part, unplaced.copy, 0, false, {}};
        if (!exists(packing, unplaced.part, unplaced.copy)) {
            report(beyond_count(packing, copy) + " (it is listed as left over)");
        } else if (!left_over.try_emplace({unplaced.part, unplaced.copy}, true).second) {
            report(copy_name(packing, copy) + " is listed as left over twice");
        } else if (placed.contains({unplaced.part, unplaced.copy})) {
            report(copy_name(packing, copy) + " is placed, and listed as left over");
        }
    }
    const CopyNumbers numbers(packing.parts);
    for (std::size_t p = 0; p < packing.parts.size(); ++p) {
        std::vector<int> missing;
        for (int copy = 0; copy < packing.parts[p].count; ++copy) {
            const std::pair key(static_cast<int>(p), copy);
            if (!placed.contains(key) && !left_over.contains(key)) missing.push_back(numbers.of(key.first, copy));
        }
        if (missing.empty()) continue;
        report(packing.parts[p].name + " No. " + listed(missing) + (missing.size() == 1 ? " is" : " are") +
               " neither placed nor listed as left over");
    }
    return findings;
}

}  // namespace spectralpack
