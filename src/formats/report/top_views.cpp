#include <algorithm>
#include <cmath>
#include <set>

#include "formats/report/pages.hpp"
#include "formats/report/picture_svg.hpp"
#include "model/palette.hpp"

namespace spectralpack {
namespace {

constexpr double kCaption = 5.6, kUnder = 5.2, kAround = 0.8, kBetween = 1.6;
constexpr double kNumberRow = 5.1, kSmallRow = 4.4, kDigit = 1.85, kSwatch = 3.2;
constexpr double kNarrowColumn = 89, kWideColumn = 184;

struct Entry {
    int number = 0, part = 0;
};

/// One slab: its view, and the numbers to take out of it.
class SlabFigure {
  public:
    SlabFigure(const SheetInput& sheet, std::size_t tray, std::size_t slab)
        : sheet_(sheet), tray_(tray), slab_(slab), layout_(sheet.contents.layout[tray]) {
        width_ = layout_.map_width;
        height_ = width_ * sheet.packing.container.size.y / sheet.packing.container.size.x;
        column_ = layout_.map_columns == 2 ? kNarrowColumn : kWideColumn;
        sort_entries();
        cell_ = kSwatch + kDigit * static_cast<double>(std::to_string(most_).size());
        beside_columns_ = std::max(1, static_cast<int>((column_ - width_ - 2 * kAround - 1) / cell_));
        const auto rows = static_cast<std::size_t>((height_ + kUnder) / kNumberRow);
        room_beside_ = rows * static_cast<std::size_t>(beside_columns_);
        below_columns_ = std::max(1, static_cast<int>(column_ / cell_));
    }

    double height() const { return kCaption + height_ + 2 * kAround + kUnder + below_height() + kBetween; }

    std::string html() const {
        const Slab& slab = layout_.slabs[slab_];
        Html html;
        html.add(
            "<figure class=\"slab\" style=\"height:{:.1f}mm\"><figcaption><b>{}</b> <span>{:.0f} to {:.0f}\u202fmm above the "
            "floor</span><em>take out {}</em></figcaption><div class=\"sm\" style=\"grid-template-columns:{:.1f}mm 1fr\">",
            height() - kBetween, slab_name(slab_), slab.high, slab.low, slab.placements.size(), width_ + 2 * kAround);
        html.add("{}<div class=\"take\" style=\"grid-template-columns:repeat({},{:.1f}mm)\">", view(), beside_columns_,
                 cell_);
        std::size_t taken = 0;
        const std::size_t beside = std::min(room_beside_, cells(beside_columns_));
        add_cells(html, beside, taken);
        html.add("</div></div>");
        if (below_height() > 0) {
            html.add("<div class=\"take under\" style=\"grid-template-columns:repeat({},{:.1f}mm)\">", below_columns_,
                     cell_);
            add_cells(html, seen_.size() + hidden_.size() + 1, taken);
            html.add("</div>");
        }
        html.add("</figure>\n");
        return html.take();
    }

  private:
    void sort_entries() {
        std::set<int> labelled;
        for (const SheetPicture::Number& number : picture().numbers) {
            if (number.strong) labelled.insert(number.number);
        }
        std::vector<Entry> all;
        for (const int index : layout_.slabs[slab_].placements) {
            const Placement& placement = sheet_.packing.trays[tray_].placements[static_cast<std::size_t>(index)];
            all.push_back({sheet_.numbers.of(placement), placement.part});
        }
        std::sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) { return a.number < b.number; });
        for (const Entry& entry : all) {
            const bool hidden = !picture().png.empty() && !labelled.contains(entry.number);
            (hidden ? hidden_ : seen_).push_back(entry);
            most_ = std::max(most_, entry.number);
        }
    }

    /// How many cells the whole list takes in so many columns: the line between its two halves fills rows.
    std::size_t cells(int columns) const {
        const auto wide = static_cast<std::size_t>(columns);
        std::size_t count = seen_.size();
        if (!hidden_.empty()) count = (count + wide - 1) / wide * wide + 2 * wide + hidden_.size();
        return count;
    }

    double below_height() const {
        if (cells(beside_columns_) <= room_beside_) return 0;
        const std::size_t left = seen_.size() + hidden_.size() - std::min(room_beside_, seen_.size() + hidden_.size());
        const auto wide = static_cast<std::size_t>(below_columns_);
        return kSmallRow * static_cast<double>((left + 3 * wide) / wide + 2);
    }

    /// Goes on with the list where `taken` says, by at most `room` cells.
    void add_cells(Html& html, std::size_t room, std::size_t& taken) const {
        const auto columns = static_cast<std::size_t>(beside_columns_);
        std::size_t used = 0;
        for (; used < room && taken < seen_.size(); ++used, ++taken) {
            add_entry(html, seen_[taken]);
        }
        if (taken < seen_.size() || hidden_.empty()) return;
        if (taken == seen_.size()) {
            used = (used + columns - 1) / columns * columns + 2 * columns;
            if (used >= room) return;
            html.add("<em>below others</em>");
            ++taken;  // the heading is behind us
        }
        for (; used < room && taken <= seen_.size() + hidden_.size(); ++used, ++taken) {
            const std::size_t at = taken - seen_.size() - 1;
            if (at >= hidden_.size()) break;
            add_entry(html, hidden_[at]);
        }
    }

