/// The reports of pack, end to end: the operator's sheet as a browser prints it, and the table.

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "cli/program.hpp"
#include "formats/csv.hpp"

namespace spectralpack::test {
namespace {

std::vector<std::string> small_run(const std::vector<std::string>& more) {
    return std::vector<std::string>{"pack", kSamples} + kSmall + more;
}

/// The browser that prints, or nothing.
std::string browser() {
    for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
        if (std::filesystem::exists(path)) return path;
    }
    return "";
}

/// Numbers in `text` between these two pieces.
std::vector<int> numbers_between(const std::string& text, const std::string& before, const std::string& after) {
    std::vector<int> found;
    const std::regex pattern(before + "([0-9]+)" + after);
    for (auto it = std::sregex_iterator(text.begin(), text.end(), pattern); it != std::sregex_iterator(); ++it) {
        found.push_back(std::stoi((*it)[1]));
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Of all placed copies, by the order of the part list.
std::vector<int> placed_numbers(const nlohmann::json& packing) {
    std::vector<int> first{1}, numbers;
    for (const nlohmann::json& part : packing["parts"]) {
        first.push_back(first.back() + part["count"].get<int>());
    }
    for (const nlohmann::json& tray : packing["trays"]) {
        for (const nlohmann::json& placement : tray["placements"]) {
            numbers.push_back(first[placement["part"].get<std::size_t>()] + placement["copy"].get<int>());
        }
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

TEST(Report, IsASheetWithPicturesFiguresAndEveryNumber) {
    const TemporaryFolder folder;
    const std::string page = (folder / "r.html").string(), build = (folder / "b.json").string();
    const Ran ran =
        spectralpack(small_run({"--report", page, "--material-density", "1.01", "--material", "PA 12", "--job-name",
                                "Week 48 & more", "--trays", "2", "-o", build, "-o", (folder / "b.csv").string()}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {page}));
    const std::string text = read_text(page);
    EXPECT_TRUE(contains(text, "data:image/png;base64,iVBORw0KGgo"));  // a PNG's first bytes
    EXPECT_TRUE(contains(text, "Week 48 &amp; more"));
    EXPECT_TRUE(contains(text, "PA 12, 1.01\u202fg/cm³"));
    const nlohmann::json packing = read_json(build);
    ASSERT_EQ(packing["trays"].size(), 2u);
    for (const nlohmann::json& tray : packing["trays"]) {
        const double density = tray["density"];
        char figure[32];
        std::snprintf(figure, sizeof figure, "<b>%.1f<small>", 100 * density);
        EXPECT_TRUE(contains(text, figure)) << figure;
    }
    // Once beside its slab, once in the removal order, and the same in the list of transforms.
    const std::vector<int> placed = placed_numbers(packing);
    EXPECT_EQ(numbers_between(text, "</i>", "</span>"), placed);
    EXPECT_EQ(numbers_between(text, "</i>", "</td>"), placed);
    const auto rows = parse_csv("b.csv", read_text(folder / "b.csv"));
    ASSERT_EQ(rows[0].fields.back(), "number");
    std::vector<int> listed;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        listed.push_back(std::stoi(rows[i].fields.back()));
    }
    std::sort(listed.begin(), listed.end());
    EXPECT_EQ(listed, placed);
    for (const nlohmann::json& copy : packing["unplaced"]) {
        const auto part = copy["part"].get<std::size_t>();
        EXPECT_TRUE(names(text, {packing["parts"][part]["name"].get<std::string>()}));
    }
}

TEST(Report, IsNamedAfterItsFileAndLeavesOutWhatIsNotKnown) {
    const TemporaryFolder folder;
    const Ran ran =
        spectralpack(small_run({"--report", (folder / "monday.html").string(), "--keep-out", "0,0,0,20,20,70"}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    const std::string text = read_text(folder / "monday.html");
    EXPECT_TRUE(contains(text, "<h1>monday</h1>"));
    EXPECT_TRUE(contains(text, "<dt>Date</dt>"));
    for (const char* cell :
         {"<dt>Printer</dt>", "<dt>Material</dt>", "g/cm³ of tray", "<th class=\"or\">", "<th class=\"du\">"}) {
        EXPECT_FALSE(contains(text, cell)) << cell;
    }
}

TEST(Report, PrintsOnA4WithoutCutPages) {
    const std::string chromium = browser();
    if (chromium.empty()) GTEST_SKIP() << "no chromium here that could print the sheet";
    const TemporaryFolder folder;
    const Ran ran = spectralpack(small_run({"--report", (folder / "r.html").string(), "--trays", "2"}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    // A script of ours tells of every page whether it holds all that is in it.
    std::string text = read_text(folder / "r.html");
    const std::size_t pages = numbers_between(text, "page ", " of").size();
    const std::string script =
        "<script>addEventListener('load',()=>{const all=[...document.querySelectorAll('.page')];"
        "const cut=all.filter(p=>p.scrollHeight>p.clientHeight+1||p.scrollWidth>p.clientWidth+1).map(p=>all.indexOf(p)+1);"
        "document.title='pages '+all.length+' cut '+cut.join(',')+'.';});</script></body>";
    text.replace(text.rfind("</body>"), 7, script);
    std::ofstream(folder / "measured.html") << text;
    const std::vector<std::string> quiet{"--headless", "--no-sandbox", "--disable-gpu",
                                         "--user-data-dir=" + (folder / "profile").string()};
    const Ran measured = run(std::vector<std::string>{chromium} + quiet +
                             std::vector<std::string>{"--dump-dom", "file://" + (folder / "measured.html").string()});
    EXPECT_TRUE(contains(measured.out, "<title>pages " + std::to_string(pages) + " cut .</title>"))
        << measured.out.substr(0, 300) << measured.err;
    const std::string pdf = (folder / "r.pdf").string();
    run(std::vector<std::string>{chromium} + quiet +
        std::vector<std::string>{"--no-pdf-header-footer", "--print-to-pdf=" + pdf,
                                 "file://" + (folder / "r.html").string()});
    const std::string printed = read_text(pdf);
    std::size_t sheets = 0;
    const std::regex page("/Type */Page[^s]");
    for (auto it = std::sregex_iterator(printed.begin(), printed.end(), page); it != std::sregex_iterator(); ++it) {
        ++sheets;
    }
    EXPECT_EQ(sheets, pages);
}

TEST(Report, IsATableThatAgreesWithThePacking) {
    const TemporaryFolder folder;
    const Ran ran =
        spectralpack(small_run({"--report", (folder / "r.csv").string(), "-o", (folder / "b.json").string()}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    const nlohmann::json packing = read_json(folder / "b.json");
    const auto rows = parse_csv("r.csv", read_text(folder / "r.csv"));
    ASSERT_EQ(rows.size(), packing["parts"].size() + 1);
    EXPECT_EQ(rows[0].fields.back(), "numbers");
    int placed = 0, left_over = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        placed += std::stoi(rows[i].fields.at(5));
        left_over += std::stoi(rows[i].fields.at(6));
    }
    EXPECT_EQ(placed, packing["metrics"]["placed"]);
    EXPECT_EQ(left_over, static_cast<int>(packing["unplaced"].size()));
}

TEST(Report, WrongUsageIsToldBeforeWork) {
    for (const char* report : {"r.txt", "r", "no/such/folder/r.html"}) {
        const Ran ran = spectralpack(small_run({"--report", report}));
        EXPECT_EQ(ran.status, 2) << report;
        EXPECT_TRUE(names(ran.err, {"--report"}));
    }
    for (const char* density : {"0", "-1", "nan", "heavy"}) {
        const Ran ran = spectralpack(small_run({"--material-density", density}));
        EXPECT_EQ(ran.status, 2) << density;
        EXPECT_TRUE(names(ran.err, {"--material-density"}));
    }
}

}  // namespace
}  // namespace spectralpack::test
