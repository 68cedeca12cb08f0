/// The summary at a run's end, whole: its labels, their order, and the figures as people are told them.

#include "summary.hpp"

#include <sstream>

#include "cli/program.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

/// As many copies of each part as are placed, of those that are asked for.
struct Made {
    std::string name;
    int placed = 0;
    int asked = 0;
    UnplacedReason reason = UnplacedReason::no_place;  ///< why the others are left over
};

PackedPart part_of(const Packing& packing, const std::string& name, int count) {
    PackedPart part;
    part.id = static_cast<int>(packing.parts.size());
    part.name = name;
    part.count = count;
    part.gap = packing.options.gap;
    return part;
}

/// The packing of one tray; `Made` in the order of the parts.
PackResult packed(const std::vector<Made>& parts) {
    PackResult result;
    Packing& packing = result.packing;
    packing.container.size = {480, 245, 200};
    packing.options.tray = packing.container.size;
    TrayPacking tray;
    for (const Made& made : parts) {
        const int part = static_cast<int>(packing.parts.size());
        packing.parts.push_back(part_of(packing, made.name, made.asked));
        for (int copy = 0; copy < made.asked; ++copy) {
            if (copy < made.placed) {
                tray.placements.push_back({part, copy, 0, false, {}});
            } else {
                packing.unplaced.push_back({part, copy, made.reason, ""});
            }
        }
        packing.metrics.copies += made.asked;
        packing.metrics.placed += made.placed;
    }
    tray.density = 0.469;
    tray.height = 199.96;
    tray.disassembly = Disassembly{true, std::vector<RemovalStep>(tray.placements.size()), {}};
    packing.trays = {tray};
    packing.metrics.min_gap = 0.2;
    packing.metrics.seconds.total = 10.04;
    return result;
}

void use_printer(const char* name, Packing& packing) {
    apply(*find_printer(name), packing.options);
    packing.container.size = packing.options.tray;
    for (PackedPart& part : packing.parts) {
        part.gap = packing.options.gap;
    }
    packing.metrics.min_gap = packing.options.gap;
}

RunFacts wrote(const std::vector<std::string>& files) {
    RunFacts facts;
    facts.files_named = true;
    for (const std::string& file : files) {
        facts.written.push_back({file, {}});
    }
    return facts;
}

void expect_fits_a_screen(const std::string& summary) {
    std::istringstream lines(summary);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        EXPECT_LE(columns_of(line), 80u) << line;
    }
    EXPECT_LE(count, 22u) << summary;
}

TEST(Summary, OfARoomyJob) {
    PackResult result = packed({{"extruder-body", 6, 6}, {"corner-guard", 10, 10}});
    use_printer("hp-mjf-5200", result.packing);
    TrayPacking& tray = result.packing.trays[0];
    tray.height = 67.04;
    tray.density = 0.0065;
    result.packing.metrics.seconds.total = 0.17;
    EXPECT_EQ(summary_text(result, wrote({"build.3mf", "build.json"})),
              "All 16 copies are placed.\n"
              "\n"
              "  Tray       380 x 284 x 380 mm, HP Jet Fusion 4200, 5200\n"
              "  Height     67.0 mm of 380\n"
              "  Filled     0.7 % of the tray; 3.7 % up to that height\n"
              "  Gap        2.0 mm between copies, 5.0 mm to the walls\n"
              "  Checked    no two copies nearer than 2.00 mm; comes apart in 16 steps\n"
              "  Written    build.3mf, build.json\n"
              "  Took       0.2 s\n");
}

