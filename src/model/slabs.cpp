#include "model/slabs.hpp"

#include <algorithm>
#include <cmath>

namespace spectralpack {
namespace {

constexpr double kThickness = 50, kCutOn = 5;  // mm
constexpr int kMostSlabs = 6;

/// Heights to cut at, from the top down.
std::vector<double> cuts_below(double top) {
    const int count = std::clamp(static_cast<int>(std::lround(top / kThickness)), 1, kMostSlabs);
    std::vector<double> cuts;
    for (int i = 1; i < count; ++i) {
        const double cut = kCutOn * std::round((top - i * top / count) / kCutOn);
        if (cut > 0 && cut < top && (cuts.empty() || cut < cuts.back())) cuts.push_back(cut);
    }
    return cuts;
}

}  // namespace

std::vector<Slab> slabs_of(const std::vector<Box>& boxes) {
    if (boxes.empty()) return {};
    double top = 0;
    for (const Box& box : boxes) {
        top = std::max(top, box.max.z);
    }
    const std::vector<double> cuts = cuts_below(top);
    std::vector<Slab> all(cuts.size() + 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].high = i == 0 ? top : cuts[i - 1];
        all[i].low = i < cuts.size() ? cuts[i] : 0;
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double middle = (boxes[i].min.z + boxes[i].max.z) / 2;
        const auto at = std::find_if(all.begin(), all.end() - 1, [&](const Slab& slab) { return middle >= slab.low; });
        at->placements.push_back(static_cast<int>(i));
    }
    std::vector<Slab> slabs;
    double high = top;
    for (Slab& slab : all) {
        if (slab.placements.empty()) continue;
        slab.high = high;
        high = slab.low;
        slabs.push_back(std::move(slab));
    }
    slabs.back().low = 0;
    return slabs;
}

std::string slab_name(std::size_t slab) { return std::string(1, static_cast<char>('A' + slab)); }

}  // namespace spectralpack
