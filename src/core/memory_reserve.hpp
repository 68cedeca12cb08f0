#pragma once
/// Memory kept for the time when there is none left.

#include <cstdint>
#include <memory>

namespace spectralpack {

/// A block that is given back when an allocation has failed, so that what was done by then can be recorded and written.
/// Its pages are never touched: it takes room under limits on addresses, and no memory.
class MemoryReserve {
  public:
    /// Throws std::bad_alloc.
    explicit MemoryReserve(std::int64_t bytes) : block_(new char[static_cast<std::size_t>(bytes)]) {}

    void release() { block_.reset(); }

  private:
    std::unique_ptr<char[]> block_;
};

}  // namespace spectralpack
