#include "formats/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "formats/csv.hpp"
#include "formats/xml_text.hpp"
#include "model/part_names.hpp"
#include "spectralpack/names.hpp"

namespace spectralpack {
namespace {

constexpr double kCubicMillimetresPerCubicCentimetre = 1000;

/// What became of the copies of one part.
struct PartOutcome {
    struct LeftOver {
        int copies = 0;
        std::string detail;  ///< of the first copy that has one
    };

    int placed = 0;
    std::map<UnplacedReason, LeftOver> left_over;

    int left_over_count() const {
        int count = 0;
        for (const auto& [reason, some] : left_over) {
            count += some.copies;
        }
        return count;
    }
};

std::vector<PartOutcome> outcomes_of(const Packing& packing) {
    std::vector<PartOutcome> outcomes(packing.parts.size());
    for (const TrayPacking& tray : packing.trays) {
        for (const Placement& placement : tray.placements) {
            ++outcomes.at(static_cast<std::size_t>(placement.part)).placed;
        }
    }
    for (const Unplaced& copy : packing.unplaced) {
        auto& some = outcomes.at(static_cast<std::size_t>(copy.part)).left_over[copy.reason];
        ++some.copies;
        if (some.detail.empty()) some.detail = copy.detail;
    }
    return outcomes;
}

std::string joined(const std::vector<std::string>& texts) {
    std::string line;
    for (const std::string& text : texts) {
        line += (line.empty() ? "" : "; ") + text;
    }
    return line;
}

std::string base64(const std::string& bytes) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (int shift = 18; shift >= 0; shift -= 6) {
            text += kDigits[group >> shift & 63];
        }
    }
    for (std::size_t pad = (3 - bytes.size() % 3) % 3; pad > 0; --pad) {
        text[text.size() - pad] = '=';
    }
    return text;
}

/// The area of each layer as a share of the container's, floor at the bottom.
std::string layer_plot(const TrayPacking& tray, const Container& container) {
    constexpr double kWidth = 360, kHeight = 260;
    const std::vector<double>& area = tray.layers.area;
    if (area.empty()) return "";
    const double full = container.size.x * container.size.y;
    const double bar = kHeight * tray.layers.thickness / container.size.z;
    std::string svg = fmt::format("<svg viewBox=\"-52 -8 {} {}\" role=\"img\"><title>Area of each layer</title>\n",
                                  kWidth + 80, kHeight + 44);
    for (int percent = 0; percent <= 100; percent += 25) {
        const double x = kWidth * percent / 100;
        svg += fmt::format(
            "<line x1=\"{0:.1f}\" y1=\"0\" x2=\"{0:.1f}\" y2=\"{1}\" class=\"grid\"/>"
            "<text x=\"{0:.1f}\" y=\"{2}\" text-anchor=\"middle\">{3} %</text>\n",
            x, kHeight, kHeight + 16, percent);
    }
    for (std::size_t layer = 0; layer < area.size(); ++layer) {
        const double bottom = kHeight - bar * static_cast<double>(layer);
        const double top = std::max(0.0, bottom - bar);  // the last layer may be cut
        svg += fmt::format("<rect x=\"0\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n", top,
                           kWidth * std::clamp(area[layer] / full, 0.0, 1.0), std::max(0.0, bottom - top));
    }
    svg += fmt::format(
        "<text x=\"-6\" y=\"{}\" text-anchor=\"end\">0 mm</text><text x=\"-6\" y=\"8\" "
        "text-anchor=\"end\">{:g}</text>\n",
        kHeight, container.size.z);
    svg += fmt::format(
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">area of the layer ÷ area of the "
        "tray</text></svg>\n",
        kWidth / 2, kHeight + 32);
    return svg;
}

