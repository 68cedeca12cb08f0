#pragma once
/// Room for the lists of passes over brick layers, handed on from one pass to the next: threads that make lists of
/// their own, some ten thousand passes a second, wait for the allocator that they share.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <utility>
#include <vector>

namespace spectralpack {

/// Buffers, of which there come to be as many as there are threads. Thread-safe; outlives the rooms made of it.
class PassRooms {
    using Buffer = std::unique_ptr<std::byte[]>;
    static constexpr std::size_t kBytes = 1 << 19;  // the system finds memory for as much of it only as passes write

  public:
    /// One pass's: all that was taken of its memory is free again when it goes.
    class Room {
      public:
        explicit Room(PassRooms& rooms)
            : rooms_(rooms), buffer_(rooms.take()), memory_(buffer_.get(), kBytes, std::pmr::new_delete_resource()) {}
        ~Room() { rooms_.give_back(std::move(buffer_)); }
        Room(const Room&) = delete;
        Room& operator=(const Room&) = delete;

        std::pmr::memory_resource* memory() { return &memory_; }

      private:
        PassRooms& rooms_;
        Buffer buffer_;
        std::pmr::monotonic_buffer_resource memory_;  // asks the allocator for what the buffer does not hold
    };

    /// Of the buffers, as much as they can hold.
    std::int64_t bytes() const {
        const std::lock_guard lock(mutex_);
        return std::ssize(free_) * static_cast<std::int64_t>(kBytes);
    }

    /// Gives the memory back: while nobody passes.
    void clear() {
        const std::lock_guard lock(mutex_);
        free_.clear();
    }

  private:
    Buffer take() {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                Buffer buffer = std::move(free_.back());
                free_.pop_back();
                return buffer;
            }
        }
        return std::make_unique_for_overwrite<std::byte[]>(kBytes);
    }

    void give_back(Buffer buffer) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(buffer));
    }

    mutable std::mutex mutex_;  // guards what is free
    std::vector<Buffer> free_;
};

}  // namespace spectralpack
