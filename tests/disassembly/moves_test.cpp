/// Paths made shorter come to what trying all of them again after each change comes to, in fewer tries.

#include "disassembly/ways/moves.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/random.hpp"

namespace spectralpack::test {
namespace {

constexpr int kSide = 40;

/// Cells of a square that are free, two in five are not.
class Floor {
  public:
    explicit Floor(RandomStream& random) : free_(kSide * kSide) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            free_[i] = random.below(5) >= 2;
        }
    }

    bool at(int x, int y) const {
        return 0 <= x && x < kSide && 0 <= y && y < kSide && free_[static_cast<std::size_t>(y * kSide + x)];
    }
    bool move(Vec3 from, const Vec3& by) const {
        const AxisDirection direction = direction_of(by);
        for (double left = length(by); left > 0; --left) {
            from = from + along(direction, 1);
            if (!at(static_cast<int>(from.x), static_cast<int>(from.y))) return false;
        }
        return true;
    }

  private:
    std::vector<bool> free_;
};

/// As it is defined: the first change that is possible, then all from the start again.
std::vector<Vec3> plainly_shortened(std::vector<Vec3> path, const FreeMove& free) {
    for (bool changed = true; changed;) {
        changed = false;
        Vec3 from;
        for (std::size_t k = 0; k + 2 < path.size() && !changed; from = from + path[k++]) {
            if (direction_of(path[k]).axis != direction_of(path[k + 2]).axis) continue;
            const Vec3 both = path[k] + path[k + 2], between = path[k + 1];
            for (const auto& [one, two] : {std::pair(both, between), std::pair(between, both)}) {
                if (changed || !free(from, one) || !free(from + one, two)) continue;
                path[k] = one;
                path[k + 1] = two;
                path.erase(path.begin() + static_cast<std::ptrdiff_t>(k + 2));
                changed = true;
            }
            if (changed) break;
        }
        path = merged(path);
    }
    return path;
}

TEST(Shortened, IsWhatTryingAllAgainComesTo) {
    std::size_t before = 0, after = 0;
    std::int64_t tries = 0, plain_tries = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const Floor floor(random);
        const Vec3 start{kSide / 2, kSide / 2, 0};
        std::vector<Vec3> path;
        Vec3 at = start;
        for (int step = 0; step < 2000; ++step) {
            const Vec3 by = along({static_cast<int>(random.below(2)), random.below(2) == 0 ? 1 : -1}, 1);
            if (!floor.move(at, by)) continue;
            at = at + by;
            path.push_back(by);
        }
        path = merged(path);
        const auto counted = [&](std::int64_t& count) -> FreeMove {
            return [&](const Vec3& from, const Vec3& move) {
                ++count;
                return floor.move(start + from, move);
            };
        };
        const std::vector<Vec3> shorter = shortened(path, counted(tries));
        EXPECT_EQ(shorter, plainly_shortened(path, counted(plain_tries)));
        Vec3 end = start;
        for (const Vec3& move : shorter) {
            EXPECT_TRUE(floor.move(end, move));
            end = end + move;
        }
        EXPECT_EQ(end, at);
        before += path.size();
        after += shorter.size();
    }
    EXPECT_LT(after, before);
    EXPECT_LT(2 * tries, plain_tries);
}

}  // namespace
}  // namespace spectralpack::test
