#pragma once
/// The fixture of what every engine must answer.

#include <gtest/gtest.h>

#include <memory>

#include "brute_force.hpp"
#include "engines.hpp"
#include "random_scene.hpp"
#include "search/verifying_search.hpp"

namespace spectralpack::test {

class EngineTest : public testing::TestWithParam<EngineFactory> {
  protected:
    std::unique_ptr<PlacementSearch> make_engine(int threads = 2) const { return GetParam().make(Workers(threads)); }
    /// The engine with the definition looking over its shoulder: throws at the first difference.
    VerifyingSearch make_verified() const { return {make_engine(), std::make_unique<BruteForceSearch>(), {}}; }
};

inline std::shared_ptr<const BitGrid> full_box(const Extent& extent) {
    BitGrid box(extent);
    box.fill(true);
    return std::make_shared<const BitGrid>(std::move(box));
}

inline Shape one_box(std::uint64_t id, const Extent& extent) { return {id, 0, {plain_shape(full_box(extent))}}; }

}  // namespace spectralpack::test
