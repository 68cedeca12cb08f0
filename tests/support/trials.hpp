#pragma once
/// How many random scenes a property is tried on.

namespace spectralpack::test {

/// As many as asked for; with sanitizers, which take ten to thirty times as long, a sixth.
template <class Int>
constexpr Int trials(Int count) {
#ifdef SPECTRALPACK_SANITIZED
    return (count + 5) / 6;
#else
    return count;
#endif
}

}  // namespace spectralpack::test
