#include "verify/figures.hpp"

#include <algorithm>
#include <cmath>

#include "verify/words.hpp"

namespace spectralpack {
namespace {

bool differs(double stated, double measured, double tolerance) {
    return !(std::abs(stated - measured) <= tolerance);  // a NaN differs
}

/// Of a tray's container; with open height it ends where the tray's copies do.
double container_volume(const Packing& packing, const Box& copies) {
    const auto& mesh = packing.container.mesh;
    if (mesh && mesh->surface) return signed_volume(*mesh->surface);
    const Vec3& size = packing.container.size;
    const bool reached = packing.container.open_height && !copies.empty();
    return size.x * size.y * (reached ? copies.max.z : size.z);
}

/// Greatest difference of two boxes' coordinates; 0 for two empty ones.
double difference(const Box& a, const Box& b) {
    if (a.empty() || b.empty()) return a.empty() == b.empty() ? 0 : Box::kInfinity;
    double worst = 0;
    for (int axis = 0; axis < 3; ++axis) {
        worst = std::max({worst, std::abs(a.min[axis] - b.min[axis]), std::abs(a.max[axis] - b.max[axis])});
    }
    return worst;
}

std::string range_text(const Box& box) {
    if (box.empty()) return "nothing";
    const auto point = [](const Vec3& p) {
        return "(" + short_number(p.x) + ", " + short_number(p.y) + ", " + short_number(p.z) + ")";
    };
    return point(box.min) + " to " + point(box.max);
}

}  // namespace

double measured_density(const Packing& packing, const TrayMeasure& tray) {
    const double volume = container_volume(packing, tray.box);
    return volume > 0 ? tray.volume / volume : 0;
}

std::vector<Finding> figure_findings(const Packing& packing, const std::vector<TrayMeasure>& trays,
                                     std::optional<double> min_gap) {
    std::vector<Finding> findings;
    const auto compare = [&](int tray, const std::string& what, double stated, double measured, double tolerance,
                             const std::string& unit) {
        if (!differs(stated, measured, tolerance)) return;
        const std::string whose = tray == kWholePacking ? "the packing" : tray_name(tray);
        findings.push_back({FindingKind::density,
                            tray,
                            {},
                            std::abs(stated - measured),
                            whose + " states a " + what + " of " + short_number(stated) + unit + "; measured " +
                                short_number(measured) + unit});
    };
    const auto compare_density = [&](int tray, const std::string& what, double stated, double measured) {
        compare(tray, what, stated, measured, kDensityTolerance * std::abs(measured) + 1e-12, "");
    };
    double volume = 0, all = 0;
    for (std::size_t t = 0; t < trays.size(); ++t) {
        const TrayPacking& stated = packing.trays[t];
        const Box& box = trays[t].box;
        const int tray = static_cast<int>(t);
        volume += trays[t].volume;
        all += container_volume(packing, box);
        compare_density(tray, "share filled", stated.density, measured_density(packing, trays[t]));
        compare_density(tray, "share filled of its bounding box", stated.density_bounding_box,
                        box.volume() > 0 ? trays[t].volume / box.volume() : 0);
        const double off = difference(stated.bounding_box, box);
        if (differs(off, 0, kCheckTolerance)) {
            findings.push_back({FindingKind::density,
                                tray,
                                {},
                                off,
                                tray_name(tray) + " states a bounding box of " + range_text(stated.bounding_box) +
                                    "; measured " + range_text(box)});
        }
        compare(tray, "height", stated.height, box.empty() ? 0 : box.max.z, kCheckTolerance, " mm");
    }
    if (packing.container.open_height && trays.size() == 1 && !trays.front().box.empty()) {
        compare(kWholePacking, "height of the tray", packing.container.size.z, trays.front().box.max.z, kCheckTolerance,
                " mm");
    }
    compare_density(kWholePacking, "share filled", packing.metrics.density, all > 0 ? volume / all : 0);
    if (packing.metrics.min_gap && min_gap) {
        compare(kWholePacking, "least distance of two copies", *packing.metrics.min_gap, *min_gap, kCheckTolerance,
                " mm");
    }
    return findings;
}

}  // namespace spectralpack
