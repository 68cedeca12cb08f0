#include <fmt/format.h>

#include <iterator>

#include "formats/csv.hpp"
#include "formats/report/outcome.hpp"
#include "formats/report/report.hpp"
#include "spectralpack/names.hpp"

namespace spectralpack {

std::string report_csv(const Packing& packing, std::optional<double> material_density) {
    constexpr double kCubicMillimetresPerCubicCentimetre = 1000;
    const std::vector<PartOutcome> outcomes = outcomes_of(packing);
    const CopyNumbers numbers(packing.parts);
    std::string text = "part,name,mesh,scale,count,placed,left_over,reasons,volume_mm3,mass_g,numbers\r\n";
    for (std::size_t i = 0; i < packing.parts.size(); ++i) {
        const PackedPart& part = packing.parts[i];
        std::string reasons;
        for (const auto& [reason, some] : outcomes[i].left_over) {
            reasons += fmt::format("{}{} {}", reasons.empty() ? "" : "; ", some.numbers.size(), to_string(reason));
        }
        const std::string mass =
            material_density ? fmt::format("{}", part.volume / kCubicMillimetresPerCubicCentimetre * *material_density)
                             : "";
        const int first = numbers.of(static_cast<int>(i), 0), last = first + part.count - 1;
        const std::string range = last > first ? fmt::format("{} to {}", first, last) : fmt::format("{}", first);
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}\r\n", i, csv_field(part.name),
                       csv_field(part.mesh), part.scale, part.count, outcomes[i].placed_count(),
                       outcomes[i].left_over_count(), csv_field(reasons), part.volume, mass,
                       part.count > 0 ? range : "");
    }
    return text;
}

}  // namespace spectralpack
