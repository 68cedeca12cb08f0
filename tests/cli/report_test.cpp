#include "cli/program.hpp"
#include "formats/csv.hpp"

namespace spectralpack::test {
namespace {

namespace fs = std::filesystem;

const std::string kSamples = (samples() / "samples.csv").string();

std::vector<std::string> small_run(std::initializer_list<std::string> more) {
    std::vector<std::string> arguments{"pack", kSamples, "--tray", "110x85x70", "--voxel", "4"};
    arguments.insert(arguments.end(), more);
    return arguments;
}

TEST(Report, IsAPageWithThePictureAndMasses) {
    const TemporaryFolder folder;
    const fs::path page = folder / "r.html";
    const Ran ran = spectralpack(small_run({"--report", page.string(), "--material-density", "1.01"}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, page.string())) << ran.out;
    const std::string text = read_text(page);
    EXPECT_TRUE(contains(text, "data:image/png;base64,iVBORw0KGgo"));  // a PNG's first bytes
    EXPECT_TRUE(contains(text, "Density by mass"));
    EXPECT_TRUE(contains(text, "Left over"));
    EXPECT_TRUE(contains(text, "no free place left"));
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
        EXPECT_TRUE(contains(ran.err, "--report")) << ran.err;
    }
    for (const char* density : {"0", "-1", "nan", "heavy"}) {
        const Ran ran = spectralpack(small_run({"--material-density", density}));
        EXPECT_EQ(ran.status, 2) << density;
        EXPECT_TRUE(contains(ran.err, "--material-density")) << ran.err;
    }
}

}  // namespace
}  // namespace spectralpack::test
