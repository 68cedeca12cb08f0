#include <fmt/format.h>

#include <algorithm>

#include "tools/bench/table.hpp"

namespace spectralpack::tools {
namespace {

using Words = std::vector<std::string>;

/// Sizes of things: quick ones run in seconds, so that the machinery can be tried.
struct Sizes {
    std::string tray, base;  // x x y x z and x x y, mm
    std::string tori_base, tori_wide_base;
    std::string large_tray, large_base;    // that hold the large set
    std::string coarse, fine;              // voxels, mm: the paper's 2 and 1
    std::string turned;                    // where orientations are many: the paper's 2
    std::string small_coarse, small_fine;  // for polyhedra of one or two cm: 0.25 is the paper's
    int pieces, mixtures, locks;           // copies of the fixed sets
    int large;
    Words letters;
    int restarts;
};

const Sizes& sizes(BenchScale scale) {
    static const Sizes full{
        .tray = "480x245x200",
        .base = "480x245",
        .tori_base = "120x120",
        .tori_wide_base = "240x240",
        .large_tray = "1430x730x597",
        .large_base = "1430x730",
        .coarse = "2",
        .fine = "1",
        .turned = "2",
        .small_coarse = "0.5",
        .small_fine = "0.25",
        .pieces = 500,
        .mixtures = 120,
        .locks = 150,
        .large = 1000,
        .letters = {"S", "I", "G", "R", "A", "P", "H"},
        .restarts = 20,
    };
    static const Sizes quick{
        .tray = "240x200x100",
        .base = "240x200",
        .tori_base = "120x120",
        .tori_wide_base = "240x240",
        .large_tray = "480x245x200",
        .large_base = "480x245",
        .coarse = "5",
        .fine = "4",
        .turned = "10",
        .small_coarse = "2",
        .small_fine = "1",
        .pieces = 60,
        .mixtures = 20,
        .locks = 20,
        .large = 60,
        .letters = {"I"},
        .restarts = 3,
    };
    return scale == BenchScale::full ? full : quick;
}

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

struct Benchmark {
    const char* set;
    int Sizes::*copies;  // of the fixed set
};
constexpr Benchmark kBenchmarks[]{{"pieces", &Sizes::pieces}, {"mixtures", &Sizes::mixtures}, {"locks", &Sizes::locks}};

/// The set in the tray, and its first copies on the tray's base.
Row row(const Sizes& s, const Benchmark& benchmark, std::string setting, Words options, std::string paper = "") {
    return {benchmark.set,
            std::move(setting),
            std::move(options),
            Task{benchmark.set, {"--tray", s.tray}},
            Task{fmt::format("{}:{}", benchmark.set, s.*benchmark.copies), {"--tray", s.base, "--open-height"}},
            std::move(paper)};
}

/// By set, voxel size and the table's own setting, innermost first.
using Figures = std::vector<std::vector<std::vector<std::string>>>;

Table by_voxel(Table table, const Sizes& s, const std::vector<std::pair<std::string, Words>>& settings,
               const Figures& paper) {
    const std::string voxels[]{s.coarse, s.fine};
    for (std::size_t set = 0; set < std::size(kBenchmarks); ++set) {
        for (std::size_t voxel = 0; voxel < std::size(voxels); ++voxel) {
            for (std::size_t k = 0; k < settings.size(); ++k) {
                table.rows.push_back(row(s, kBenchmarks[set],
                                         fmt::format("{}, {} mm", settings[k].first, voxels[voxel]),
                                         Words{"--voxel", voxels[voxel]} + settings[k].second, paper[set][voxel][k]));
            }
        }
    }
    return table;
}

/// The three sets, and the distorted tori on a base of their own, of which all are to stand.
Table interlocking(const Sizes& s) {
    const std::vector<std::string> settings{"off", "place", "post"};
    std::vector<std::pair<std::string, Words>> options;
    for (const std::string& setting : settings) {
        options.emplace_back(setting, Words{"--interlock", setting});
    }
    Table table = by_voxel(
        {"1", "Keeping copies from locking (Table 1)",
         "The paper packs its tori once, all of them, into 240x240x138.1 mm: 5.82 % in 32 s."},
        s, options,
        {{{"50.48 %, 104 s", "48.14 %, 422 s", "50.45 %, 103 s"},
          {"51.11 %, 428 s", "49.12 %, 1880 s", "50.48 %, 475 s"}},
         {{"36.06 %, 41 s", "29.05 %, 178 s", "34.71 %, 68 s"}, {"41.62 %, 179 s", "34.97 %, 839 s", "39.77 %, 408 s"}},
         {{"8.25 %, 15 s", "6.91 %, 71 s", "6.89 %, 124 s"}, {"9.79 %, 63 s", "7.59 %, 347 s", "8.67 %, 469 s"}}});
    for (const std::string& voxel : {s.coarse, s.fine}) {
        for (const std::string& setting : settings) {
            table.rows.push_back({"tori",
                                  fmt::format("{}, {} mm", setting, voxel),
                                  {"--voxel", voxel, "--interlock", setting},
                                  {},
                                  Task{"tori", {"--tray", s.tori_wide_base, "--open-height"}}});
        }
    }
    return table;
}

Table refinement(const Sizes& s) {
    return by_voxel({"2", "Continuous refinement (Table 2)"}, s,
                    {{"off", {"--no-refine", "--interlock", "post"}}, {"on", {"--refine", "--interlock", "post"}}},
                    {{{"48.41 %, 79 s", "50.45 %, 103 s"}, {"50.45 %, 403 s", "53.32 %, 475 s"}},
                     {{"34.19 %, 58 s", "34.71 %, 68 s"}, {"36.51 %, 384 s", "39.77 %, 408 s"}},
                     {{"6.86 %, 100 s", "6.89 %, 124 s"}, {"8.24 %, 334 s", "8.67 %, 469 s"}}});
}

/// Many trays are a fixed set by themselves; one tray that holds all is, too, by its height.
Table large(const Sizes& s) {
    Table table{"3", "The large set (Table 3)",
                "Of many trays the density is that over all. The single tray is as high as the paper's packing with "
                "interlocking looked at; beside it the whole set without a ceiling.",
                true};
    const auto add = [&](const std::string& setting, const std::string& voxel, const char* interlock, bool single,
                         const std::string& paper) {
        Row row{"large", setting, {"--voxel", voxel, "--interlock", interlock}, {}, {}, paper};
        if (single) {
            row.tray = Task{"large", {"--tray", s.large_tray}};
            row.fixed = Task{"large", {"--tray", s.large_base, "--open-height"}};
        } else {
            row.tray = Task{fmt::format("large:{}", s.large), {"--tray", s.tray}};
            row.fixed = Task{"large", {"--tray", s.tray, "--trays", "all"}};
        }
        table.rows.push_back(std::move(row));
    };
    add(fmt::format("trays, {} mm, post", s.coarse), s.coarse, "post", false, "28 trays, 35.06 %, 1456 s");
    add(fmt::format("trays, {} mm, off", s.coarse), s.coarse, "off", false, "26 trays, 37.77 %, 1010 s");
    add(fmt::format("trays, {} mm, post", s.fine), s.fine, "post", false, "26 trays, 37.30 %, 7213 s");
    add(fmt::format("trays, {} mm, off", s.fine), s.fine, "off", false, "24 trays, 40.64 %, 5103 s");
    add(fmt::format("one tray, {} mm, post", s.coarse), s.coarse, "post", true, "597 mm, 35.77 %, 14479 s");
    add(fmt::format("one tray, {} mm, off", s.coarse), s.coarse, "off", true, "538 mm, 40.28 %, 6663 s");
    return table;
}

Table peers(const Sizes& s) {
    Table table{
        "4", "Beside other programs (Table 4)",
        "The paper's figures for programs that are sold, on its own sets, so not to be compared with the rows "
        "above, density and time for pieces, mixtures, locks: Netfabb 28.23 %, 1810 s; 25.48 %, 1560 s; 3.46 %, "
        "610 s. Fabpilot 35.59 %, 684 s; none; 4.56 %, 241 s. PolyDevs 40.87 %, 3598 s; 23.16 %, 1180 s; 3.13 %, "
        "184 s."};
    const char* paper[]{"50.45 %, 103 s (313 s without GPU)", "34.71 %, 68 s (342 s)", "6.89 %, 124 s (425 s)"};
    for (std::size_t set = 0; set < std::size(kBenchmarks); ++set) {
        table.rows.push_back(row(s, kBenchmarks[set], "spectralpack", {"--voxel", s.coarse}, paper[set]));
    }
    return table;
}

Table angles(const Sizes& s) {
    Table table{"5", "Orientations (Table 5)"};
    const char* paper[][3]{{"50.48 %, 104 s", "50.02 %, 603 s", "45.39 %, 2100 s"},
                           {"34.71 %, 68 s", "35.27 %, 316 s", "35.27 %, 1052 s"},
                           {"6.89 %, 124 s", "7.88 %, 226 s", "7.57 %, 430 s"}};
    const char* steps[]{"90", "45", "30"};
    for (std::size_t set = 0; set < std::size(kBenchmarks); ++set) {
        for (std::size_t k = 0; k < std::size(steps); ++k) {
            table.rows.push_back(row(s, kBenchmarks[set], fmt::format("{}°", steps[k]),
                                     {"--voxel", s.turned, "--rotations", steps[k]}, paper[set][k]));
        }
    }
    return table;
}

/// On the grid alone, since that is what searches for an order compare.
Table orders(const Sizes& s) {
    Table table{"order", "The order of copies (Fig. 19)",
                "On the grid alone, without interlocking. In a tray that overflows an order by volume lets the denser "
                "parts in; the fixed set tells whether it packs better, too."};
    const std::vector<std::tuple<std::string, Words, std::string>> settings{
        {"random", {"--order", "random"}, "29.9 %"},
        {"size", {"--order", "size"}, "34.71 %"},
        {"volume", {"--order", "volume"}, ""},
        {"mixed", {"--order", "mixed"}, ""},
        {fmt::format("size, best of {}", s.restarts), {"--restarts", std::to_string(s.restarts)}, ""},
        {fmt::format("mixed, best of {}", s.restarts),
         {"--order", "mixed", "--restarts", std::to_string(s.restarts)},
         ""},
        {"size, beam of 5", {"--beam", "5"}, "35.06 %, 4 times the time"},
        {"mixed, beam of 5", {"--order", "mixed", "--beam", "5"}, ""}};
    for (const Benchmark& benchmark : {kBenchmarks[1], kBenchmarks[0]}) {
        for (const auto& [setting, options, paper] : settings) {
            table.rows.push_back(
                row(s, benchmark, setting,
                    Words{"--voxel", s.coarse, "--detail", "1", "--gap", "0", "--no-refine", "--interlock", "off"} +
                        options,
                    benchmark.set == kBenchmarks[1].set ? paper : ""));
        }
    }
    return table;
}

Table heights(const Sizes& s) {
    Table table{"height", "What height costs (Fig. 12)",
                "The fixed set stands in a tray that holds it all, so that p decides how high it comes; the paper's "
                "figure shows 1500 parts of pieces. 'top' counts height at the copies' tops, before proximity."};
    const std::vector<std::pair<std::string, Words>> settings{{"p = 0", {"--height-penalty", "0"}},
                                                              {"p = 4", {"--height-penalty", "4"}},
                                                              {"p = 1e8", {"--height-penalty", "1e8"}},
                                                              {"top", {"--height-at", "top"}}};
    for (const Benchmark& benchmark : kBenchmarks) {
        for (const auto& [setting, options] : settings) {
            Row wanted = row(s, benchmark, setting, Words{"--voxel", s.coarse, "--interlock", "off"} + options);
            wanted.fixed->container = {"--tray", s.tray};
            table.rows.push_back(std::move(wanted));
        }
    }
    return table;
}

Table letters_table(const Sizes& s) {
    Table table{
        "letters", "Mixtures in letters (Fig. 14)",
        "One orientation, no interlocking, as in the paper (appendix B.4), which takes 12.73 s a letter. No fixed "
        "set: some of its parts fit into no letter without being turned."};
    for (const std::string& letter : s.letters) {
        table.rows.push_back({"mixtures",
                              letter,
                              {"--voxel", s.fine, "--rotations", "none", "--interlock", "off"},
                              Task{"mixtures", {}, letter},
                              {},
                              ""});
    }
    return table;
}

Table tori(const Sizes& s) {
    Table table{"tori", "Distorted tori (Fig. 22)",
                "The paper: 5.82 % of a box of 239.98x239.98x138.13 mm in 32 s; pack3d 3.96 % in 1200 s. Beside it the "
                "least box that was found, density being that of the packing's own box."};
    const std::vector<std::tuple<std::string, Words>> settings{
        {"", {}}, {"best of 20, ", {"--restarts", "20"}}, {"beam of 5, ", {"--beam", "5"}}};
    for (const auto& [setting, options] : settings) {
        for (const std::string& voxel : {s.coarse, s.fine}) {
            Row wanted{"tori", fmt::format("{}{} mm", setting, voxel), Words{"--voxel", voxel} + options,
                       Task{"tori", {"--tray", s.tori_base + "x120"}},
                       Task{"tori", {"--tray", s.tori_base, "--open-height"}}};
            table.rows.push_back(std::move(wanted));
        }
    }
    table.rows.push_back({"tori",
                          fmt::format("least box, {} mm", s.coarse),
                          {"--voxel", s.coarse},
                          {},
                          Task{"tori", {"--tray", "240x240", "--minimise", "box"}}});
    return table;
}

Table polyhedra(const Sizes& s) {
    Table table{
        "polyhedra", "Polyhedra (Fig. 17)",
        "Ten kinds of polyhedra, each eight times, with the number, base and about the volume of those of Romanova et "
        "al. (2018), whose shapes are not available. Steps of 30 degrees, gap 0, refined, as in the paper, which uses "
        "voxels of 0.25 mm. It also quotes Romanova et al. with 53.66 % in 42950 s for 80 polyhedra, Ma et al. (2018) "
        "with 51.3 % in 2700 s for 77."};
    struct Example {
        int copies;
        const char *base, *height, *paper;
    };
    constexpr Example kExamples[]{{80, "36.98x41.98", "56.37", "51.27 %, 56.37 mm, 329 s"},
                                  {77, "36.98x40.98", "56.55", "51.53 %, 56.55 mm, 335 s"}};
    for (const Example& example : kExamples) {
        for (const std::string& voxel : {s.small_coarse, s.small_fine}) {
            for (const char* interlock : {"off", "post"}) {
                const std::string set = fmt::format("polyhedra:{}", example.copies);
                table.rows.push_back({set,
                                      fmt::format("{}, {} mm", interlock, voxel),
                                      {"--voxel", voxel, "--rotations", "30", "--gap", "0", "--interlock", interlock},
                                      Task{set, {"--tray", fmt::format("{}x{}", example.base, example.height)}},
                                      Task{set, {"--tray", example.base, "--open-height"}},
                                      voxel == s.small_fine ? example.paper : ""});
            }
        }
    }
    return table;
}

Table segments(const Sizes& s) {
    Table table{
        "segments", "Segments in the least box (Fig. 16)",
        "The paper packs what PackMerger (Vanek et al. 2014) makes of two bodies: 13 pieces of a bunny, 12 of a "
        "molecule, 1 mm apart. Those are not available: these are two bodies of our own, cut by planes, so only "
        "the seconds and the order of magnitude compare."};
    table.boxes = true;
    const std::pair<const char*, const char*> bodies[]{{"bunny", "2.90·10⁵ mm³, 19.2 s; PackMerger 4.01·10⁵ mm³"},
                                                       {"molecule", "2.09·10⁵ mm³, 27.4 s; PackMerger 3.67·10⁵ mm³"}};
    for (const auto& [body, paper] : bodies) {
        for (const char* step : {"90", "45"}) {
            for (const std::string& voxel : {s.coarse, s.fine}) {
                table.rows.push_back({body,
                                      fmt::format("{}°, {} mm", step, voxel),
                                      {"--voxel", voxel, "--rotations", step, "--gap", "1"},
                                      {},
                                      Task{body, {"--tray", "160x160", "--minimise", "box"}},
                                      paper});
            }
        }
    }
    return table;
}

}  // namespace

const std::vector<std::string>& bench_tables() {
    static const std::vector<std::string> names{"1",      "2",       "3",    "4",         "5",       "order",
                                                "height", "letters", "tori", "polyhedra", "segments"};
    return names;
}

Table make_table(const std::string& name, BenchScale scale) {
    const Sizes& s = sizes(scale);
    if (name == "1") return interlocking(s);
    if (name == "2") return refinement(s);
    if (name == "3") return large(s);
    if (name == "4") return peers(s);
    if (name == "5") return angles(s);
    if (name == "order") return orders(s);
    if (name == "height") return heights(s);
    if (name == "letters") return letters_table(s);
    if (name == "tori") return tori(s);
    if (name == "segments") return segments(s);
    return polyhedra(s);
}

}  // namespace spectralpack::tools
