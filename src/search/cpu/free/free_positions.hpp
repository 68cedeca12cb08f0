#pragma once
/// Which positions of any voxels are free among the objects of a tray (paper, sections 4.1 and 4.3), and what is kept
/// of trays to tell so sooner.

#include <cstdint>
#include <map>
#include <memory>

#include "search/cpu/free/dilated_layers.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

class FreePositionSearch {
  public:
    /// As PlacementSearch::free_positions() and free_tiles().
    FreePositions all(const Tray& tray, std::shared_ptr<const BitGrid> solid, const FreeQuery& query);
    std::unique_ptr<FreeTileReader> tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                          const FreeQuery& query);

    /// Drops what is kept of a tray that is gone.
    void drop_gone();
    void forget() { kept_ = nullptr; }
    std::int64_t bytes() const { return kept_ ? kept_->bytes() : 0; }

  private:
    std::shared_ptr<DilatedLayers> kept(const Tray& tray);
    std::shared_ptr<DilatedLayers> lent(const Tray& tray);

    std::shared_ptr<DilatedLayers> kept_;                         // of the tray asked about last
    std::map<std::uint64_t, std::weak_ptr<DilatedLayers>> lent_;  // to readers, by the tray's instance
};

}  // namespace spectralpack