constexpr const char* kStyle = R"(
body { font: 14px/1.45 system-ui, sans-serif; color: #1c2430; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
img { max-width: 100%; border-radius: 6px; }
table { border-collapse: collapse; width: 100%; } th, td { text-align: left; padding: .2rem .6rem .2rem 0; }
th { border-bottom: 1px solid #98a2b3; } td { border-bottom: 1px solid #e4e7ec; vertical-align: top; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
.warn { background: #fff4e5; border-left: 4px solid #d97706; padding: .5rem .8rem; }
.cols { display: flex; gap: 2.5rem; align-items: flex-start; } .cols table, .cols svg { flex: 1; min-width: 0; }
tfoot td { font-weight: 600; border-bottom: 0; } svg rect { fill: #3b6fb6; } svg text { font-size: 11px; fill: #475467; }
svg .grid { stroke: #d0d5dd; stroke-width: 1; }
td { overflow-wrap: anywhere; }
@media (max-width: 40rem) { .cols { display: block; } svg { margin-top: 1rem; } }
@page { margin: 14mm; }
@media print {
  body { font-size: 10.5pt; margin: 0; padding: 0; max-width: none; }
  h2 { break-after: avoid; } tr, img, .cols { break-inside: avoid; } thead { display: table-header-group; }
  img { display: block; max-height: 120mm; margin: 0 auto; }
  .warn, svg rect, img { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

class HtmlReport {
  public:
    HtmlReport(const Packing& packing, const ReportExtras& extras)
        : packing_(packing), extras_(extras), outcomes_(outcomes_of(packing)) {}

    std::string text() {
        const Vec3& size = packing_.container.size;
        add("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
            "<title>Packing report</title><style>{}</style></head><body>\n",
            kStyle);
        add("<h1>{} of {} copies in {:g} × {:g} × {:g} mm</h1>\n", packing_.metrics.placed, packing_.metrics.copies,
            size.x, size.y, size.z);
        interlocking();
        if (packing_.trays.size() > 1) all_trays();
        for (std::size_t i = 0; i < packing_.trays.size(); ++i) {
            tray(i);
        }
        parts();
        left_over();
        add("<p><small>{}, voxels of {:g} mm, gap {:g} mm, engine {}, {:.1f} s. Input "
            "{}.</small></p>\n",
            xml_attribute(packing_.program), packing_.options.voxel, packing_.options.gap,
            xml_attribute(packing_.metrics.engine), packing_.metrics.seconds.total, xml_attribute(packing_.input_hash));
        add("</body></html>\n");
        return std::move(text_);
    }

  private:
    void interlocking() {
        const PlansOverview plans = plans_of(packing_);
        if (plans.complete) {
            add("<p>Comes apart in {} steps; the packing file has the plan.</p>\n", plans.steps);
        } else {
            add("<p class=\"warn\">Interlocking was {} checked: some parts may not come apart after printing.</p>\n",
                plans.planned ? "only partly" : "not");
        }
    }

    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }

    void row(const char* what, const std::string& value) {
        add("<tr><td>{}</td><td class=\"n\">{}</td></tr>\n", what, value);
    }

    void all_trays() {
        add("<h2>Trays</h2>\n<table><thead><tr><th>Tray</th><th class=\"n\">Copies</th>"
            "<th class=\"n\">Density by volume</th><th class=\"n\">Height, mm</th></tr></thead><tbody>\n");
        for (std::size_t i = 0; i < packing_.trays.size(); ++i) {
            const TrayPacking& tray = packing_.trays[i];
            add("<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{:.1f} %</td><td class=\"n\">{:g}</td></tr>\n",
                i + 1, tray.placements.size(), 100 * tray.density, tray.height);
        }
        add("</tbody><tfoot><tr><td>All</td><td class=\"n\">{}</td><td class=\"n\">{:.1f} %</td><td></td></tr>"
            "</tfoot></table>\n",
            packing_.metrics.placed, 100 * packing_.metrics.density);
    }

    void tray(std::size_t index) {
        const TrayPacking& tray = packing_.trays[index];
        const double container = volume_of(packing_.container);
        if (packing_.trays.size() > 1) add("<h2>Tray {}</h2>\n", index + 1);
        if (index < extras_.pictures.size() && !extras_.pictures[index].empty()) {
            add("<img alt=\"The packed tray\" src=\"data:image/png;base64,{}\">\n", base64(extras_.pictures[index]));
        }
        add("<h2>Figures</h2>\n<div class=\"cols\"><table>\n");
        row("Copies", fmt::format("{}", tray.placements.size()));
        row("Density by volume", fmt::format("{:.1f} %", 100 * tray.density));
        row("Density in the packing's own box", fmt::format("{:.1f} %", 100 * tray.density_bounding_box));
        row("Height", fmt::format("{:g} mm", tray.height));
        row("Volume", fmt::format("{:.1f} cm³", tray.density * container / kCubicMillimetresPerCubicCentimetre));
        if (extras_.material_density) {
            row("Mass", fmt::format("{:.1f} g", tray.density * container / kCubicMillimetresPerCubicCentimetre *
                                                    *extras_.material_density));
            row("Density by mass",
                fmt::format("{:.3f} g/cm³ of the container", tray.density * *extras_.material_density));
        }
        add("</table>\n{}</div>\n", layer_plot(tray, packing_.container));
    }

    void parts() {
        const bool masses = extras_.material_density.has_value();
        add("<h2>Parts</h2>\n<table><thead><tr><th>Part</th><th class=\"n\">Copies</th><th "
            "class=\"n\">Placed</th>"
            "<th class=\"n\">Left over</th><th class=\"n\">Volume each, cm³</th>{}<th>Mended on "
            "loading</th></tr>"
            "</thead><tbody>\n",
            masses ? "<th class=\"n\">Mass placed, g</th>" : "");
        std::int64_t copies = 0, placed = 0;
        double mass = 0;
        for (std::size_t i = 0; i < packing_.parts.size(); ++i) {
            const PackedPart& part = packing_.parts[i];
            const double part_mass = outcomes_[i].placed * mass_of_one(part);
            copies += part.count;
            placed += outcomes_[i].placed;
            mass += part_mass;
            add("<tr><td>{}{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
                "class=\"n\">{}</td>"
                "<td class=\"n\">{}</td>{}<td>{}</td></tr>\n",
                xml_attribute(part.name), part.name.ends_with(scale_suffix(part.scale)) ? "" : scale_suffix(part.scale),
                part.count, outcomes_[i].placed, outcomes_[i].left_over_count(),
                part.volume == 0 ? "–" : fmt::format("{:.2f}", part.volume / kCubicMillimetresPerCubicCentimetre),
                mass_cell(part_mass), xml_attribute(joined(part.repairs)));
        }
        add("</tbody><tfoot><tr><td>Together</td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
            "<td class=\"n\">{}</td><td></td>{}<td></td></tr></tfoot></table>\n",
            copies, placed, packing_.unplaced.size(), mass_cell(mass));
    }

    double mass_of_one(const PackedPart& part) const {
        return part.volume / kCubicMillimetresPerCubicCentimetre * extras_.material_density.value_or(0);
    }

    std::string mass_cell(double mass) const {
        return extras_.material_density ? fmt::format("<td class=\"n\">{:.2f}</td>", mass) : "";
    }

    void left_over() {
        if (packing_.unplaced.empty()) return;
        add("<h2>Left over</h2>\n<table><thead><tr><th>Part</th><th "
            "class=\"n\">Copies</th><th>Why</th></tr></thead>"
            "<tbody>\n");
        for (std::size_t i = 0; i < outcomes_.size(); ++i) {
            for (const auto& [reason, some] : outcomes_[i].left_over) {
                add("<tr><td>{}</td><td class=\"n\">{}</td><td>{}{}</td></tr>\n", xml_attribute(packing_.parts[i].name),
                    some.copies, in_words(reason), some.detail.empty() ? "" : ": " + xml_attribute(some.detail));
            }
        }
        add("</tbody></table>\n");
    }

    const Packing& packing_;
    const ReportExtras& extras_;
    std::vector<PartOutcome> outcomes_;
    std::string text_;
};

}  // namespace

std::string report_html(const Packing& packing, const ReportExtras& extras) {
    return HtmlReport(packing, extras).text();
}

std::string report_csv(const Packing& packing, const ReportExtras& extras) {
    const std::vector<PartOutcome> outcomes = outcomes_of(packing);
    std::string text = "part,name,mesh,scale,count,placed,left_over,reasons,volume_mm3,mass_g\r\n";
    for (std::size_t i = 0; i < packing.parts.size(); ++i) {
        const PackedPart& part = packing.parts[i];
        std::string reasons;
        for (const auto& [reason, some] : outcomes[i].left_over) {
            reasons += fmt::format("{}{} {}", reasons.empty() ? "" : "; ", some.copies, to_string(reason));
        }
        const std::string mass =
            extras.material_density
                ? fmt::format("{}", part.volume / kCubicMillimetresPerCubicCentimetre * *extras.material_density)
                : "";
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{}\r\n", i, csv_field(part.name),
                       csv_field(part.mesh), part.scale, part.count, outcomes[i].placed, outcomes[i].left_over_count(),
                       csv_field(reasons), part.volume, mass);
    }
    return text;
}

}  // namespace spectralpack
