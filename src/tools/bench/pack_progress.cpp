#include "tools/bench/pack_progress.hpp"

#include <cinttypes>
#include <cstdio>

namespace spectralpack::tools {

std::optional<BenchProgress> parse_progress(const std::string& line) {
    BenchProgress progress;
    char phase[16];
    double left = 0;
    const int read = std::sscanf(line.c_str(),
                                 "{\"phase\": \"%15[a-z]\", \"done\": %" SCNd64 ", \"total\": %" SCNd64
                                 ", \"density\": %*[^,], \"seconds\": %lf, \"left\": %lf",
                                 phase, &progress.done, &progress.total, &progress.seconds, &left);
    if (read < 4) return std::nullopt;
    progress.phase = phase;
    if (read == 5) progress.left = left;  // else it is null
    return progress;
}

}  // namespace spectralpack::tools
