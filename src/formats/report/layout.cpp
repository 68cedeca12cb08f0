#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "formats/report/outcome.hpp"
#include "formats/report/pages.hpp"
#include "formats/report/report.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kFewParts = 8;                             // so many fit the cover
constexpr std::size_t kMostListed = 40;                          // of a longer list each tray has its own parts only
constexpr double kCoverHeight = 197;                             // for picture, left over and a short list
constexpr double kHero = 150, kShortHero = 75, kLeastHero = 55;  // so high the picture stays beside what is left over
constexpr double kMarksRoom = 14;                                // below the tray in the picture, for bar and names
constexpr double kTallestStage = 50;
constexpr double kNarrowMap = 70.5, kWideMap = 148,
                 kTallest = 105;        // of the tray's floor in print, two or one in a row
constexpr double kSmallTray = 230;      // mm: larger ones need the page's width
constexpr std::size_t kFewCopies = 24;  // in a slab: these can be numbered in a small view

/// How high the tray stands in a picture of this width, as the camera of the cover sees it.
double needed_height(const Vec3& size, double width) {
    const double a = kHeroAzimuth * std::numbers::pi / 180, e = kHeroElevation * std::numbers::pi / 180;
    const double across = size.x * std::cos(a) + size.y * std::sin(a);
    const double upright = (size.x * std::sin(a) + size.y * std::cos(a)) * std::sin(e) + size.z * std::cos(e);
    return width * upright / across;
}

class LayoutMaker {
  public:
    LayoutMaker(const Packing& packing, const std::vector<std::vector<Box>>& boxes)
        : packing_(packing), boxes_(boxes), outcomes_(outcomes_of(packing)) {}

    TrayLayout make(std::size_t tray) const {
        TrayLayout layout;
        layout.slabs = slabs_of(boxes_[tray]);
        std::size_t parts = 0;
        for (const PartOutcome& outcome : outcomes_) {
            parts += outcome.placed[tray].empty() ? 0 : 1;
        }
        layout.full = parts > kFewParts;
        const bool all_parts = layout.full && tray == 0 && packing_.parts.size() <= kMostListed;
        for (std::size_t i = 0; i < outcomes_.size(); ++i) {
            if (all_parts || !outcomes_[i].placed[tray].empty()) layout.listed.push_back(static_cast<int>(i));
        }
        if (layout.full) layout.stages = stages_of(packing_.trays[tray]);

        const Vec3& size = packing_.container.size;
        layout.stage_height = std::min(kTallestStage, needed_height(size, kStageWidth));
        double height = kCoverHeight;
        if (!layout.full) height -= part_table_height(packing_, outcomes_, layout, tray);
        const double wanted = std::max(kLeastHero, needed_height(size, kHeroWidth) + kMarksRoom);
        if (tray == 0) {
            layout.left_over_rows =
                left_over_rows(outcomes_, height - std::min(wanted, layout.full ? kHero : kShortHero));
            height -= left_over_height(outcomes_, layout.left_over_rows);
        }
        layout.hero_height = std::clamp(wanted, kLeastHero, std::max(kLeastHero, height));

        std::size_t most = 0;
        for (const Slab& slab : layout.slabs) {
            most = std::max(most, slab.placements.size());
        }
        layout.map_columns = std::max(size.x, size.y) <= kSmallTray || most <= kFewCopies ? 2 : 1;
        layout.map_width = std::min(layout.map_columns == 2 ? kNarrowMap : kWideMap,
                                    kTallest * (3 - layout.map_columns) * size.x / size.y);
        return layout;
    }

  private:
    const Packing& packing_;
    const std::vector<std::vector<Box>>& boxes_;
    std::vector<PartOutcome> outcomes_;
};

}  // namespace

std::vector<int> stages_of(const TrayPacking& tray) {
    if (!tray.disassembly) return {};
    const std::vector<RemovalStep>& steps = tray.disassembly->steps;
    const auto count = static_cast<int>(steps.size());
    constexpr std::size_t kStages = 4, kLargeGroup = 5;
    std::set<int> chosen;
    std::size_t largest = kLargeGroup - 1;
    for (int i = 0; i < count; ++i) {
        const std::size_t size = steps[static_cast<std::size_t>(i)].placements.size();
        if (size <= largest) continue;
        largest = size;
        chosen = {i + 1};
        if (i > 0) chosen.insert(i);
    }
    for (const int percent : {35, 60, 80, 20, 50}) {
        if (chosen.size() == kStages) break;
        const int step = count * percent / 100;
        const bool new_one =
            std::none_of(chosen.begin(), chosen.end(), [&](int other) { return std::abs(other - step) <= count / 20; });
        if (step > 0 && step < count && new_one) chosen.insert(step);
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<bool> left_after(const TrayPacking& tray, int step) {
    std::vector<bool> left(tray.placements.size(), true);
    for (int i = 0; i < step; ++i) {
        for (const int placement : tray.disassembly->steps[static_cast<std::size_t>(i)].placements) {
            left[static_cast<std::size_t>(placement)] = false;
        }
    }
    return left;
}

std::vector<TrayLayout> sheet_layout(const Packing& packing, const std::vector<std::vector<Box>>& boxes) {
    const LayoutMaker maker(packing, boxes);
    std::vector<TrayLayout> layouts;
    for (std::size_t tray = 0; tray < packing.trays.size(); ++tray) {
        layouts.push_back(maker.make(tray));
    }
    return layouts;
}

}  // namespace spectralpack
