#include "time_shares.hpp"

#include <algorithm>

namespace spectralpack::cli {
namespace {

// Of a time limit, kept for writing and for planning: shares, and no more than so many seconds. How long the plan takes
// grows with what stands, as placing does (docs/conventions.md).
constexpr double kWriting = 0.07, kDrawing = 0.2, kPlanning = 0.3;
constexpr double kMostWriting = 10, kMostDrawing = 60;
// Drawn plainly, pictures still take so many seconds; for that a third is kept at most.
constexpr double kLeastDrawing = 2.5, kMostOfAll = 0.33;
// A picture that is nearly done at the end is worth so many seconds more.
constexpr double kOver = 0.3;

}  // namespace

TimeShares time_shares(const JobSettings& settings) {
    const bool draws =
        std::ranges::any_of(settings.outputs, is_picture) ||
        std::ranges::any_of(settings.reports, [](const std::string& report) { return ending_of(report) == ".html"; });
    const double limit = settings.options.time_limit.value_or(0);
    const auto at_most = [&](double share, double seconds) {
        return limit > 0 ? std::min(share, seconds / limit) : share;
    };
    const double drawing = std::max(at_most(kDrawing, kMostDrawing), at_most(kMostOfAll, kLeastDrawing));
    const double writing = draws ? drawing : at_most(kWriting, kMostWriting);
    const bool plans = settings.options.interlock != Interlock::off;
    TimeShares shares;
    shares.planning = 1 - writing;
    shares.placing = (plans ? 1 - kPlanning : 1) * shares.planning;
    shares.drawing = 1 - 0.75 * writing;
    if (limit > 0) shares.drawn = 1 + kOver / limit;
    return shares;
}

}  // namespace spectralpack::cli
