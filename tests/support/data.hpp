#pragma once
/// Where tests find files: the repository's own samples, and the benchmark data beside a checkout when it is
/// there (tests that need it say 'skipped' when it is not).

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace spectralpack::test {

inline std::filesystem::path samples() { return std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / "data" / "samples"; }

/// The benchmark data: $SPECTRALPACK_DATA, else ../shared/data beside the checkout.
inline std::optional<std::filesystem::path> benchmark_data() {
    std::filesystem::path folder = std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / ".." / "shared" / "data";
    if (const char* named = std::getenv("SPECTRALPACK_DATA")) folder = named;
    if (!std::filesystem::is_directory(folder / "meshes")) return std::nullopt;
    return std::filesystem::canonical(folder);
}

}  // namespace spectralpack::test

/// Skips the running test, saying so, where the benchmark data is not there.
#define SPECTRALPACK_NEEDS_DATA() \
    if (!spectralpack::test::benchmark_data()) GTEST_SKIP() << "the benchmark data is not here"
