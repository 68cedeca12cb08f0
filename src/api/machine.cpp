#include "api/machine.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace spectralpack {
namespace {

constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();

std::int64_t number_in(const char* file) {
    std::ifstream in(file);
    std::int64_t value = 0;
    return in >> value ? value : kUnlimited;  // also for the word "max"
}

}  // namespace

std::int64_t available_memory() {
    std::int64_t available = kUnlimited;
    std::ifstream in("/proc/meminfo");
    std::string key, unit;
    for (std::int64_t kilobytes = 0; in >> key >> kilobytes; std::getline(in, unit)) {
        if (key == "MemAvailable:") available = kilobytes * 1024;
    }
    const std::int64_t limit = number_in("/sys/fs/cgroup/memory.max");
    if (limit != kUnlimited) {
        const std::int64_t used = number_in("/sys/fs/cgroup/memory.current");
        available = std::min(available, std::max<std::int64_t>(0, limit - (used == kUnlimited ? 0 : used)));
    }
    return available;
}

std::int64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace spectralpack