TEST(Summary, OfMoreThanTheTrayHolds) {
    std::vector<Made> parts{{"bracket", 246, 246},
                            {"drawer-boxes-triple-rail", 0, 1, UnplacedReason::cannot_leave},
                            {"schrank-blende-400", 0, 1},
                            {"shelf-bracket", 0, 1},
                            {"tape-measure-wall-holder-plate", 0, 1}};
    for (int i = 0; i < 36; ++i) {
        parts.push_back({"another-part-" + std::to_string(i), 0, 1});
    }
    EXPECT_EQ(summary_text(packed(parts), wrote({"mixtures.3mf"})),
              "246 of 286 copies are placed; 40 are left over.\n"
              "\n"
              "  Tray       480 x 245 x 200 mm\n"
              "  Height     200.0 mm of 200\n"
              "  Filled     46.9 % of the tray\n"
              "  Gap        0.2 mm between copies (the default; print bureaus ask for 1 mm\n"
              "             or more), 0.0 mm to the walls\n"
              "  Left over  no free place left: 39: schrank-blende-400, shelf-bracket,\n"
              "             tape-measure-wall-holder-plate and 36 more parts\n"
              "             cannot leave: 1: drawer-boxes-triple-rail\n"
              "             --trays all opens more trays; those that cannot leave were\n"
              "             caught in other copies and found no other place\n"
              "  Checked    no two copies nearer than 0.20 mm; comes apart in 246 steps\n"
              "  Written    mixtures.3mf\n"
              "  Took       10 s\n");
}

/// 47 and 7 copies.
PackResult two_trays() {
    PackResult result = packed({{"handle", 54, 54}});
    Packing& packing = result.packing;
    use_printer("formlabs-fuse1", packing);
    TrayPacking& first = packing.trays[0];
    TrayPacking second = first;
    first.placements.resize(47);
    first.disassembly->steps.resize(47);
    first.density = 0.078;
    second.placements.erase(second.placements.begin(), second.placements.begin() + 47);
    second.disassembly->steps.resize(7);
    second.density = 0.061;
    first.height = second.height = 284.1;
    packing.trays.push_back(second);
    packing.metrics.seconds.total = 1.02;
    return result;
}

TEST(Summary, OfSeveralTraysSaysWhatLeavesThroughTheWalls) {
    PackResult result = two_trays();
    EXPECT_FALSE(test::names(summary_text(result, {}), {"through the walls"}));
    result.packing.trays[1].disassembly->through_walls = {1, 3};
    EXPECT_TRUE(test::names(summary_text(result, {}), {2, 54, "through the walls"}));
}

TEST(Summary, SaysHowLongAllOfItTook) {
    RunFacts facts = wrote({"sev.json"});
    facts.seconds = 24;
    EXPECT_TRUE(test::contains(summary_text(two_trays(), facts), "Took       24 s")) << "not packing alone";
}

TEST(Summary, OfSeveralTrays) {
    RunFacts facts = wrote({"sev.3mf", "sev.json"});
    facts.written[0].trays = {"sev-1.3mf", "sev-2.3mf"};
    EXPECT_EQ(summary_text(two_trays(), facts),
              "All 54 copies are placed, in 2 trays.\n"
              "\n"
              "  Tray       165 x 165 x 300 mm, Formlabs Fuse 1, Fuse 1+\n"
              "\n"
              "             copies   height   filled   comes apart\n"
              "     1           47    284.1    7.8 %   in 47 steps\n"
              "     2            7    284.1    6.1 %   in 7 steps\n"
              "\n"
              "  Gap        2.0 mm between copies, 3.0 mm to the walls\n"
              "  Checked    no two copies nearer than 2.00 mm\n"
              "  Written    sev-1.3mf, sev-2.3mf; side by side: sev.3mf; all: sev.json\n"
              "  Took       1 s\n");
}

TEST(Summary, OfManyTraysNamesTheFirstTheLastAndTheNearlyEmpty) {
    PackResult result = two_trays();
    result.packing.trays.insert(result.packing.trays.begin(), 10, result.packing.trays.front());
    result.packing.trays.back().density = 0.01;
    const std::string text = summary_text(result, {});
    for (const char* row : {"\n     1 ", "\n     6 ", "\n     …\n", "\n    12 ", "in 7 steps, nearly empty\n"}) {
        EXPECT_TRUE(test::contains(text, row)) << row << text;
    }
    EXPECT_FALSE(test::contains(text, "\n     7 ")) << text;
    expect_fits_a_screen(text);
}

