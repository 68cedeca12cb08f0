#pragma once
/// What a walk keeps of the tiles of positions that it has touched.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "search/placement_search.hpp"

namespace spectralpack {

/// Most walks touch little of a large grid, so a row of tiles takes room from its first touch on. There are millions of
/// tiles: they lie in pieces of memory that go together, and the room of those given back is used again.
template <class Tile>
class TileMap {
    static_assert(std::is_trivially_destructible_v<Tile>);

  public:
    explicit TileMap(const Extent& extent)
        : words_((extent.x + 63) / 64),
          columns_((extent.y + FreeTileReader::kRows - 1) / FreeTileReader::kRows),
          rows_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(extent.z)) {}

    /// That of word i of row (y, z), from the tiles' origin; made by `make` when it is first touched.
    template <class Make>
    Tile& at(int i, int y, int z, const Make& make) {
        Tile* const* row = rows_[row_of(y, z)];
        if (row && row[i]) return *row[i];
        return place(i, row_of(y, z), make());
    }
    /// Gives back the room of one that at() made: from now on `instead`, which outlives the map, stands for it.
    void replace(int i, int y, int z, Tile& instead) {
        Tile*& tile = rows_[row_of(y, z)][i];
        spare_ = std::construct_at(reinterpret_cast<Spare*>(tile), Spare{spare_});
        tile = &instead;
    }
    /// Null: not touched so far.
    const Tile* find(int i, int y, int z) const {
        Tile* const* row = rows_[row_of(y, z)];
        return row ? row[i] : nullptr;
    }
    /// Of a row.
    int words() const { return words_; }

    std::int64_t bytes() const { return bytes_ + static_cast<std::int64_t>(rows_.size() * sizeof(Tile**)); }

  private:
    static constexpr std::size_t kFirstPiece = 4096, kLargestPiece = 65536;  // bytes
    /// Room given back.
    struct Spare {
        Spare* next;
    };
    static_assert(sizeof(Spare) <= sizeof(Tile) && alignof(Spare) <= alignof(Tile));

    std::size_t row_of(int y, int z) const {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(y / FreeTileReader::kRows);
    }

    Tile& place(int i, std::size_t at, const Tile& made) {
        Tile**& row = rows_[at];
        if (!row) std::uninitialized_value_construct_n(row = room_for<Tile*>(words_), words_);
        return *(row[i] = std::construct_at(spare_ ? spare_room() : room_for<Tile>(1), made));
    }

    template <class T>
    T* room_for(int count) {
        constexpr std::size_t kAlign = alignof(std::max_align_t);
        static_assert(alignof(T) <= kAlign);
        const std::size_t bytes = (static_cast<std::size_t>(count) * sizeof(T) + kAlign - 1) / kAlign * kAlign;
        if (bytes > left_) {
            piece_ = pieces_.empty() ? kFirstPiece : std::min(kLargestPiece, 2 * piece_);
            left_ = std::max(bytes, piece_);
            pieces_.push_back(std::make_unique_for_overwrite<std::byte[]>(left_));
            next_ = pieces_.back().get();
            bytes_ += static_cast<std::int64_t>(left_);
        }
        left_ -= bytes;
        return reinterpret_cast<T*>(std::exchange(next_, next_ + bytes));
    }
    Tile* spare_room() { return reinterpret_cast<Tile*>(std::exchange(spare_, spare_->next)); }

    int words_, columns_;  // of a row; of tiles along y
    std::vector<Tile**> rows_;
    std::vector<std::unique_ptr<std::byte[]>> pieces_;
    std::size_t piece_ = 0;      // bytes of the last one, if not more were asked for
    std::byte* next_ = nullptr;  // room in it that is not yet taken
    std::size_t left_ = 0;       // so many bytes
    std::int64_t bytes_ = 0;     // of all
    Spare* spare_ = nullptr;
};

}  // namespace spectralpack
