#pragma once
/// Seeded random streams that give the same numbers on every machine and standard library.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace spectralpack {

/// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class RandomStream {
  public:
    explicit RandomStream(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    /// Uniform in [0, bound), bound > 0, without bias (rejection).
    std::uint64_t below(std::uint64_t bound) {
        const std::uint64_t limit = -bound % bound;
        for (;;) {
            const std::uint64_t value = next();
            if (value >= limit) return value % bound;
        }
    }

    /// Uniform in [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

/// The seed of the stream with that number among those that belong to `seed`; that of number 0 is `seed` itself.
inline std::uint64_t numbered_seed(std::uint64_t seed, int number) {
    return seed + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(number);
}

/// Fisher-Yates; std::shuffle may differ between standard libraries.
template <class T>
void shuffle(std::vector<T>& items, RandomStream& random) {
    for (std::size_t i = items.size(); i > 1; --i) {
        std::swap(items[i - 1], items[random.below(i)]);
    }
}

}  // namespace spectralpack
