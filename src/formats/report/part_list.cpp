#include <algorithm>

#include "formats/report/pages.hpp"
#include "model/palette.hpp"

namespace spectralpack {
namespace {

constexpr double kPartRow = 11.85, kPartHead = 6, kNumberLine = 4.1;
constexpr std::size_t kLargeNumbers = 9, kNumbersInLine = 13;  // characters that fit the column

/// Long lists of numbers take several lines.
std::size_t number_lines(const std::string& numbers) {
    return numbers.size() <= kLargeNumbers ? 1 : (numbers.size() + kNumbersInLine - 1) / kNumbersInLine;
}

double row_height(const std::string& numbers, std::size_t rest_lines) {
    return std::max(kPartRow, kNumberLine * static_cast<double>(std::max(number_lines(numbers), rest_lines)) + 2);
}

/// Where the copies are that are not in this tray, a line each.
std::vector<std::string> rest_of(const PartOutcome& outcome, std::size_t tray) {
    std::vector<std::string> lines;
    for (std::size_t other = 0; other < outcome.placed.size(); ++other) {
        if (other == tray || outcome.placed[other].empty()) continue;
        lines.push_back(fmt::format("{} in tray {}", outcome.placed[other].size(), other + 1));
    }
    constexpr std::size_t kMostTrays = 3;
    if (lines.size() > kMostTrays) {
        std::size_t count = 0;
        for (std::size_t other = 0; other < outcome.placed.size(); ++other) {
            count += other == tray ? 0 : outcome.placed[other].size();
        }
        lines = {fmt::format("{} in other trays", count)};
    }
    if (outcome.left_over_count() > 0) lines.push_back(fmt::format("{} left over", outcome.left_over_count()));
    return lines;
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

class PartTable {
  public:
    PartTable(const SheetInput& sheet, std::size_t tray) : sheet_(sheet), tray_(tray) {
        for (const int part : layout().listed) {
            const PackedPart& of = this->part(part);
            has_orders_ = has_orders_ || !of.order.empty();
            has_due_ = has_due_ || !of.due.empty();
        }
    }

    std::vector<std::string> tables(double height) const {
        std::vector<double> heights;
        for (const int part : layout().listed) {
            heights.push_back(height_of(part));
        }
        const std::vector<std::size_t> begins = split_rows(heights, height - kPartHead);
        std::vector<std::string> tables;
        for (std::size_t i = 0; i < begins.size(); ++i) {
            const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : heights.size();
            tables.push_back(table(begins[i], end));
        }
        return tables;
    }

  private:
    const TrayLayout& layout() const { return sheet_.contents.layout[tray_]; }
    const PackedPart& part(int index) const { return sheet_.packing.parts[static_cast<std::size_t>(index)]; }
    const PartOutcome& outcome(int index) const { return sheet_.outcomes[static_cast<std::size_t>(index)]; }

    double height_of(int part) const {
        return row_height(runs_of(outcome(part).placed[tray_], "-"), rest_of(outcome(part), tray_).size());
    }

    std::string table(std::size_t begin, std::size_t end) const {
        Html html;
        html.add(
            "<table class=\"parts\"><thead><tr><th class=\"ck\">Out</th><th class=\"cn\">Numbers</th><th class=\"tm\"></th>"
            "<th class=\"pn\">Part</th><th class=\"n ct\">In this tray</th><th class=\"rest\">Rest</th>{}{}"
            "<th class=\"n vo\">cm³ each</th></tr></thead><tbody>\n",
            has_orders_ ? "<th class=\"or\">Order</th>" : "", has_due_ ? "<th class=\"du\">Due</th>" : "");
        for (std::size_t i = begin; i < end; ++i) {
            add_row(html, layout().listed[i]);
        }
        html.add("</tbody></table>\n");
        return html.take();
    }

    void add_row(Html& html, int index) const {
        const PackedPart& of = part(index);
        const std::vector<int>& here = outcome(index).placed[tray_];
        const std::string numbers = runs_of(here);
        const std::vector<std::string> rest = rest_of(outcome(index), tray_);
        html.add(
            "<tr class=\"part{}\" style=\"height:{:.1f}mm\"><td class=\"ck\"><i></i></td><td class=\"cn\"><div>"
            "<i style=\"background:{}\"></i><b{}>{}</b></div></td><td class=\"tm\">",
            here.empty() ? " none" : "", height_of(index), part_colour_text(index),
            runs_of(here, "-").size() > kLargeNumbers ? " class=\"long\"" : "", here.empty() ? "–" : numbers);
        const std::string& thumb = sheet_.contents.thumbs[static_cast<std::size_t>(index)];
        if (!thumb.empty()) html.add("<img src=\"{}\" alt=\"\"/>", picture_link(thumb));
        html.add(
            "</td><td class=\"pn\"><b>{}</b><span>{}</span></td><td class=\"n ct\"><b>{}</b> of {}</td><td class=\"rest\">",
            escaped(of.name), note_of(of), here.size(), of.count);
        for (std::size_t i = 0; i < rest.size(); ++i) {
            html.add("{}{}", i > 0 ? "<br/>" : "", rest[i]);
        }
        html.add("</td>");
        if (has_orders_) html.add("<td class=\"or\">{}</td>", of.order.empty() ? "–" : escaped(of.order));
        if (has_due_) html.add("<td class=\"du\">{}</td>", of.due.empty() ? "–" : escaped(day_of(of.due)));
        html.add("<td class=\"n vo\">{}</td></tr>\n",
                 of.volume == 0 ? "–" : fmt::format("{:.1f}", of.volume / kCubicMillimetresPerCubicCentimetre));
    }

    /// The file where it says more than the name, and the scale where there is one.
    static std::string note_of(const PackedPart& part) {
        std::string note = file_name(part.mesh);
        if (part.scale != 1) note += fmt::format("{}scale {:g}", note.empty() ? "" : " · ", part.scale);
        return escaped(note);
    }

    const SheetInput& sheet_;
    std::size_t tray_;
    bool has_orders_ = false, has_due_ = false;
};

}  // namespace

double part_table_height(const Packing&, const std::vector<PartOutcome>& outcomes, const TrayLayout& layout,
                         std::size_t tray) {
    double height = kPartHead;
    for (const int part : layout.listed) {
        const PartOutcome& outcome = outcomes[static_cast<std::size_t>(part)];
        height += row_height(runs_of(outcome.placed[tray], "-"), rest_of(outcome, tray).size());
    }
    return height;
}

std::vector<std::string> part_tables(const SheetInput& sheet, std::size_t tray, double height) {
    return PartTable(sheet, tray).tables(height);
}

}  // namespace spectralpack
