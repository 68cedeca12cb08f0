#include "disassembly/standing_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"

namespace spectralpack {
namespace {

TEST(StandingHull, IsTheBoxAroundWhatStandsLessTheMembers) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        RandomStream random(seed);
        const auto box = [&] {
            // Coarse, so that several reach as far as each other.
            const Vec3 low{1.0 * static_cast<double>(random.below(6)), 1.0 * static_cast<double>(random.below(6)),
                           1.0 * static_cast<double>(random.below(6))};
            return Box{low, low + Vec3{2, 1, 3}};
        };
        std::vector<Box> boxes;
        for (std::uint64_t k = random.below(12); k > 0; --k) {
            boxes.push_back(box());
        }
        StandingHull hull(boxes);
        std::vector<bool> present(boxes.size(), true);
        for (int change = 0; change < 30; ++change) {
            if (random.below(3) == 0) {
                boxes.push_back(box());
                present.push_back(true);
                hull.add(boxes.back());
            } else if (!boxes.empty()) {
                const std::size_t i = random.below(boxes.size());
                if (present[i]) hull.remove(i);
                present[i] = false;
            }
            std::vector<std::size_t> members;
            Box expected;
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                if (random.below(4) == 0) {
                    members.push_back(i);
                } else if (present[i]) {
                    expected.add(boxes[i]);
                }
            }
            ASSERT_EQ(hull.without(members), expected) << seed;
        }
    }
}

}  // namespace
}  // namespace spectralpack
