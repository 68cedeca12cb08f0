#include "search/placement_search.hpp"

#include <algorithm>
#include <utility>

namespace spectralpack {
namespace {

class WholeGrid final : public FreeTileReader {
  public:
    explicit WholeGrid(FreePositions positions) : positions_(std::move(positions)) {}

    const VoxelIndex& origin() const override { return positions_.origin; }
    const Extent& extent() const override { return positions_.free.extent(); }
    Told tell(int i, int j, int z, const Rows&) override {
        Told told;
        told.known.fill(~std::uint64_t{0});
        for (int y = 0; y < std::min(kRows, extent().y - kRows * j); ++y) {
            told.free[static_cast<std::size_t>(y)] = positions_.free.row(kRows * j + y, z)[i];
        }
        return told;
    }

  private:
    FreePositions positions_;
};

}  // namespace

std::unique_ptr<FreeTileReader> PlacementSearch::free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                                            const FreeQuery& query) {
    Shape shape;
    shape.orientations.resize(1);
    shape.orientations.front().solid = std::move(solid);
    return std::make_unique<WholeGrid>(free_positions(tray, shape, 0, query));
}

}  // namespace spectralpack
