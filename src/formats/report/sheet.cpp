#include <algorithm>

#include "formats/report/pages.hpp"

namespace spectralpack {
namespace {

// Stand for page numbers that are known last. No text from files can hold them: escaped() takes control characters out.
const std::string kPages = "\x01pages\x01", kLeftOverPage = "\x01left\x01";

constexpr double kLeastRemoval = 60;  // mm: with less room the removal order starts on a page of its own

constexpr const char* kRemovalFoot =
    "<p class=\"foot\">No copy has to be turned or forced: each moves straight along its arrow, so far in mm, and is clear of the "
    "others. Several moves: one after the other; with a plus: at once. A frame: a group that leaves as one and is parted outside, "
    "its ways counted from where its copies stand to each other.</p>\n";
/// Takes what is left of a page.
constexpr const char* kNotes = "<section class=\"notes rest\"><h2>Notes</h2></section>\n";
constexpr const char* kListFoot =
    "<p class=\"foot\">Numbers run through the whole build, so each stands on one copy only. The colour is that of the copies in "
    "all pictures. Tick “Out” once all copies of the row are found.</p>\n";

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
}

class Sheet {
  public:
    Sheet(const Packing& packing, const ReportContents& contents)
        : input_{packing, contents, outcomes_of(packing), CopyNumbers(packing.parts), kLeftOverPage} {}

    std::string html() {
        for (std::size_t tray = 0; tray < input_.packing.trays.size(); ++tray) {
            add_tray(tray);
        }
        Html html;
        html.add(
            "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\"><head><meta charset=\"utf-8\"/>"
            "<meta name=\"viewport\" content=\"width=device-width\"/><title>{}: operator’s sheet</title><style>{}</style>"
            "</head><body>\n{}",
            escaped(input_.contents.job_name), sheet_style(), arrow_symbols());
        for (std::size_t i = 0; i < pages_.size(); ++i) {
            std::string page = pages_[i];
            replace_all(page, kPages, fmt::format("page {} of {}", i + 1, pages_.size()));
            replace_all(page, kLeftOverPage, std::to_string(left_over_page_));
            html.add("<section class=\"page\">{}</section>\n", page);
        }
        html.add("</body></html>\n");
        return html.take();
    }

  private:
    void add_tray(std::size_t tray) {
        tray_ = tray;
        const TrayLayout& layout = input_.contents.layout[tray];
        if (layout.full) {
            pages_.push_back(cover_page(input_, tray, "", kPages));
            for (const std::string& table : part_tables(input_, tray, kBody)) {
                add("Part list", table + kListFoot);
            }
            double used = 0;
            for (const std::string& views : top_views(input_, tray, used)) {
                add("Top views, from the top down", views + top_views_foot(input_, tray));
            }
            for (const std::string& removal : removal_pages(input_, tray, 0, 3)) {
                add("Removal order", removal + kRemovalFoot);
            }
        } else {
            add_short(tray);
        }
        if (tray > 0) return;
        const std::vector<std::string> rest = left_over_pages(input_);
        left_over_page_ = pages_.size() + 1;
        for (const std::string& page : rest) {
            add("Left over", page);
        }
    }

    /// Few parts: their list is on the cover; the removal order follows the top views.
    void add_short(std::size_t tray) {
        const std::vector<std::string> list = part_tables(input_, tray, kPageHeight);
        pages_.push_back(cover_page(input_, tray, list.empty() ? "" : list.front(), kPages));
        double used = 0;
        std::vector<std::string> views = top_views(input_, tray, used);
        const double room = kBody - used;
        const bool shared = !views.empty() && room >= kLeastRemoval;
        std::vector<std::string> removal = removal_pages(input_, tray, shared ? room : 0, 2);
        const bool joined = shared && !removal.empty();
        for (std::size_t i = 0; i < views.size(); ++i) {
            const bool last = joined && i + 1 == views.size();
            add(last ? "Top views and removal order" : "Top views, from the top down",
                views[i] + (last ? removal.front() + kNotes : std::string()) + top_views_foot(input_, tray));
        }
        for (std::size_t i = joined ? 1 : 0; i < removal.size(); ++i) {
            add("Removal order", removal[i] + kRemovalFoot);
        }
    }

    void add(const char* heading, const std::string& body) {
        pages_.push_back(fmt::format(
            "<header class=\"run\"><b>{}</b><span>Tray {} of {}</span><span class=\"t\">{}</span>"
            "<span class=\"pg\">{}</span></header>\n{}",
            escaped(input_.contents.job_name), tray_ + 1, input_.packing.trays.size(), heading, kPages, body));
    }

    SheetInput input_;
    std::size_t tray_ = 0, left_over_page_ = 0;
    std::vector<std::string> pages_;
};

}  // namespace

std::vector<std::size_t> split_rows(const std::vector<double>& heights, double height) {
    std::vector<std::size_t> begins;
    double used = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (begins.empty() || used + heights[i] > height) {
            begins.push_back(i);
            used = 0;
        }
        used += heights[i];
    }
    return begins;
}

std::string report_html(const Packing& packing, const ReportContents& contents) {
    return Sheet(packing, contents).html();
}

}  // namespace spectralpack
