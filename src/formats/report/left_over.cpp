#include <algorithm>
#include <cctype>

#include "formats/report/pages.hpp"
#include "model/palette.hpp"

namespace spectralpack {
namespace {

constexpr double kRow = 10.9, kHead = 8, kMoreLine = 5, kShortRow = 5.6;
// Of why a part is left over: what a row holds anyway, characters that surely fit a line, and what one more takes.
constexpr std::size_t kLines = 2, kCharacters = 52, kShortCharacters = 25;
constexpr double kTextLine = 4.1, kShortTextLine = 3.3;
constexpr std::size_t kLeastShown = 1, kMostShown = 8;
constexpr std::size_t kColumns = 2;  // of the pages with the rest

struct LeftOverRow {
    int part = 0;
    UnplacedReason reason = UnplacedReason::no_place;
};

std::vector<LeftOverRow> rows_of(const std::vector<PartOutcome>& outcomes) {
    std::vector<LeftOverRow> rows;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        for (const auto& [reason, some] : outcomes[i].left_over) {
            rows.push_back({static_cast<int>(i), reason});
        }
    }
    return rows;
}

/// A sentence: what it is, and where there is room, what would help.
std::string why(const std::vector<PartOutcome>& outcomes, const LeftOverRow& row, bool remedy) {
    const auto& some = outcomes[static_cast<std::size_t>(row.part)].left_over.at(row.reason);
    const bool never_fits = row.reason == UnplacedReason::no_place && !some.detail.empty();
    std::string text = never_fits ? some.detail : in_words(row.reason);
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    if (!some.detail.empty() && !never_fits) text += ": " + some.detail;
    if (text.back() != '.') text += '.';
    if (remedy && row.reason == UnplacedReason::no_place && some.detail.empty()) text += " Needs another tray.";
    return text;
}

/// How many lines the text takes, broken at spaces.
std::size_t lines_of(const std::string& text, std::size_t width) {
    std::size_t lines = 1, used = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
        const auto word =
            static_cast<std::size_t>(std::count_if(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                                   text.begin() + static_cast<std::ptrdiff_t>(end), is_first_byte));
        if (used > 0 && used + 1 + word > width) {
            ++lines;
            used = 0;
        }
        used += (used > 0 ? 1 : 0) + word;
        lines += word > 0 ? (word - 1) / width : 0;
        begin = end + 1;
    }
    return lines;
}

double row_height_of(const std::vector<PartOutcome>& outcomes, const LeftOverRow& row) {
    const std::size_t lines = lines_of(why(outcomes, row, true), kCharacters);
    return kRow + kTextLine * static_cast<double>(lines - std::min(lines, kLines));
}

double short_row_height_of(const std::vector<PartOutcome>& outcomes, const LeftOverRow& row) {
    const std::size_t lines = lines_of(why(outcomes, row, false), kShortCharacters);
    return kShortRow + kShortTextLine * static_cast<double>(lines - 1);
}

std::string about(const SheetInput& sheet, const LeftOverRow& row) {
    const PackedPart& part = sheet.packing.parts[static_cast<std::size_t>(row.part)];
    const auto& some = sheet.outcomes[static_cast<std::size_t>(row.part)].left_over.at(row.reason);
    std::string text = "No. " + runs_of(some.numbers);
    if (!part.order.empty()) text += " · order " + escaped(part.order);
    if (!part.due.empty()) text += " · due " + escaped(day_of(part.due));
    return text;
}

}  // namespace

std::size_t left_over_rows(const std::vector<PartOutcome>& outcomes, double height) {
    const std::vector<LeftOverRow> rows = rows_of(outcomes);
    std::size_t shown = 0;
    for (double used = kHead + kMoreLine; shown < std::min(rows.size(), kMostShown); ++shown) {
        used += row_height_of(outcomes, rows[shown]);
        if (shown >= kLeastShown && used > height) break;
    }
    return shown;
}

