#include "packing/improve/layout_value.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace spectralpack {
namespace {

constexpr double kUpperPart = 0.8;  // of the height: what reaches beyond it keeps the layout from coming lower

}  // namespace

LayoutJudge::LayoutJudge(const std::vector<Copy>& copies, Measures measures) : measures_(std::move(measures)) {
    for (const Copy& copy : copies) {
        ++counts_[copy.part];
    }
}

LayoutValue LayoutJudge::value(const std::vector<PackedStep>& steps) const {
    std::vector<double> tops;
    for (const PackedStep& step : steps) {
        if (step.placed) tops.push_back(measures_.top(*step.placed));
    }
    LayoutValue value{missing(steps), 0, 0};
    if (tops.empty()) return value;
    const double height = std::ranges::max(tops);
    value.top = layers(height);
    for (const double top : tops) {
        value.crowd += std::max(0.0, top - kUpperPart * height);
    }
    return value;
}

bool LayoutJudge::exceeds(const std::vector<PackedStep>& steps, const LayoutValue& limit) const {
    const PackedStep& last = steps.back();
    if (last.placed) return limit.missing == 0 && layers(measures_.top(*last.placed)) > limit.top;
    return missing(steps) > limit.missing;
}

/// Of a part that found no place, all copies but those that had found one before.
double LayoutJudge::missing(const std::vector<PackedStep>& steps) const {
    std::map<int, int> placed;
    std::set<int> failed;
    for (const PackedStep& step : steps) {
        if (step.placed) {
            ++placed[step.copy.part];
        } else {
            failed.insert(step.copy.part);
        }
    }
    double missing = 0;
    for (const int part : failed) {
        missing += (counts_.at(part) - placed[part]) * measures_.worth(part);
    }
    return missing;
}

std::int64_t LayoutJudge::layers(double top) const {
    constexpr double kRounding = 1e-6;
    return static_cast<std::int64_t>(std::ceil((top - measures_.wall_gap) / measures_.voxel_size - kRounding));
}

}  // namespace spectralpack
