#include "cli/program.hpp"
#include "formats/csv.hpp"

namespace spectralpack::test {
namespace {

std::vector<std::string> small_run(const std::vector<std::string>& more) {
    return std::vector<std::string>{"pack", kSamples} + kSmall + more;
}

TEST(Report, IsAPageWithThePictureAndMasses) {
    const TemporaryFolder folder;
    const std::string page = (folder / "r.html").string(), build = (folder / "b.json").string();
    const Ran ran = spectralpack(small_run({"--report", page, "--material-density", "1.01", "-o", build}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(names(ran.out, {page}));
    const std::string text = read_text(page);
    EXPECT_TRUE(contains(text, "data:image/png;base64,iVBORw0KGgo"));  // a PNG's first bytes
    const nlohmann::json packing = read_json(build);
    const double density = packing["metrics"]["density"];
    EXPECT_TRUE(names(text, {100 * density, "%", 1.01 * density, "g/cm"}));
    ASSERT_GT(packing["unplaced"].size(), 0u);
    EXPECT_TRUE(names(text, {packing["unplaced"].size()}));
    for (const nlohmann::json& copy : packing["unplaced"]) {
        const auto part = copy["part"].get<std::size_t>();
        EXPECT_TRUE(names(text, {packing["parts"][part]["name"].get<std::string>()}));
    }
}

TEST(Report, IsATableThatAgreesWithThePacking) {
    const TemporaryFolder folder;
    const Ran ran =
        spectralpack(small_run({"--report", (folder / "r.csv").string(), "-o", (folder / "b.json").string()}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    const nlohmann::json packing = read_json(folder / "b.json");
    const auto rows = parse_csv("r.csv", read_text(folder / "r.csv"));
    ASSERT_EQ(rows.size(), packing["parts"].size() + 1);
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
