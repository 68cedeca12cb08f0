#include <algorithm>
#include <cctype>

#include "formats/report/pages.hpp"
#include "model/palette.hpp"

namespace spectralpack {
namespace {

constexpr double kRow = 10.9, kHead = 8, kMoreLine = 5, kShortRow = 5.6;
constexpr std::size_t kLeastShown = 1, kMostShown = 8;
constexpr int kColumns = 2;  // of the pages with the rest

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
std::string why(const SheetInput& sheet, const LeftOverRow& row, bool remedy) {
    const auto& some = sheet.outcomes[static_cast<std::size_t>(row.part)].left_over.at(row.reason);
    std::string text = in_words(row.reason);
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    if (!some.detail.empty()) text += ": " + some.detail;
    if (text.back() != '.') text += '.';
    if (remedy && row.reason == UnplacedReason::no_place && some.detail.empty()) text += " Needs another tray.";
    return escaped(text);
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
    const auto fit = static_cast<std::size_t>(std::max(0.0, (height - kHead - kMoreLine) / kRow));
    return std::min(rows_of(outcomes).size(), std::clamp(fit, kLeastShown, kMostShown));
}

double left_over_height(const std::vector<PartOutcome>& outcomes, std::size_t shown) {
    const std::size_t rows = rows_of(outcomes).size();
    return rows == 0 ? 0 : kHead + kRow * static_cast<double>(shown) + (shown < rows ? kMoreLine : 0);
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
            why(sheet, rows[i], true));
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
    const auto per_column = static_cast<std::size_t>((kBody - kHead) / kShortRow);
    std::vector<std::string> pages;
    for (std::size_t begin = 0; begin < rows.size(); begin += kColumns * per_column) {
        Html html;
        html.add("<div class=\"cols c2\">");
        for (std::size_t column = begin; column < std::min(begin + kColumns * per_column, rows.size());
             column += per_column) {
            html.add(
                "<table class=\"rem lo\"><thead><tr><th class=\"pt\">Part</th><th class=\"ct\">Copies</th>"
                "<th class=\"wy\">Why</th></tr></thead><tbody>\n");
            for (std::size_t i = column; i < std::min(column + per_column, rows.size()); ++i) {
                const auto part = static_cast<std::size_t>(rows[i].part);
                html.add("<tr><td class=\"nm\">{}</td><td>{} of {}</td><td class=\"nm\">{}</td></tr>\n",
                         escaped(sheet.packing.parts[part].name),
                         sheet.outcomes[part].left_over.at(rows[i].reason).numbers.size(),
                         sheet.packing.parts[part].count, why(sheet, rows[i], false));
            }
            html.add("</tbody></table>");
        }
        html.add("</div>\n");
        pages.push_back(html.take());
    }
    return pages;
}

}  // namespace spectralpack
