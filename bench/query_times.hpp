#pragma once
/// How long questions of one kind take.

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <vector>

#include "core/stopwatch.hpp"

namespace spectralpack {

/// Milliseconds of each question.
struct QueryTimes {
    std::vector<double> ms;

    template <class Work>
    void time(const Work& work) {
        const Stopwatch watch;
        work();
        ms.push_back(1e3 * watch.seconds());
    }
    double mean() const {
        return ms.empty() ? 0 : std::accumulate(ms.begin(), ms.end(), 0.0) / static_cast<double>(ms.size());
    }
    double quantile(double share) const {
        if (ms.empty()) return 0;
        std::vector<double> sorted = ms;
        std::ranges::sort(sorted);
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    }
    /// One line, where there are any.
    void print(const char* what) const {
        if (ms.empty()) return;
        std::printf("  %-40s %7zu times, mean %.3f ms, median %.3f, 95%% %.3f, longest %.3f\n", what, ms.size(), mean(),
                    quantile(0.5), quantile(0.95), quantile(1));
    }
};

}  // namespace spectralpack
