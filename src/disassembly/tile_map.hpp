#pragma once
/// What a walk keeps of the tiles of positions that it has touched.

#include <cstddef>
#include <memory>
#include <vector>

#include "search/placement_search.hpp"

namespace spectralpack {

/// Most walks touch little of a large grid, so a row of tiles takes room from its first touch on.
template <class Tile>
class TileMap {
  public:
    explicit TileMap(const Extent& extent)
        : words_((extent.x + 63) / 64),
          columns_((extent.y + FreeTileReader::kRows - 1) / FreeTileReader::kRows),
          rows_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(extent.z)) {}

    /// That of word i of row (y, z), from the tiles' origin; null while it has not been touched.
    std::unique_ptr<Tile>& at(int i, int y, int z) {
        Row& row = rows_[static_cast<std::size_t>(z) * static_cast<std::size_t>(columns_) +
                         static_cast<std::size_t>(y / FreeTileReader::kRows)];
        if (!row) row = std::make_unique<std::unique_ptr<Tile>[]>(static_cast<std::size_t>(words_));
        return row[static_cast<std::size_t>(i)];
    }
    /// Of a row.
    int words() const { return words_; }

  private:
    using Row = std::unique_ptr<std::unique_ptr<Tile>[]>;

    int words_, columns_;  // of a row; of tiles along y
    std::vector<Row> rows_;
};

}  // namespace spectralpack
