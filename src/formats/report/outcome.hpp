#pragma once
/// What became of the copies of each part.

#include <map>
#include <string>
#include <vector>

#include "spectralpack/packing.hpp"

namespace spectralpack {

struct PartOutcome {
    struct LeftOver {
        std::vector<int> numbers;  ///< of CopyNumbers, ascending
        std::string detail;        ///< of the first copy that has one
    };

    std::vector<std::vector<int>> placed;  ///< by tray, ascending numbers
    std::map<UnplacedReason, LeftOver> left_over;

    int placed_count() const;
    int left_over_count() const;
};

/// By part.
std::vector<PartOutcome> outcomes_of(const Packing& packing);

/// "1–4, 7, 9, 10": ascending numbers in runs.
std::string runs_of(const std::vector<int>& numbers, const char* dash = "–");

}  // namespace spectralpack
