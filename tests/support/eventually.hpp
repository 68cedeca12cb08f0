#pragma once
/// Waiting for what other threads do.

#include <chrono>
#include <thread>

namespace spectralpack::test {

/// True once `holds()` is; false when it is not for so long that it never will be.
template <class Condition>
bool eventually(const Condition& holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!holds()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::yield();
    }
    return true;
}

}  // namespace spectralpack::test
