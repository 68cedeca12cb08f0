#pragma once
/// The box around what stands, as copies leave: without looking at all of them each time.

#include <array>
#include <cstdint>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

class StandingHull {
  public:
    /// Of boxes 0, 1, ...; O(n log n).
    explicit StandingHull(const std::vector<Box>& boxes);

    /// The next one. O(n).
    void add(const Box& box);
    /// Constant, but for what lay within it and left before.
    void remove(std::size_t i);

    /// Around those that stand, less `members` (ascending); empty where no others stand. Time grows with the members
    /// and with those that left that lie further out than the others.
    Box without(const std::vector<std::size_t>& members) const;

  private:
    struct Side {
        double reach;  ///< how far out
        std::size_t of;

        bool operator<(const Side& other) const { return reach != other.reach ? reach < other.reach : of < other.of; }
    };
    static constexpr std::size_t kSides = 6;  ///< -x, +x, -y, +y, -z, +z

    std::vector<bool> present_;
    std::array<std::vector<Side>, kSides> sides_;  ///< ascending: the outermost last, and that one stands
};

}  // namespace spectralpack
