#pragma once
/// What tests do less of under sanitizers, with which programs take ten to thirty times as long.

namespace spectralpack::test {

#ifdef SPECTRALPACK_SANITIZED
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// How many random scenes a property is tried on: as many as asked for, or a sixth.
template <class Int>
constexpr Int trials(Int count) {
    return kSanitized ? (count + 5) / 6 : count;
}

}  // namespace spectralpack::test
