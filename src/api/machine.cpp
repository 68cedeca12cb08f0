#include "api/machine.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();

/// None also for the word "max".
std::optional<std::int64_t> number_in(const fs::path& file) {
    std::ifstream in(file);
    std::int64_t value = 0;
    return in >> value ? std::optional(value) : std::nullopt;
}

/// The number behind `key` at the beginning of a line.
std::optional<std::int64_t> entry_in(const fs::path& file, const std::string& key) {
    std::ifstream in(file);
    std::string word;
    for (std::int64_t value = 0; in >> word; std::getline(in, word)) {
        if (word == key && in >> value) return value;
        in.clear();
    }
    return std::nullopt;
}

/// The files of one version of control groups.
struct GroupFiles {
    const char* limit;
    const char* used;
    const char* reclaimable;  ///< of what is used, in memory.stat: file pages that are given up where memory is wanted
};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};

/// What the group in `folder` leaves.
std::int64_t left_in_group(const fs::path& folder, const GroupFiles& files) {
    const std::optional<std::int64_t> limit = number_in(folder / files.limit);
    if (!limit) return kUnlimited;
    const std::int64_t used = number_in(folder / files.used).value_or(0);
    const std::int64_t reclaimable = entry_in(folder / "memory.stat", files.reclaimable).value_or(0);
    return std::max<std::int64_t>(0, *limit - std::max<std::int64_t>(0, used - reclaimable));
}

/// What the group and all above it leave. In a container the group's path is that on its host; what is mounted then is
/// the container's own group.
std::int64_t left_in_groups(const fs::path& mounted, const std::string& group, const GroupFiles& files) {
    std::int64_t left = left_in_group(mounted, files);
    for (fs::path path = fs::path(group).relative_path(); !path.empty(); path = path.parent_path()) {
        left = std::min(left, left_in_group(mounted / path, files));
    }
    return left;
}

std::int64_t left_in_all_groups(const fs::path& root) {
    const fs::path mounted = root / "sys/fs/cgroup";
    std::int64_t left = std::min(left_in_group(mounted, kVersion2), left_in_group(mounted / "memory", kVersion1));
    std::ifstream in(root / "proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {  // hierarchy:controllers:path
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const std::string group = line.substr(second + 1);
        if (controllers == ",,") left = std::min(left, left_in_groups(mounted, group, kVersion2));
        if (controllers.find(",memory,") != std::string::npos) {
            left = std::min(left, left_in_groups(mounted / "memory", group, kVersion1));
        }
    }
    return left;
}

/// What a limit of the process leaves of what /proc/self/status calls `used`.
std::int64_t left_of_limit(const fs::path& root, decltype(RLIMIT_AS) resource, const std::string& used) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur >= static_cast<rlim_t>(kUnlimited)) return kUnlimited;
    const std::int64_t taken = 1024 * entry_in(root / "proc/self/status", used).value_or(0);
    return std::max<std::int64_t>(0, static_cast<std::int64_t>(limit.rlim_cur) - taken);
}

}  // namespace

std::int64_t memory_within_limits(const fs::path& root) {
    return std::min({left_in_all_groups(root), left_of_limit(root, RLIMIT_AS, "VmSize:"),
                     left_of_limit(root, RLIMIT_DATA, "VmData:")});
}

std::int64_t available_memory(const fs::path& root) {
    const std::optional<std::int64_t> free = entry_in(root / "proc/meminfo", "MemAvailable:");
    return std::min(free ? 1024 * *free : kUnlimited, memory_within_limits(root));
}

bool limits_addresses() {
    rlimit limit{};
    return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < static_cast<rlim_t>(kUnlimited);
}

std::int64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace spectralpack
