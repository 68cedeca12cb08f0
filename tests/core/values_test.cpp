#include <gtest/gtest.h>

#include "core/checked.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {
namespace {

TEST(CheckedProduct, RefusesWhatDoesNotFit) {
    EXPECT_EQ(checked_product({3, 4, 5}), 60);
    EXPECT_EQ(checked_product({0, INT64_MAX, INT64_MAX}), 0);
    EXPECT_EQ(checked_product({INT64_MAX, 1}), INT64_MAX);
    EXPECT_THROW(checked_product({std::int64_t{1} << 32, std::int64_t{1} << 31}), ResourceError);
    EXPECT_THROW(checked_product({-1, 4}), ResourceError);
}

TEST(InputError, NamesFilePlaceAndCause) {
    const InputError error("a.stl", "line 7", "not a number");
    EXPECT_STREQ(error.what(), "a.stl: line 7: not a number");
    EXPECT_STREQ(InputError("a.stl", "", "is empty").what(), "a.stl: is empty");
}

TEST(StopToken, TheFirstReasonStays) {
    StopSource source;
    const StopToken token = source.token();
    EXPECT_FALSE(token.stopped());
    source.request(StopReason::time_limit);
    source.request(StopReason::cancelled);
    EXPECT_EQ(token.reason(), StopReason::time_limit);
    EXPECT_FALSE(StopToken().stopped());
}

}  // namespace
}  // namespace spectralpack
