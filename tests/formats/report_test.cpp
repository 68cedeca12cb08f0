#include "formats/report.hpp"

#include <gtest/gtest.h>

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

TEST(Report, EscapesWhateverComesFromFiles) {
    const std::string page = report_html(reported(), {});
    EXPECT_FALSE(contains(page, "<script"));
    EXPECT_FALSE(contains(page, "<i>"));
    EXPECT_FALSE(contains(page, "<b>"));
    EXPECT_TRUE(contains(page, "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;"));
    EXPECT_EQ(page.find('\x01'), std::string::npos);
    EXPECT_EQ(page.find('\xff'), std::string::npos);
}

TEST(Report, EveryTagIsClosed) {
    ReportExtras extras;
    extras.material_density = 1.01;
    extras.pictures = {"picture"};
    const std::string page = report_html(reported(), extras);
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-z0-9]+)([^>]*)>");
    for (auto it = std::sregex_iterator(page.begin(), page.end(), tag); it != std::sregex_iterator(); ++it) {
        const std::string name = (*it)[2], rest = (*it)[3];
        if (name == "meta" || name == "img" || (!rest.empty() && rest.back() == '/')) continue;
        if ((*it)[1].length() == 0) {
            open.push_back(name);
        } else {
            ASSERT_FALSE(open.empty()) << name;
            EXPECT_EQ(open.back(), name);
            open.pop_back();
        }
    }
    EXPECT_TRUE(open.empty());
}

TEST(Report, NamesNothingOutsideThePage) {
    ReportExtras extras;
    extras.pictures = {"p"};
    const std::string page = report_html(reported(), extras);
    EXPECT_FALSE(contains(page, "http"));
    EXPECT_EQ(count_of(page, "src="), 1);
    EXPECT_TRUE(contains(page, "src=\"data:image/png;base64,cA==\""));
}

TEST(Report, EncodesPicturesWhateverTheirLength) {
    const std::map<std::string, std::string> known{
        {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {std::string("\xff\x00\x80", 3), "/wCA"}};
    for (const auto& [bytes, text] : known) {
        ReportExtras extras;
        extras.pictures = {bytes};
        EXPECT_TRUE(contains(report_html(reported(), extras), "base64," + text + "\"")) << text;
    }
}

/// The row of a table that says `text`.
std::string row_with(const std::string& page, const std::string& text) {
    const std::size_t at = page.find(text);
    EXPECT_NE(at, std::string::npos) << text << " is not in " << page;
    if (at == std::string::npos) return "";
    const std::size_t begin = page.rfind("<tr>", at);
    return page.substr(begin, page.find("</tr>", at) - begin);
}

TEST(Report, TellsEachReasonWithItsOwnDetail) {
    const std::string page = report_html(reported(), {});
    EXPECT_TRUE(names(row_with(page, in_words(UnplacedReason::no_place)), {2}));
    const std::string detail = "is &lt;b&gt;wide&lt;/b&gt;";
    EXPECT_TRUE(names(row_with(page, detail), {1, in_words(UnplacedReason::too_large)}));
}

TEST(Report, PlotsOneBarALayer) {
    const Packing packing = reported();
    std::size_t layers = 0;
    for (const TrayPacking& tray : packing.trays) {
        layers += tray.layers.area.size();
    }
    EXPECT_EQ(count_of(report_html(packing, {}), "<rect"), static_cast<int>(layers));
}

TEST(Report, HasMassesOnlyWithADensity) {
    EXPECT_FALSE(names(report_html(reported(), {}), {"mass"}));
    ReportExtras extras;
    extras.material_density = 2;
    Packing packing = reported();
    packing.trays[0].density = 0.1;
    const std::string page = report_html(packing, extras);
    EXPECT_TRUE(names(page, {"mass", 0.2, "g/cm"}));
}

TEST(Report, TheTableReadsBackAndAddsUp) {
    ReportExtras extras;
    extras.material_density = 1.25;
    const Packing packing = reported();
    const auto rows = parse_csv("report.csv", report_csv(packing, extras));
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
}

}  // namespace
}  // namespace spectralpack::test
