#pragma once
/// Reports of a packing for people: the operator's sheet, which is A4 pages to hang on the machine and to unpack by,
/// and a table for spreadsheets.
///
/// The sheet is one HTML file, which is well-formed XML as well. Its pictures are drawn elsewhere: sheet_layout() says
/// which are wanted and how large, report_html() takes them.

#include <optional>
#include <string>
#include <vector>

#include "model/slabs.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Sizes in print, mm.
inline constexpr double kNumberSize = 2.75, kPaleNumberSize = 2.35;
inline constexpr double kThumbWidth = 15, kThumbHeight = 10.4;
inline constexpr double kStageWidth = 43;

/// What the pages of one tray hold.
struct TrayLayout {
    bool full = true;         ///< pages of their own for list, top views and removal order; else two pages in all
    std::vector<Slab> slabs;  ///< a top view of each
    std::vector<int> stages;  ///< after these steps a picture of what must be left
    std::vector<int> listed;  ///< parts in the tray's list
    std::size_t left_over_rows = 0;  ///< so many on the first tray's cover
    double hero_height = 0;          ///< of the large picture, mm
    double stage_height = 0;         ///< of those of the stages, mm
    int map_columns = 1;
    double map_width = 0;  ///< of the tray's floor in a top view, mm
};
inline constexpr double kHeroWidth = 131, kHeroAzimuth = 35, kHeroElevation = 22;  ///< from the front right

/// By placement: whether it still stands in the tray after so many steps of its plan. Groups leave as one.
std::vector<bool> left_after(const TrayPacking& tray, int step);

/// `boxes`: by tray and placement.
std::vector<TrayLayout> sheet_layout(const Packing& packing, const std::vector<std::vector<Box>>& boxes);

/// A picture in the sheet, and what is written over it; pixels from its upper left corner.
struct SheetPicture {
    std::string png;
    double width = 0, height = 0;
    double millimetre = 1;  ///< how many pixels one is in print
    struct Number {
        int number = 0;
        double x = 0, y = 0;
        bool strong = true;
    };
    std::vector<Number> numbers;
    struct Line {
        double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    };
    std::optional<Line> bar, arrow;
    struct Text {
        double x = 0, y = 0;
        std::string text;
    };
    std::vector<Text> texts;
};

struct TrayPictures {
    SheetPicture whole;
    std::vector<SheetPicture> slabs, stages;  ///< as the layout has them
};

struct ReportContents {
    std::string job_name, date, material, printer;  ///< empty: not known, and left out
    std::optional<double> material_density;         ///< g/cm^3: adds masses
    std::vector<TrayLayout> layout;
    std::vector<TrayPictures> pictures;  ///< by tray
    std::vector<std::string> thumbs;     ///< PNG bytes by part; empty ones: no picture
};

/// The operator's sheet: for each tray a cover with the verdict, figures, the picture and its layers; the part list; a
/// top view of each slab; the order of removal.
std::string report_html(const Packing& packing, const ReportContents& contents);

/// One row per part: part,name,mesh,scale,count,placed,left_over,reasons,volume_mm3,mass_g,numbers.
std::string report_csv(const Packing& packing, std::optional<double> material_density);

}  // namespace spectralpack
