#include "api/machine.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <limits>

#include "support/process.hpp"
#include "support/sanitized.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();

/// A system's files.
class Machine : public testing::Test {
  protected:
    void file(const std::string& name, const std::string& text) {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }
    std::int64_t available() const { return available_memory(folder_.path()); }
    std::int64_t within() const { return memory_within_limits(folder_.path()); }

    test::TemporaryFolder folder_;
};

TEST_F(Machine, HasWhatIsFree) {
    file("proc/meminfo", "MemTotal:  9000 kB\nMemFree:  10 kB\nMemAvailable:  5000 kB\nHugePages_Total:  0\n");
    EXPECT_EQ(available(), 5000 * 1024);
    EXPECT_EQ(within(), kUnlimited);
}

TEST_F(Machine, LessWhereTheContainerIsAGroupOfEitherVersion) {
    file("proc/meminfo", "MemAvailable:  5000 kB\n");
    file("sys/fs/cgroup/memory.max", "3000000\n");
    file("sys/fs/cgroup/memory.current", "1000000\n");
    file("sys/fs/cgroup/memory.stat", "anon 1\ninactive_file 400000\nfile 7\n");
    EXPECT_EQ(available(), 2'400'000) << "file pages are given up";
    file("sys/fs/cgroup/memory/memory.limit_in_bytes", "2000000\n");
    file("sys/fs/cgroup/memory/memory.usage_in_bytes", "500000\n");
    file("sys/fs/cgroup/memory/memory.stat", "inactive_file 9\ntotal_inactive_file 100000\n");
    EXPECT_EQ(available(), 1'600'000);
}

TEST_F(Machine, TheLeastOfAllGroupsAboveTheProcessCounts) {
    file("proc/self/cgroup", "5:cpu,memory:/job/run\n1:name=systemd:/x\n0::/user/app\n");
    EXPECT_EQ(within(), kUnlimited) << "none says a number";
    file("sys/fs/cgroup/user/app/memory.max", "max\n");
    file("sys/fs/cgroup/user/memory.max", "7000000\n");
    file("sys/fs/cgroup/user/memory.current", "2000000\n");
    EXPECT_EQ(within(), 5'000'000);
    file("sys/fs/cgroup/memory/job/run/memory.limit_in_bytes", "9223372036854771712\n");
    file("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "4000000\n");
    EXPECT_EQ(within(), 4'000'000);
    file("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "9000000\n");
    EXPECT_EQ(within(), 0);
}

TEST_F(Machine, LimitsOnAddressesAndDataCount) {
    if (test::kSanitized) GTEST_SKIP() << "sanitizers take addresses of their own";
    file("proc/self/status", "Name:\tx\nVmSize:\t  100000 kB\nVmData:\t   50000 kB\n");
    const pid_t child = fork();
    if (child == 0) {
        test::limit(RLIMIT_AS, rlim_t{300000} << 10);
        const bool addresses = within() == std::int64_t{200000} << 10 && limits_addresses();
        test::limit(RLIMIT_DATA, rlim_t{200000} << 10);
        const bool data = within() == std::int64_t{150000} << 10;
        _exit(!addresses ? 1 : !data ? 2 : 0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace spectralpack
