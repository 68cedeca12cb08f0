#pragma once
/// Large arrays of zeros whose pages take no memory before something else is written to them.

#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace spectralpack {

/// Asks the system for zeros instead of writing them.
template <class T>
struct ZeroedAllocator {
    static_assert(std::is_trivially_copyable_v<T>);
    using value_type = T;

    ZeroedAllocator() = default;
    template <class U>
    ZeroedAllocator(const ZeroedAllocator<U>&) {}

    T* allocate(std::size_t count) {
        if (void* memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
        throw std::bad_alloc();
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }

    void construct(T*) {}  // it is 0 already
    template <class... Value>
    void construct(T* at, Value&&... value) {
        ::new (static_cast<void*>(at)) T(std::forward<Value>(value)...);
    }
    bool operator==(const ZeroedAllocator&) const { return true; }
};

/// Of a size that it is made with: elements that resize() adds later need not be 0.
template <class T>
using ZeroedVector = std::vector<T, ZeroedAllocator<T>>;

}  // namespace spectralpack
