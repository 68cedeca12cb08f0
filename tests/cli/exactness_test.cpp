/// The cpu engine's answers on whole sets, each asked of the reference engine again: minutes to hours a run, so
/// labelled `long` (scripts/test.sh -L long). On the benchmark's sets where they are, else on the samples and on
/// generated sets like those.

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

/// Placements. The program counts a sample on all copies, but copies of what no longer fits are not searched for.
constexpr int kAsked = 450, kEnough = 300;

struct Setting {
    std::string name, set, voxel;
    std::vector<std::string> options;
};

std::string name_of(const testing::TestParamInfo<Setting>& info) { return info.param.name; }
void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.name; }

class Exactness : public testing::TestWithParam<Setting> {
  protected:
    /// The arguments that name the set.
    std::vector<std::string> input() const {
        const std::string& set = GetParam().set;
        if (const auto data = benchmark_data()) {
            return {(*data / "sets" / (set + ".csv")).string(), "--mesh-dir", (*data / "meshes").string()};
        }
        if (set == "quick") return {(samples() / "samples.csv").string()};
        const Ran made = spectralpack({"generate", set, "-o", folder_.path().string()});
        EXPECT_EQ(made.status, 0) << made.err;
        return {(folder_ / (set + ".csv")).string(), "--mesh-dir", folder_.path().string()};
    }

    TemporaryFolder folder_;
};

TEST_P(Exactness, TheReferenceEngineFindsNoDifference) {
    const Setting& setting = GetParam();
    std::vector<std::string> call{"pack"};
    for (const auto& more :
         {input(), setting.options,
          std::vector<std::string>{"--voxel", setting.voxel, "--tray", "480x245x200", "--no-refine", "--interlock",
                                   "off", "--verify-with", "reference:" + std::to_string(kAsked), "-o",
                                   (folder_ / "build.json").string()}}) {
        call.insert(call.end(), more.begin(), more.end());
    }
    const Ran ran = spectralpack(call);
    // An interrupted run fails, but says how far it came: interrupt the program alone, not the test with it.
    ASSERT_TRUE(ran.status == 0 || ran.status == 130) << ran.err;
    const json metrics = read_json(folder_ / "build.json")["metrics"];
    const int searches = metrics["searches"], verified = metrics["verified"];
    std::printf("%d of %d searches answered alike\n", verified, searches);
    EXPECT_EQ(ran.status, 0) << "interrupted";
    EXPECT_GE(verified, std::min(searches, kEnough));
}

std::vector<Setting> settings() {
    std::vector<Setting> all;
    const std::vector<std::string> paper{"--detail", "1", "--gap", "0"};
    const auto add = [&](const std::string& name, const std::string& set, const std::string& voxel,
                         const std::vector<std::string>& options) {
        for (const std::string penalty : {"4", "1e8"}) {
            all.push_back({name + "_p" + penalty, set, voxel, options});
            all.back().options.insert(all.back().options.end(), {"--height-penalty", penalty});
        }
    };
    for (const std::string set : {"quick", "mixtures", "locks", "pieces"}) {
        add(set + "_2mm", set, "2", paper);
    }
    add("quick_2mm_detail2", "quick", "2", {});
    add("mixtures_2mm_detail2", "mixtures", "2", {});
    add("mixtures_1mm", "mixtures", "1", paper);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Sets, Exactness, testing::ValuesIn(settings()), name_of);

}  // namespace
}  // namespace spectralpack::test
