#pragma once
/// What chance decides about a generated part.

#include <vector>

#include "core/random.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}

    /// Uniform in [low, high).
    double between(double low, double high) { return low + (high - low) * random_.unit(); }

    /// A length in [low, high] in whole tenths of a millimetre, 0.1 at least.
    double mm(double low, double high);

    /// Uniform in low, ..., high.
    int number(int low, int high) {
        return low + static_cast<int>(random_.below(static_cast<std::uint64_t>(high - low + 1)));
    }

    bool chance(double share) { return random_.unit() < share; }

    /// From a distribution given by values at evenly spaced quantiles, linear in between.
    double quantile(const std::vector<double>& values);

    /// One of the 24 rotations of the cube: exact.
    Mat3 cube_rotation();

  private:
    RandomStream random_;
};

}  // namespace spectralpack::tools
