#pragma once
/// Large arrays of zeros whose pages take no memory before something else is written to them.

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace spectralpack {

/// Arrays of so many bytes or more lie on huge pages where the system has such. Searches jump about in tables of many
/// megabytes, and a processor remembers where some thousand pages are, which is enough for large ones only.
inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// What an array of so many bytes takes at most: huge pages come whole.
constexpr std::size_t zeroed_size(std::size_t bytes) {
    return bytes < kHugePage ? bytes : (bytes + kHugePage - 1) / kHugePage * kHugePage;
}

/// `bytes` of zeros, which the system is asked for instead of writing them; null where it has none.
void* allocate_zeroed(std::size_t bytes);
/// Of what allocate_zeroed(bytes) returned.
void free_zeroed(void* memory, std::size_t bytes);

/// Gives containers what allocate_zeroed() does.
template <class T>
struct ZeroedAllocator {
    static_assert(std::is_trivially_copyable_v<T>);
    using value_type = T;

    ZeroedAllocator() = default;
    template <class U>
    ZeroedAllocator(const ZeroedAllocator<U>&) {}

    T* allocate(std::size_t count) {
        if (void* memory = allocate_zeroed(count * sizeof(T))) return static_cast<T*>(memory);
        throw std::bad_alloc();
    }
    void deallocate(T* memory, std::size_t count) { free_zeroed(memory, count * sizeof(T)); }

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
