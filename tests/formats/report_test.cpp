#include "formats/report/report.hpp"

#include <expat.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>

#include "formats/csv.hpp"
#include "packings.hpp"
#include "support/names.hpp"

namespace spectralpack::test {
namespace {

const char* const kHostile = "<script>alert(\"1\")</script>,'&\n\x01\xff";

/// Two trays, three copies placed; one left over as too large, two as the tray was full.
Packing reported() {
    Packing packing = small_packing();
    packing.parts[0].name = kHostile;
    packing.parts[0].mesh = "a,\"b\"\n.stl";
    packing.parts[0].count = 5;
    packing.parts[0].repairs = {"turned <i>facets</i>", "dropped 2 facets"};
    packing.unplaced = {{0, 2, UnplacedReason::no_place, ""},
                        {0, 3, UnplacedReason::too_large, "is <b>wide</b>"},
                        {0, 4, UnplacedReason::no_place, ""}};
    packing.parts[1].numbers.clear();
    packing.metrics.copies = 6;
    return packing;
}

int count_of(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

bool contains(const std::string& text, const std::string& part) { return count_of(text, part) > 0; }

/// Boxes of 10 mm that stand on one another.
std::vector<std::vector<Box>> stacked(const Packing& packing) {
    std::vector<std::vector<Box>> boxes;
    for (const TrayPacking& tray : packing.trays) {
        boxes.emplace_back();
        for (std::size_t i = 0; i < tray.placements.size(); ++i) {
            boxes.back().push_back({{0, 0, 10.0 * double(i)}, {10, 10, 10.0 * double(i) + 10}});
        }
    }
    return boxes;
}

/// With pictures that hold no picture.
ReportContents contents_of(const Packing& packing) {
    ReportContents contents;
    contents.job_name = "Week 48";
    contents.layout = sheet_layout(packing, stacked(packing));
    for (const TrayLayout& layout : contents.layout) {
        TrayPictures pictures;
        pictures.whole.png = "f";
        pictures.whole.width = pictures.whole.height = 100;
        pictures.slabs.resize(layout.slabs.size(), pictures.whole);
        pictures.stages.resize(layout.stages.size(), pictures.whole);
        contents.pictures.push_back(pictures);
    }
    contents.thumbs.resize(packing.parts.size(), "fo");
    return contents;
}

std::string page_of(const Packing& packing) { return report_html(packing, contents_of(packing)); }

/// All text between tags, a blank for each tag. Fails where the page is not well-formed XML.
std::string text_of(const std::string& page) {
    std::string text;
    XML_Parser parser = XML_ParserCreate("UTF-8");
    XML_SetUserData(parser, &text);
    XML_SetCharacterDataHandler(parser, [](void* into, const char* piece, int size) {
        static_cast<std::string*>(into)->append(piece, static_cast<std::size_t>(size));
    });
    XML_SetEndElementHandler(parser, [](void* into, const char*) { static_cast<std::string*>(into)->append(" "); });
    const bool parsed = XML_Parse(parser, page.data(), static_cast<int>(page.size()), 1) == XML_STATUS_OK;
    EXPECT_TRUE(parsed) << XML_ErrorString(XML_GetErrorCode(parser)) << " in line " << XML_GetCurrentLineNumber(parser);
    XML_ParserFree(parser);
    return text;
}

/// A tray of so many parts with so many copies each, and a plan that takes one after the other.
Packing long_list(int parts, int copies) {
    Packing packing = small_packing();
    packing.parts.assign(static_cast<std::size_t>(parts), packing.parts[0]);
    packing.trays.resize(1);
    TrayPacking& tray = packing.trays[0];
    tray.placements.clear();
    tray.disassembly = Disassembly{true, {}, {}};
    packing.unplaced.clear();
    for (int part = 0; part < parts; ++part) {
        packing.parts[static_cast<std::size_t>(part)].count = copies;
        for (int copy = 0; copy < copies; ++copy) {
            tray.disassembly->steps.push_back({{static_cast<int>(tray.placements.size())}, {{0, 0, 50}}});
            tray.placements.push_back({part, copy, 0, false, {}});
        }
    }
    return packing;
}

TEST(Report, EscapesWhateverComesFromFiles) {
    const std::string page = page_of(reported());
    EXPECT_FALSE(contains(page, "<script"));
    EXPECT_FALSE(contains(page, "<b>wide"));
    EXPECT_TRUE(contains(page, "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;"));
    EXPECT_EQ(page.find('\x01'), std::string::npos);
    EXPECT_EQ(page.find('\xff'), std::string::npos);
}

TEST(Report, IsWellFormedXml) { EXPECT_TRUE(contains(text_of(page_of(reported())), "Operator’s sheet")); }

TEST(Report, NamesNothingOutsideThePage) {
    const std::string page = page_of(reported());
    EXPECT_EQ(count_of(page, "http"), 1);  // the name space
    const std::regex reference("(src|href|url)[=(]\"?([^\" )]*)");
    for (auto it = std::sregex_iterator(page.begin(), page.end(), reference); it != std::sregex_iterator(); ++it) {
        const std::string target = (*it)[2];
        EXPECT_TRUE(target.starts_with("data:image/png;base64,") || target.starts_with("#")) << target;
    }
}

TEST(Report, EncodesPicturesWhateverTheirLength) {
    const std::map<std::string, std::string> known{
        {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {std::string("\xff\x00\x80", 3), "/wCA"}};
    for (const auto& [bytes, text] : known) {
        ReportContents contents = contents_of(reported());
        contents.thumbs[0] = bytes;
        EXPECT_TRUE(contains(report_html(reported(), contents), "base64," + text + "\"")) << text;
    }
}

TEST(Report, TellsEachReasonWithItsOwnDetail) {
    const std::string text = text_of(page_of(reported()));
    std::string full = in_words(UnplacedReason::no_place), large = in_words(UnplacedReason::too_large);
    full[0] = static_cast<char>(std::toupper(full[0]));
    large[0] = static_cast<char>(std::toupper(large[0]));
    EXPECT_TRUE(contains(text, "3 of 6 copies, not in any tray"));
    EXPECT_TRUE(contains(text, "No. 3, 5")) << text;
    EXPECT_TRUE(contains(text, full + ". Needs another tray."));
    EXPECT_TRUE(contains(text, "No. 4"));
    EXPECT_TRUE(contains(text, large + ": is <b>wide</b>."));
}

TEST(Report, LeavesOutWhatIsNotKnown) {
    ReportContents contents = contents_of(reported());
    const std::string bare = text_of(report_html(reported(), contents));
    for (const char* cell : {"Date", "Printer", "Material", "g/cm³"}) {
        EXPECT_FALSE(contains(bare, cell)) << cell;
    }
    contents.date = "28 Nov 2026";
    contents.printer = "Fuse 1";
    contents.material = "PA 12";
    contents.material_density = 2;
    Packing packing = reported();
    packing.trays[0].density = 0.1;
    const std::string text = text_of(report_html(packing, contents));
    EXPECT_TRUE(names(text, {"28 Nov 2026", "Fuse 1", "PA 12", "2\u202fg/cm³", "0.20\u202fg/cm³ of tray"}));
}

TEST(Report, HasColumnsForOrdersAndDatesOnlyWhereThereAreSome) {
    EXPECT_TRUE(names(text_of(page_of(reported())), {"A-2291", "1\u00a0Dec"}));
    Packing packing = reported();
    packing.parts[0].due.clear();
    packing.parts[0].order.clear();
    const std::string page = page_of(packing);
    EXPECT_FALSE(contains(page, "<th class=\"or\">"));
    EXPECT_FALSE(contains(page, "<th class=\"du\">"));
}

TEST(Report, TheVerdictIsWhatThePlanSays) {
    Packing packing = reported();
    EXPECT_TRUE(contains(text_of(page_of(packing)), "Comes apart in 1\u00a0step; 1 of them"));
    EXPECT_TRUE(contains(text_of(page_of(packing)), "Does not come apart:  2 hold each other."));
    packing.trays[1].disassembly->interlocked.clear();
    EXPECT_TRUE(contains(text_of(page_of(packing)), "Not checked to the end whether it comes apart."));
    packing.trays[1].disassembly.reset();
    EXPECT_TRUE(contains(text_of(page_of(packing)), "Not checked whether it comes apart."));
}

TEST(Report, StepsThroughTheWallsAreToldInVerdictAndOrder) {
    Packing packing = long_list(2, 3);
    packing.trays[0].disassembly->unpack = Unpack::top;
    EXPECT_FALSE(contains(text_of(page_of(packing)), "sideways"));
    packing.trays[0].disassembly->through_walls = {1, 4};
    const std::string page = page_of(packing), text = text_of(page);
    EXPECT_TRUE(contains(text, "Comes apart in 6\u00a0steps; 2 of them sideways through the walls."));
    for (int step = 1; step <= 6; ++step) {
        const std::string number = std::to_string(step);
        const bool marked = step == 2 || step == 5;
        EXPECT_EQ(count_of(page, "<td class=\"st\">" + number + "‖</td>"), marked ? 1 : 0) << step;
        EXPECT_EQ(count_of(page, "<td class=\"st\">" + number + "</td>"), marked ? 0 : 1) << step;
    }
    EXPECT_TRUE(contains(text, "‖ : sideways through the walls"));
}

TEST(Report, WhyAPartIsLeftOverIsSaidToItsEnd) {
    Packing packing = reported();
    const std::string detail =
        "120 x 90 x 30 mm, and there is room for 100 x 80 x 60 mm. It fits into HP Jet Fusion 4200, "
        "5200: --printer hp-mjf-5200";
    const auto height_of = [&](const std::string& why) {
        packing.unplaced[1].detail = why;
        return sheet_layout(packing, stacked(packing))[0].hero_height;
    };
    packing.parts[0].name = "a";
    const double few = height_of("wide");
    EXPECT_LT(height_of(detail + detail + detail), few) << "rows take the room that their text needs";
    const std::string page = page_of(packing);
    EXPECT_TRUE(contains(text_of(page), detail + detail + detail));
    EXPECT_FALSE(contains(page, "max-height: 7.6mm")) << "a row cuts nothing off";
}

TEST(Report, GivesEachMoveAnArrowAndALength) {
    Packing packing = reported();
    const auto rows_with = [&](const std::vector<Vec3>& path) {
        packing.trays[0].disassembly = Disassembly{true, {{{0}, path}}, {}};
        return page_of(packing);
    };
    EXPECT_TRUE(contains(rows_with({{0, 0, 70}}), "<use href=\"#au\"/></svg><b>70</b>"));
    EXPECT_TRUE(contains(rows_with({{0, 0, -5}, {-30, 0, 0}, {0, -8, 0}}), "3 moves"));
    for (const char* move : {"<use href=\"#ad\"/></svg><b>5</b>", "<use href=\"#al\"/></svg><b>30</b>",
                             "<use href=\"#af\"/></svg><b>8</b>"}) {
        EXPECT_TRUE(contains(rows_with({{0, 0, -5}, {-30, 0, 0}, {0, -8, 0}}), move)) << move;
    }
    // Small ones are dropped, those that go on are joined, slanting ones are said by their parts.
    EXPECT_TRUE(contains(rows_with({{0, 0, 30}, {0.3, 0, 0}, {0, 0, 40}}), "<b>70</b>"));
    EXPECT_TRUE(
        contains(rows_with({{40, 30, 0}}),
                 "<use href=\"#ar\"/></svg><b>40</b>+<svg viewBox=\"0 0 16 16\" class=\"arrow\"><use href=\"#ab\"/>"
                 "</svg><b>30</b>"));
    std::vector<Vec3> many;
    for (int i = 0; i < 4; ++i) {
        many.insert(many.end(), {{0, 0, 5}, {5, 0, 0}});
    }
    EXPECT_TRUE(contains(rows_with(many), "by hand"));
}

TEST(Report, LongListsFlowOnAndSayEveryNumberOnce) {
    for (const auto& [parts, copies] : {std::pair{3, 2}, {9, 1}, {60, 4}, {200, 5}}) {
        const Packing packing = long_list(parts, copies);
        const std::string page = page_of(packing);
        text_of(page);
        const int pages = count_of(page, "<section class=\"page\">");
        EXPECT_TRUE(contains(page, "page " + std::to_string(pages) + " of " + std::to_string(pages)));
        EXPECT_EQ(count_of(page, "<tr class=\"part"), parts);
        for (int number = 1; number <= parts * copies; ++number) {
            // In a list beside its slab, and in the removal order.
            EXPECT_EQ(count_of(page, "</i>" + std::to_string(number) + "</span>"), 1) << number;
            EXPECT_EQ(count_of(page, "</i>" + std::to_string(number) + "</td>"), 1) << number;
        }
        if (parts <= 8) {
            EXPECT_EQ(pages, 2);
        } else {
            EXPECT_GE(pages, 4);
        }
    }
}

TEST(Report, AGroupIsFramedWithItsParting) {
    Packing packing = long_list(2, 3);
    packing.trays[0].disassembly->steps = {{{5}, {{0, 0, 9}}}, {{1, 2}, {{0, 0, 60}}}, {{1}, {{20, 0, 0}}},
                                           {{2}, {}},          {{0}, {{0, 0, 9}}},     {{3}, {{0, 0, 9}}},
                                           {{4}, {}}};
    const std::string page = page_of(packing), text = text_of(page);
    EXPECT_TRUE(contains(text, "2 copies as one group"));
    EXPECT_TRUE(contains(text, "then parted outside, steps 3 to 4:"));
    EXPECT_EQ(count_of(page, "<tr class=\"g g1"), 1);
    EXPECT_EQ(count_of(page, "g9\">"), 1);
}

TEST(Report, StagesLeaveOutWhatHasLeft) {
    const Packing packing = long_list(9, 5);
    const std::vector<int> stages = sheet_layout(packing, stacked(packing))[0].stages;
    EXPECT_EQ(stages.size(), 4u);
    for (const int step : stages) {
        const std::vector<bool> left = left_after(packing.trays[0], step);
        EXPECT_EQ(std::count(left.begin(), left.end(), true), 45 - step);
        EXPECT_TRUE(contains(text_of(page_of(packing)),
                             "after step " + std::to_string(step) + ": " + std::to_string(45 - step) + "  left"));
    }
}

TEST(Report, TheTableReadsBackAndAddsUp) {
    const Packing packing = reported();
    const auto rows = parse_csv("report.csv", report_csv(packing, 1.25));
    ASSERT_EQ(rows.size(), 1 + packing.parts.size());
    std::map<std::string, std::size_t> column;
    for (std::size_t i = 0; i < rows[0].fields.size(); ++i) {
        column[rows[0].fields[i]] = i;
    }
    std::int64_t placed = 0, left_over = 0;
    for (std::size_t i = 0; i < packing.parts.size(); ++i) {
        const PackedPart& part = packing.parts[i];
        const auto field = [&](const char* name) { return rows[i + 1].fields.at(column.at(name)); };
        EXPECT_EQ(field("name"), part.name);
        EXPECT_EQ(field("mesh"), part.mesh);
        EXPECT_EQ(std::stoi(field("count")), part.count);
        EXPECT_EQ(std::stoi(field("placed")) + std::stoi(field("left_over")), part.count);
        EXPECT_EQ(std::stod(field("volume_mm3")), part.volume);
        EXPECT_DOUBLE_EQ(std::stod(field("mass_g")), part.volume * 1.25 / 1000);
        placed += std::stoi(field("placed"));
        left_over += std::stoi(field("left_over"));
    }
    EXPECT_EQ(placed, packing.metrics.placed);
    EXPECT_EQ(left_over, static_cast<std::int64_t>(packing.unplaced.size()));
    EXPECT_EQ(rows[1].fields.at(column.at("reasons")), "2 no_place; 1 too_large");
    EXPECT_EQ(rows[1].fields.at(column.at("numbers")), "1 to 5");
    EXPECT_EQ(rows[2].fields.at(column.at("numbers")), "6");
}

}  // namespace
}  // namespace spectralpack::test
