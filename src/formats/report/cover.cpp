#include <algorithm>

#include "formats/report/pages.hpp"
#include "formats/report/picture_svg.hpp"

namespace spectralpack {
namespace {

constexpr double kPlotMargin = 20;  // of the layers' column: heading and the line below

/// "12, 40 and 3 more": numbers of copies.
std::string some_of(const SheetInput& sheet, const TrayPacking& tray, const std::vector<int>& placements) {
    constexpr std::size_t kMostNamed = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(placements.size(), kMostNamed); ++i) {
        const bool last = i + 1 == placements.size();
        text += i == 0 ? "" : last ? " and " : ", ";
        text += std::to_string(sheet.numbers.of(tray.placements[static_cast<std::size_t>(placements[i])]));
    }
    if (placements.size() > kMostNamed) text += fmt::format(" and {} more", placements.size() - kMostNamed);
    return text;
}

/// As the terminal says it; nothing where all leaves over the top.
std::string through_walls_words(const Disassembly& plan) {
    if (plan.through_walls.empty()) return "";
    return fmt::format("; {} of them sideways through the walls", plan.through_walls.size());
}

struct Verdict {
    const char* kind;  ///< style
    const char* icon;  ///< path
    std::string text;
};

Verdict verdict_of(const SheetInput& sheet, std::size_t index) {
    constexpr const char *kTick = "M3 8.5l3.2 3.2L13 4.8", *kCall = "M8 3v6M8 12.4v.2", *kCross = "M4 4l8 8M12 4l-8 8";
    const TrayPacking& tray = sheet.packing.trays[index];
    const std::optional<double>& gap = sheet.packing.metrics.min_gap;
    const std::string least =
        gap ? fmt::format("<span>Least gap {}.</span> ", with_unit(*gap, 2, "mm")) : std::string();
    if (!tray.disassembly) {
        return {"warn", kCall, "<b>Not checked whether it comes apart.</b> " + least};
    }
    const Disassembly& plan = *tray.disassembly;
    const std::size_t stay = staying(tray).size();
    if (plan.complete && stay > 0) {
        return {
            "warn", kCall,
            fmt::format(
                "<b>Checked on the exact meshes, new copies alone.</b> {}<span>They come apart in {}{}. {} that stood "
                "there before {}: not part of the removal order.</span>",
                least, counted(plan.steps.size(), "step"), through_walls_words(plan),
                stay == 1 ? "1 copy" : fmt::format("{} copies", stay), stay == 1 ? "stays" : "stay")};
    }
    if (plan.complete) {
        return {"good", kTick,
                fmt::format("<b>Checked on the exact meshes.</b> {}<span>Comes apart in {}{}.</span>", least,
                            counted(plan.steps.size(), "step"), through_walls_words(plan))};
    }
    if (plan.interlocked.empty())
        return {"warn", kCall, "<b>Not checked to the end whether it comes apart.</b> " + least};
    return {"bad", kCross,
            fmt::format("<b>Does not come apart:</b> <span>{} hold each other.</span>",
                        some_of(sheet, tray, plan.interlocked.front()))};
}

class Cover {
  public:
    Cover(const SheetInput& sheet, std::size_t tray)
        : sheet_(sheet), contents_(sheet.contents), packing_(sheet.packing), tray_(tray) {}

    std::string page(const std::string& list, const std::string& pages) {
        html_.add("<header class=\"title\"><div><h1>{}</h1><p>Operator’s sheet · {}</p></div>",
                  escaped(contents_.job_name), escaped(packing_.program));
        html_.add("<div class=\"trayno\">Tray <b>{}</b> of {}</div><div class=\"pg\">{}</div></header>\n", tray_ + 1,
                  packing_.trays.size(), pages);
        meta();
        figures();
        const Verdict verdict = verdict_of(sheet_, tray_);
        html_.add("<p class=\"verdict {}\"><svg viewBox=\"0 0 16 16\" class=\"ok\"><path d=\"{}\"/></svg>{}</p>\n",
                  verdict.kind, verdict.icon, verdict.text);
        hero();
        html_.add("{}", list);
        if (tray_ == 0) html_.add("{}", left_over_table(sheet_));
        html_.add(
            "<section class=\"sign\"><div>Started<i></i></div><div>Finished<i></i></div><div>Unpacked by<i></i></div>"
            "<div>Missing or broken, No.<i></i></div></section>\n");
        return html_.take();
    }

