#pragma once
/// Stretches: few neighbours along x, positions or blocks, of which sums are made. What is wanted of a row lies close
/// together, so a sum has room for two stretches from wherever in the tray.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace spectralpack {

/// Neighbours of a stretch.
inline constexpr int kStretch = 16;
/// What is summed up at once: two stretches.
inline constexpr int kLanes = 2 * kStretch;

/// `lanes`, a set in [0, kStretch), of the neighbours from x on in row y, both counted from the corner of the tile or
/// pair of bricks that is looked at.
struct Stretch {
    int x, y;
    std::uint32_t lanes;
};

/// Calls visit(x, lanes) for stretches that hold all bits of a row, each of which begins with one.
template <class Visit>
void for_each_stretch(std::uint64_t bits, const Visit& visit) {
    while (bits != 0) {
        const int x = std::countr_zero(bits);
        const auto lanes = static_cast<std::uint32_t>(bits >> x & ((1u << kStretch) - 1));
        visit(x, lanes);
        bits &= ~(static_cast<std::uint64_t>(lanes) << x);
    }
}

/// The stretches of some rows of kBits bits in all.
template <int kBits>
class Stretches {
  public:
    void add(int y, std::uint64_t bits) {
        for_each_stretch(bits, [&](int x, std::uint32_t lanes) { stretches_[count_++] = {x, y, lanes}; });
    }
    std::span<const Stretch> all() const { return {stretches_.data(), count_}; }

  private:
    static_assert(kBits % kStretch == 0);
    std::array<Stretch, kBits / kStretch> stretches_;  // the first count_
    std::size_t count_ = 0;
};

}  // namespace spectralpack
