#pragma once
/// Reports of a packing for people: a page that prints well, and a table for spreadsheets.

#include <optional>
#include <string>
#include <vector>

#include "spectralpack/packing.hpp"

namespace spectralpack {

struct ReportExtras {
    std::vector<std::string> pictures;       ///< PNG bytes, by tray; fewer or empty ones: no picture
    std::optional<double> material_density;  ///< g/cm^3: adds masses
};

/// One self-contained page: per tray its picture, figures and the area of each layer as a plot; the parts with what was
/// placed of each; what was left over and why. Density by mass is that of the material spread over the container.
std::string report_html(const Packing& packing, const ReportExtras& extras);

/// One row per part: part,name,mesh,scale,count,placed,left_over,reasons,volume_mm3,mass_g.
std::string report_csv(const Packing& packing, const ReportExtras& extras);

}  // namespace spectralpack