  private:
    const TrayLayout& layout() const { return contents_.layout[tray_]; }
    const TrayPacking& tray() const { return packing_.trays[tray_]; }

    void cell(const char* name, const std::string& value) {
        if (!value.empty()) html_.add("<div><dt>{}</dt><dd>{}</dd></div>", name, value);
    }

    void meta() {
        html_.add("<dl class=\"meta\">");
        cell("Date", escaped(contents_.date));
        cell("Printer", escaped(contents_.printer));
        std::string material = escaped(contents_.material);
        if (contents_.material_density) {
            material += fmt::format("{}{:g}\u202fg/cm³", material.empty() ? "" : ", ", *contents_.material_density);
        }
        cell("Material", material);
        if (contents_.printer.empty()) {
            cell("Tray", fmt::format("{:g} × {:g} × {:g}\u202fmm", packing_.container.size.x, packing_.container.size.y,
                                     packing_.container.size.z));
        }
        cell("Gap between copies", with_unit(packing_.options.gap, 1, "mm"));
        cell("Gap to the walls", with_unit(packing_.options.wall_gap, 1, "mm"));
        cell("Placed in all trays", fmt::format("{} of {} asked", packing_.metrics.placed, packing_.metrics.copies));
        html_.add("</dl>\n");
    }

    void figure(const std::string& value, const char* unit, const std::string& what) {
        html_.add("<div><b>{}<small>\u202f{}</small></b><span>{}</span></div>", value, unit, what);
    }

    void figures() {
        const double volume = tray().density * volume_of(packing_.container) / kCubicMillimetresPerCubicCentimetre;
        html_.add("<div class=\"fig\">");
        figure(fmt::format("{}", tray().placements.size()), tray().placements.size() == 1 ? "copy" : "copies",
               "in this tray");
        figure(fmt::format("{:.1f}", tray().height), "mm",
               packing_.container.open_height ? "height" : fmt::format("height, of {:g}", packing_.container.size.z));
        figure(fmt::format("{:.1f}", 100 * tray().density), "%", "filled, by volume");
        figure(fmt::format("{:.0f}", volume), "cm³", "of parts");
        if (contents_.material_density) {
            const double grams = volume * *contents_.material_density;
            const bool heavy = grams >= 1000;
            figure(heavy ? fmt::format("{:.2f}", grams / 1000) : fmt::format("{:.0f}", grams), heavy ? "kg" : "g",
                   fmt::format("of parts: {:.2f}\u202fg/cm³ of tray", tray().density * *contents_.material_density));
        }
        html_.add("</div>\n");
    }

    void hero() {
        const double height = layout().hero_height;
        const bool slabs = !layout().slabs.empty();
        html_.add(
            "<div class=\"hero\" style=\"height:{:.1f}mm\"><figure>{}<figcaption>From the front right.{}{}</figcaption>"
            "</figure><aside>",
            height + 5,
            picture_svg(contents_.pictures[tray_].whole, "pic", fmt::format("Tray {} from the front right", tray_ + 1)),
            tray_ == 0 && layout().full
                ? " The numbers are those of the part list, top views, removal order, 3MF and CSV."
                : "",
            std::ranges::any_of(tray().placements, [](const Placement& copy) { return copy.fixed; })
                ? " Dotted outlines: stood there before."
                : "");
        html_.add("<h2>Layers <small>filled area, height in mm</small></h2>{}",
                  layer_plot(sheet_, tray_, height - kPlotMargin));
        if (slabs) {
            const std::string last = slab_name(layout().slabs.size() - 1);
            html_.add("<p>{}</p>", last == "A" ? std::string("A: the slab of the top view.")
                                               : fmt::format("A {} {}: slabs of the top views, from the top down.",
                                                             last == "B" ? "and" : "to", last));
        }
        html_.add("</aside></div>\n");
    }

    const SheetInput& sheet_;
    const ReportContents& contents_;
    const Packing& packing_;
    std::size_t tray_;
    Html html_;
};

}  // namespace

std::string cover_page(const SheetInput& sheet, std::size_t tray, const std::string& list, const std::string& pages) {
    return Cover(sheet, tray).page(list, pages);
}

}  // namespace spectralpack
