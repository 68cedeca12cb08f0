#pragma once
/// End-to-end runs of the built program.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/data.hpp"
#include "support/process.hpp"

namespace spectralpack::test {

inline Ran spectralpack(std::vector<std::string> arguments, const std::string& interrupt_when = "",
                        const Limits& limits = {}) {
    arguments.insert(arguments.begin(), SPECTRALPACK_PROGRAM);
    return run(arguments, interrupt_when, limits);
}

/// `pack input` with each of these options ends with status 2.
inline void expect_refused(const std::vector<std::vector<std::string>>& wrong, const std::string& input) {
    for (const auto& options : wrong) {
        std::vector<std::string> call{"pack", input};
        call.insert(call.end(), options.begin(), options.end());
        const Ran ran = spectralpack(call);
        EXPECT_EQ(ran.status, 2) << options.front() << ": " << ran.err;
    }
}

inline nlohmann::json read_json(const std::filesystem::path& path) { return nlohmann::json::parse(read_text(path)); }

/// The phases are apart, and take no longer than the whole.
inline void expect_phases_apart(const nlohmann::json& packing) {
    const nlohmann::json& seconds = packing["metrics"]["seconds"];
    double sum = 0;
    for (const auto& [phase, taken] : seconds.items()) {
        EXPECT_GE(taken, 0) << seconds;
        if (phase != "total") sum += taken.get<double>();
    }
    EXPECT_LE(sum, seconds["total"].get<double>() + 1e-6) << seconds;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace spectralpack::test
