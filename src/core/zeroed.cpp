#include "core/zeroed.hpp"

#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#endif

namespace spectralpack {

#ifdef __linux__
void* allocate_zeroed(std::size_t bytes) {
    if (bytes < kHugePage) return std::calloc(1, bytes);
    // A page too many, as mappings begin on small ones; what lies around the whole ones goes back at once.
    const std::size_t size = zeroed_size(bytes);
    void* const mapped = mmap(nullptr, size + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) return nullptr;
    char* const first = static_cast<char*>(mapped);
    const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(first) % kHugePage) % kHugePage;
    if (before > 0) munmap(first, before);
    munmap(first + before + size, kHugePage - before);
    madvise(first + before, size, MADV_HUGEPAGE);  // small pages serve, too
    return first + before;
}

void free_zeroed(void* memory, std::size_t bytes) {
    if (bytes < kHugePage) {
        std::free(memory);
    } else {
        munmap(memory, zeroed_size(bytes));
    }
}

#else

void* allocate_zeroed(std::size_t bytes) { return std::calloc(1, bytes); }
void free_zeroed(void* memory, std::size_t) { std::free(memory); }

#endif

}  // namespace spectralpack
