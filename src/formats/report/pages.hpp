#pragma once
/// The pages of the sheet, piece by piece. Rows have known heights, so that pages are filled without asking a browser.
/// All heights are millimetres in print.

#include <string>
#include <vector>

#include "formats/report/html.hpp"
#include "formats/report/outcome.hpp"
#include "formats/report/report.hpp"

namespace spectralpack {

inline constexpr double kPageHeight = 276;
inline constexpr double kRunningHead = 10.5, kFoot = 11;
inline constexpr double kBody = kPageHeight - kRunningHead - kFoot;  ///< what a page without a cover holds
inline constexpr double kCubicMillimetresPerCubicCentimetre = 1000;

/// What all pieces read.
struct SheetInput {
    const Packing& packing;
    const ReportContents& contents;
    std::vector<PartOutcome> outcomes;
    CopyNumbers numbers;
    std::string left_over_page;  ///< stands for the number of the page that goes on with what is left over
};

/// A page without its head.
struct Page {
    std::string heading;  ///< of the running head; empty: a cover, which has its own
    std::string body;
};

/// Splits rows of these heights into pages (or columns) of at most `height`: begins of each. An empty list has none.
std::vector<std::size_t> split_rows(const std::vector<double>& heights, double height);

/// `list`: the part table of a tray of few parts, else empty. `pages`: "page 1 of 6".
std::string cover_page(const SheetInput& sheet, std::size_t tray, const std::string& list, const std::string& pages);
std::string layer_plot(const SheetInput& sheet, std::size_t tray, double height);

double part_table_height(const Packing& packing, const std::vector<PartOutcome>& outcomes, const TrayLayout& layout,
                         std::size_t tray);
/// The list's tables, one for each page.
std::vector<std::string> part_tables(const SheetInput& sheet, std::size_t tray, double height);

/// What the cover shows of what is left over, and the pages with the rest.
std::size_t left_over_rows(const std::vector<PartOutcome>& outcomes, double height);
double left_over_height(const std::vector<PartOutcome>& outcomes, std::size_t shown);
std::string left_over_table(const SheetInput& sheet);
std::vector<std::string> left_over_pages(const SheetInput& sheet);

/// Pages of top views; `used`: how much of the last one is.
std::vector<std::string> top_views(const SheetInput& sheet, std::size_t tray, double& used);
std::string top_views_foot(const SheetInput& sheet, std::size_t tray);

/// Pages of the removal order. The first has room for `first`, in `columns`; `stages` go below the last.
std::vector<std::string> removal_pages(const SheetInput& sheet, std::size_t tray, double first, int columns);

/// What the arrows of the removal order refer to; once in the page.
std::string arrow_symbols();

/// After which steps a picture shows what must be left.
std::vector<int> stages_of(const TrayPacking& tray);

std::string sheet_style();

}  // namespace spectralpack