TEST(Summary, OfNothingPlaced) {
    PackResult result = packed({{"jig-base", 0, 1, UnplacedReason::too_large}});
    use_printer("formlabs-fuse1", result.packing);
    EXPECT_EQ(summary_text(result, {}),
              "Nothing is placed, and nothing was written.\n"
              "\n"
              "  Tray       165 x 165 x 300 mm, Formlabs Fuse 1, Fuse 1+\n"
              "  Left over  larger than the tray: 1: jig-base\n");
}

TEST(Summary, OfATimeLimit) {
    PackResult result = packed({{"bracket", 119, 119}, {"hook", 0, 41}, {"lid", 0, 126, UnplacedReason::not_tried}});
    result.stopped = StopReason::time_limit;
    result.packing.options.time_limit = 6;
    result.packing.trays[0].disassembly.reset();
    result.packing.metrics.seconds.total = 6.2;
    EXPECT_EQ(summary_text(result, wrote({"mix.json"})),
              "Time limit of 6 s reached. Best so far: 119 of 286 copies are placed.\n"
              "\n"
              "  Tray       480 x 245 x 200 mm\n"
              "  Height     200.0 mm of 200\n"
              "  Filled     46.9 % of the tray\n"
              "  Gap        0.2 mm between copies (the default; print bureaus ask for 1 mm\n"
              "             or more), 0.0 mm to the walls\n"
              "  Left over  not tried (time limit): 126\n"
              "             no free place left: 41: 41 hook\n"
              "             --trays all opens more trays\n"
              "  Checked    no two copies nearer than 0.20 mm\n"
              "             NOT CHECKED whether it comes apart: do not print it before\n"
              "             'spectralpack plan mix.json -o mix.json' has said so\n"
              "  Written    mix.json\n"
              "  Took       6.2 s\n");
    result.stopped = StopReason::cancelled;
    EXPECT_TRUE(test::contains(summary_text(result, {}), "Interrupted. Best so far: 119 of 286 copies are placed.\n"));
}

TEST(Summary, OfABuildThatWasToppedUp) {
    PackResult result = packed({{"base", 4, 4}, {"clip", 8, 8}});
    for (std::size_t i = 0; i < 4; ++i) {
        result.packing.trays[0].placements[i].fixed = true;
    }
    RunFacts facts = wrote({"b.json"});
    facts.taken.file = "old/base.json";
    facts.taken.container = facts.taken.gap = facts.taken.wall_gap = true;
    facts.onto_height = 199.97;
    const std::string text = summary_text(result, facts);
    EXPECT_TRUE(text.starts_with("All 8 new copies are placed; 4 stood there before.\n")) << text;
    EXPECT_TRUE(test::contains(text, "  Tray       480 x 245 x 200 mm, as in base.json\n")) << text;
    EXPECT_TRUE(test::contains(text, "  Height     200.0 mm of 200, as before\n")) << text;
    EXPECT_TRUE(test::contains(text, " mm to the walls, as in base.json\n")) << text;
    EXPECT_TRUE(test::contains(text, "; 8 new copies come apart\n")) << "a job has fixed the others: " << text;
    TrayPacking& tray = result.packing.trays[0];
    for (std::size_t i = 0; i < 12; ++i) {
        tray.placements[i].before = i < 4;
        tray.disassembly->steps[i].placements = {static_cast<int>(i)};
    }
    EXPECT_TRUE(test::contains(summary_text(result, facts), "comes apart in 12 steps\n"));
    tray.disassembly->steps.erase(tray.disassembly->steps.begin(), tray.disassembly->steps.begin() + 4);
    const std::string staying = summary_text(result, facts);
    EXPECT_TRUE(test::contains(staying, "; 8 new copies come apart; 4")) << staying;
}

