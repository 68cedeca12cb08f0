#pragma once
/// How long a run will take, found by running it for a few seconds.

#include <optional>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// Where few copies are placed, a probe takes up to so many times as long.
inline constexpr double kProbePatience = 4;

struct ProbedTime {
    double seconds = 0;  ///< of the whole run; where packed is 0, of the attempt
    double packed = 0;   ///< share of the copies it is known from, 0..1; 1: the run came to its end
};

/// Packs `job` for about `seconds` and extends what that took to all copies, as if they took alike: the large ones
/// come first and the empty tray is quicker than the full one, so it is a guess within a factor of two or three.
/// None where the run cannot start (too little memory). Throws what pack() throws otherwise.
/// Ends early where `stop` is requested, and requests it itself.
std::optional<ProbedTime> probe_time(const Job& job, double seconds, StopSource& stop);

}  // namespace spectralpack::cli