    static void add_entry(Html& html, const Entry& entry) {
        html.add("<span><i style=\"background:{}\"></i>{}</span>", part_colour_text(entry.part), entry.number);
    }

    const SheetPicture& picture() const { return sheet_.contents.pictures[tray_].slabs[slab_]; }

    /// Drawn in millimetres of print.
    std::string view() const {
        const Vec3& size = sheet_.packing.container.size;
        const double scale = width_ / size.x, bar = size.x >= 60 ? 50 : 10;
        Html html;
        html.add(
            "<svg viewBox=\"{0} {0} {1:.2f} {2:.2f}\" class=\"map\" style=\"width:{1:.2f}mm\" role=\"img\" "
            "aria-label=\"Slab {3} from above\">",
            -kAround, width_ + 2 * kAround, height_ + 2 * kAround + kUnder, slab_name(slab_));
        if (!picture().png.empty()) {
            html.add("<image href=\"{}\" width=\"{:.2f}\" height=\"{:.2f}\"/>", picture_link(picture().png), width_,
                     height_);
        } else {
            html.add("<text x=\"{:.2f}\" y=\"{:.2f}\" class=\"axm\" text-anchor=\"middle\">left out for time</text>",
                     width_ / 2, height_ / 2);
        }
        html.add("<path d=\"");
        for (double x = bar; x < size.x; x += bar) {
            html.add("M{:.2f} 0V{:.2f}", x * scale, height_);
        }
        for (double y = bar; y < size.y; y += bar) {
            html.add("M0 {:.2f}H{:.2f}", height_ - y * scale, width_);
        }
        html.add("\" class=\"grid\"/><rect width=\"{:.2f}\" height=\"{:.2f}\" class=\"wall\"/>{}", width_, height_,
                 number_texts(picture(), 1 / picture().millimetre));
        const double under = height_ + 2.3;
        html.add(
            "<path d=\"M0 {0:.2f}h{1:.2f}m-{1:.2f} -.7v1.4m{1:.2f} -1.4v1.4\" class=\"sc\"/><text x=\"{2:.2f}\" y=\"{3:.2f}\" "
            "class=\"axm\">{4:g} mm</text><text x=\"{5:.2f}\" y=\"{3:.2f}\" class=\"axm\" text-anchor=\"middle\">front</text></svg>",
            under, bar * scale, bar * scale + 1, under + 0.8, bar, std::max(width_ / 2, bar * scale + 17));
        return html.take();
    }

    const SheetInput& sheet_;
    std::size_t tray_, slab_;
    const TrayLayout& layout_;
    double width_ = 0, height_ = 0, column_ = 0, cell_ = 0;
    int beside_columns_ = 1, below_columns_ = 1, most_ = 1;
    std::size_t room_beside_ = 0;
    std::vector<Entry> seen_, hidden_;
};

}  // namespace

std::vector<std::string> top_views(const SheetInput& sheet, std::size_t tray, double& used) {
    const TrayLayout& layout = sheet.contents.layout[tray];
    const auto columns = static_cast<std::size_t>(layout.map_columns);
    std::vector<SlabFigure> figures;
    for (std::size_t slab = 0; slab < layout.slabs.size(); ++slab) {
        figures.emplace_back(sheet, tray, slab);
    }
    std::vector<double> rows;
    for (std::size_t i = 0; i < figures.size(); i += columns) {
        double height = 0;
        for (std::size_t k = i; k < std::min(i + columns, figures.size()); ++k) {
            height = std::max(height, figures[k].height());
        }
        rows.push_back(height);
    }
    const std::vector<std::size_t> begins = split_rows(rows, kBody);
    std::vector<std::string> pages;
    for (std::size_t page = 0; page < begins.size(); ++page) {
        const std::size_t end = page + 1 < begins.size() ? begins[page + 1] : rows.size();
        std::string html = fmt::format("<div class=\"maps{}\">", columns == 1 ? " wide" : "");
        used = 0;
        for (std::size_t row = begins[page]; row < end; ++row) {
            used += rows[row];
        }
        for (std::size_t i = columns * begins[page]; i < std::min(columns * end, figures.size()); ++i) {
            html += figures[i].html();
        }
        if (!layout.full && columns == 2 && figures.size() % 2 == 1 && end == rows.size()) {
            html += "<section class=\"notes\"><h2>Notes</h2></section>";
        }
        pages.push_back(html + "</div>\n");
    }
    return pages;
}

std::string top_views_foot(const SheetInput& sheet, std::size_t tray) {
    const TrayLayout& layout = sheet.contents.layout[tray];
    const double bar = sheet.packing.container.size.x >= 60 ? 50 : 10;
    const double scale = sheet.packing.container.size.x / layout.map_width;
    return fmt::format(
        "<p class=\"foot\"><b>Strong colour, bold number:</b> take it out of this slab. <b>Pale, thin number:</b> it reaches in, "
        "but its middle is in another slab. <b>Below others:</b> to take here, but covered or too small for a number. Scale "
        "{}; grid {:g}\u202fmm.{}</p>\n",
        scale >= 1 ? fmt::format("1 : {:.1f}", scale) : fmt::format("{:.1f} : 1", 1 / scale), bar,
        !layout.full && !sheet.packing.unplaced.empty() ? " Left over: see page 1." : "");
}

}  // namespace spectralpack