TEST(Summary, OfATrayThatWasFilledInShares) {
    PackResult result = packed({{"extruder-body", 39, 39}, {"fan-shroud", 123, 123}});
    result.packing.options.fill = true;
    result.packing.parts[0].share = 1;
    result.packing.parts[1].share = 3;
    const std::string text = summary_text(result, {});
    EXPECT_TRUE(text.starts_with("The tray is full: 162 copies.\n")) << text;
    EXPECT_TRUE(test::contains(text, "  Of each    39 extruder-body, 123 fan-shroud: 1 : 3.2 for the 1 : 3 asked,\n"))
        << text;
}

TEST(Summary, SaysWhatAllRequiredMeans) {
    RunFacts facts = wrote({"b.json"});
    facts.require_all = true;
    const std::string text = summary_text(packed({{"bracket", 10, 16}}), facts);
    EXPECT_TRUE(
        text.ends_with("\n6 copies are left over, and --require-all asks for all: exit 5. More trays take\n"
                       "them: --trays all.\n"))
        << text;
}

/// Many trays, long names, copies left over for several reasons, a note on the gap.
TEST(Summary, FitsAScreenWhereThereIsMuchToSay) {
    PackResult result = two_trays();
    Packing& packing = result.packing;
    packing.trays.insert(packing.trays.begin(), 40, packing.trays.front());
    packing.options.printer.reset();
    packing.options.gap = 0.25;
    const UnplacedReason reasons[] = {UnplacedReason::no_place, UnplacedReason::too_large,
                                      UnplacedReason::cannot_leave};
    for (const UnplacedReason reason : reasons) {
        for (int i = 0; i < 40; ++i) {
            packing.unplaced.push_back({static_cast<int>(packing.parts.size()), 0, reason, ""});
            packing.parts.push_back(part_of(packing, "a part with a länger name " + std::to_string(i), 1));
        }
    }
    packing.metrics.copies += 120;
    RunFacts facts = wrote({"builds/week-48.3mf", "builds/week-48.json"});
    for (int i = 1; i <= 42; ++i) {
        facts.written[0].trays.push_back("builds/week-48-" + std::to_string(i) + ".3mf");
    }
    const std::string text = summary_text(result, facts);
    expect_fits_a_screen(text);
    for (const char* said : {"0.25 mm", "week-48-1.3mf to builds/week-48-42.3mf", "and 39 more parts"}) {
        EXPECT_TRUE(test::contains(text, said)) << text;
    }
    for (const UnplacedReason reason : reasons) {
        EXPECT_TRUE(test::contains(text, in_words(reason))) << text;
    }
}

/// Nobody but those who ask for details is told of threads and memory.
TEST(Summary, HasDetailsWhereTheyAreAskedFor) {
    PackResult result = packed({{"bracket", 10, 10}});
    result.packing.metrics.engine = "cpu";
    result.packing.metrics.threads = 3;
    result.packing.metrics.peak_memory = 192'000'000;
    RunFacts facts = wrote({"b.json"});
    const std::vector<test::Fact> details{"cpu", 3, "threads", 192, "MB"};
    EXPECT_FALSE(test::names(summary_text(result, facts), {"MB"}));
    facts.details = true;
    EXPECT_TRUE(test::names(summary_text(result, facts), details));
}

/// The words of programmers.
TEST(Summary, IsInPlainWordsAndSoIsTheRestOfARun) {
    const test::TemporaryFolder folder;
    const test::Ran ran = test::spectralpack(
        {"pack", test::kSamples, "--tray", "110x85x70", "--voxel", "4", "-o", (folder / "b.json").string()});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const test::Ran check = test::spectralpack({"check", (folder / "b.json").string()});
    for (const char* word : {"search", "interlock", "container", "density", "engine", "orientation", "unplaced"}) {
        for (const std::string& text : {ran.out, ran.err, check.out, check.err}) {
            EXPECT_FALSE(test::names(text, {word})) << text;
        }
    }
    EXPECT_TRUE(ran.out.starts_with(std::to_string(test::read_json(folder / "b.json")["metrics"]["placed"].get<int>())))
        << "the verdict comes first: " << ran.out;
}

}  // namespace
}  // namespace spectralpack::cli