double left_over_height(const std::vector<PartOutcome>& outcomes, std::size_t shown) {
    const std::vector<LeftOverRow> rows = rows_of(outcomes);
    if (rows.empty()) return 0;
    double height = kHead + (shown < rows.size() ? kMoreLine : 0);
    for (std::size_t i = 0; i < shown; ++i) {
        height += row_height_of(outcomes, rows[i]);
    }
    return height;
}

std::string left_over_table(const SheetInput& sheet) {
    const std::vector<LeftOverRow> rows = rows_of(sheet.outcomes);
    if (rows.empty()) return "";
    const std::size_t shown = sheet.contents.layout.front().left_over_rows;
    Html html;
    html.add("<section class=\"left\"><h2>Left over <small>{} of {} copies, not in any tray</small></h2><table>\n",
             sheet.packing.unplaced.size(), sheet.packing.metrics.copies);
    for (std::size_t i = 0; i < shown; ++i) {
        const auto part = static_cast<std::size_t>(rows[i].part);
        const std::string& thumb = sheet.contents.thumbs[part];
        html.add(
            "<tr><td class=\"tm\">{}</td><td class=\"pn\"><b>{}</b><span>{}</span></td>"
            "<td class=\"n\"><b>{}</b> of {}</td><td class=\"why\"><div>{}</div></td></tr>\n",
            thumb.empty() ? "" : fmt::format("<img src=\"{}\" alt=\"\"/>", picture_link(thumb)),
            escaped(sheet.packing.parts[part].name), about(sheet, rows[i]),
            sheet.outcomes[part].left_over.at(rows[i].reason).numbers.size(), sheet.packing.parts[part].count,
            escaped(why(sheet.outcomes, rows[i], true)));
    }
    html.add("</table>");
    if (shown < rows.size()) {
        html.add("<p class=\"more\">and {} more: see page {}</p>", counted(rows.size() - shown, "part"),
                 sheet.left_over_page);
    }
    html.add("</section>\n");
    return html.take();
}

std::vector<std::string> left_over_pages(const SheetInput& sheet) {
    std::vector<LeftOverRow> rows = rows_of(sheet.outcomes);
    const std::size_t shown = sheet.contents.layout.front().left_over_rows;
    if (shown == rows.size()) return {};
    rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(shown));
    std::vector<double> heights;
    for (const LeftOverRow& row : rows) {
        heights.push_back(short_row_height_of(sheet.outcomes, row));
    }
    std::vector<std::size_t> begins = split_rows(heights, kBody - kHead);  // of columns
    begins.push_back(rows.size());
    std::vector<std::string> pages;
    for (std::size_t first = 0; first + 1 < begins.size(); first += kColumns) {
        Html html;
        html.add("<div class=\"cols c2\">");
        for (std::size_t column = first; column < std::min(first + kColumns, begins.size() - 1); ++column) {
            html.add(
                "<table class=\"rem lo\"><thead><tr><th class=\"pt\">Part</th><th class=\"ct\">Copies</th>"
                "<th class=\"wy\">Why</th></tr></thead><tbody>\n");
            for (std::size_t i = begins[column]; i < begins[column + 1]; ++i) {
                const auto part = static_cast<std::size_t>(rows[i].part);
                html.add(
                    "<tr><td class=\"nm\">{}</td><td>{} of {}</td><td class=\"wy\" style=\"height:{:.1f}mm\">{}</td></tr>\n",
                    escaped(sheet.packing.parts[part].name),
                    sheet.outcomes[part].left_over.at(rows[i].reason).numbers.size(), sheet.packing.parts[part].count,
                    heights[i], escaped(why(sheet.outcomes, rows[i], false)));
            }
            html.add("</tbody></table>");
        }
        html.add("</div>\n");
        pages.push_back(html.take());
    }
    return pages;
}

}  // namespace spectralpack
