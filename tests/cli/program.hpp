#pragma once
/// End-to-end runs of the built program.

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/data.hpp"
#include "support/names.hpp"
#include "support/process.hpp"

namespace spectralpack::test {

/// The settings of whoever runs the tests are theirs.
inline const bool kNoUserSettings = setenv("XDG_CONFIG_HOME", "/nonexistent", 1) == 0;

inline Ran spectralpack(std::vector<std::string> arguments, const Moment& interrupt_when = {},
                        const Limits& limits = {}) {
    arguments.insert(arguments.begin(), SPECTRALPACK_PROGRAM);
    return run(arguments, interrupt_when, limits);
}

inline std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// The small set that comes with the sources.
inline const std::string kSamples = (samples() / "samples.csv").string();

/// A tray small and coarse enough for the reference engine; it does not hold all samples.
inline const std::vector<std::string> kSmall{"--tray", "110x85x70", "--voxel", "4"};

/// `pack input` with each of these options ends with status 2.
inline void expect_refused(const std::vector<std::vector<std::string>>& wrong, const std::string& input) {
    for (const auto& options : wrong) {
        const Ran ran = spectralpack(std::vector<std::string>{"pack", input} + options);
        EXPECT_EQ(ran.status, 2) << options.front() << ": " << ran.err;
    }
}

inline nlohmann::json read_json(const std::filesystem::path& path) { return nlohmann::json::parse(read_text(path)); }

/// What `check --json` finds; its exit status must be this one.
inline nlohmann::json check_report(const std::string& packing, int status) {
    const Ran ran = spectralpack({"check", "--json", packing});
    EXPECT_EQ(ran.status, status) << ran.out << ran.err;
    return nlohmann::json::parse(ran.out);
}

/// Those lines that are JSON objects: what `--progress json` says.
inline std::vector<nlohmann::json> json_lines(const std::string& text) {
    std::vector<nlohmann::json> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        nlohmann::json entry = nlohmann::json::parse(line, nullptr, false);
        if (entry.is_object()) found.push_back(std::move(entry));
    }
    return found;
}

/// Whether `--progress json` said such a line.
inline Moment reported(const std::function<bool(const nlohmann::json&)>& wanted) {
    return [wanted](const std::string& err) {
        const std::vector<nlohmann::json> lines = json_lines(err);
        return std::any_of(lines.begin(), lines.end(), wanted);
    };
}

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
