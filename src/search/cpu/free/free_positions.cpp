#include "search/cpu/free/free_positions.hpp"

#include <algorithm>
#include <utility>

#include "search/cpu/free/free_tiles.hpp"

namespace spectralpack {

FreePositions FreePositionSearch::all(const Tray& tray, std::shared_ptr<const BitGrid> solid, const FreeQuery& query) {
    FreeTiles tiles(tray, kept(tray), query, std::move(solid));
    FreePositions result{tiles.origin(), BitGrid(tiles.extent())};
    const Extent& e = tiles.extent();
    FreeTiles::Rows wanted;
    wanted.fill(~std::uint64_t{0});
    for (int z = 0; z < e.z; ++z) {
        for (int y = 0; y < e.y; y += FreeTiles::kRows) {
            for (int i = 0; i < result.free.words_per_row(); ++i) {
                const FreeTiles::Told told = tiles.tell(i, y / FreeTiles::kRows, z, wanted);
                for (int row = y; row < std::min(e.y, y + FreeTiles::kRows); ++row) {
                    result.free.row(row, z)[i] = told.free[static_cast<std::size_t>(row - y)];
                }
            }
        }
    }
    return result;
}

std::unique_ptr<FreeTileReader> FreePositionSearch::tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                                          const FreeQuery& query) {
    return std::make_unique<FreeTiles>(tray, query.for_readers ? lent(tray) : kept(tray), query, std::move(solid));
}

void FreePositionSearch::drop_gone() {
    if (kept_ && kept_->tray_is_gone()) kept_ = nullptr;
}

std::shared_ptr<DilatedLayers> FreePositionSearch::kept(const Tray& tray) {
    if (kept_ && kept_->instance() == tray.instance()) {
        kept_->follow(tray);
    } else {
        kept_ = nullptr;  // goes before the others come
        kept_ = std::make_shared<DilatedLayers>(tray);
    }
    return kept_;
}

/// Those that readers of the tray as it is have, or new ones.
std::shared_ptr<DilatedLayers> FreePositionSearch::lent(const Tray& tray) {
    const auto known = lent_.find(tray.instance());
    if (known != lent_.end()) {
        std::shared_ptr<DilatedLayers> layers = known->second.lock();
        if (layers && layers->version() == tray.version()) return layers;
    }
    std::erase_if(lent_, [](const auto& lent) { return lent.second.expired(); });
    auto layers = std::make_shared<DilatedLayers>(tray);
    lent_[tray.instance()] = layers;
    return layers;
}

}  // namespace spectralpack
