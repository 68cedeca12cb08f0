#pragma once
/// What a walk keeps of the tiles of positions that it has touched.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <type_traits>
#include <vector>

#include "search/placement_search.hpp"

namespace spectralpack {

/// Most walks touch little of a large grid, so a row of tiles takes room from its first touch on. Tiles go together,
/// and there are millions of them: they lie in a few pieces of memory.
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
        Tile**& row = rows_[row_of(y, z)];
        if (!row) std::uninitialized_value_construct_n(row = room_for<Tile*>(words_), words_);
        Tile*& tile = row[i];
        if (!tile) tile = std::construct_at(room_for<Tile>(1), make());
        return *tile;
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
    static constexpr std::size_t kFirstPiece = 4096;  // bytes

    std::size_t row_of(int y, int z) const {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(y / FreeTileReader::kRows);
    }

    template <class T>
    T* room_for(int count) {
        const auto bytes = static_cast<std::size_t>(count) * sizeof(T);
        bytes_ += static_cast<std::int64_t>(bytes);
        return static_cast<T*>(memory_.allocate(bytes, alignof(T)));
    }

    int words_, columns_;  // of a row; of tiles along y
    std::vector<Tile**> rows_;
    std::int64_t bytes_ = 0;  // of tiles and rows of them
    std::pmr::monotonic_buffer_resource memory_{kFirstPiece};
};

}  // namespace spectralpack
