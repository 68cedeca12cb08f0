#include "search/placement_search.hpp"

#include <algorithm>
#include <utility>

namespace spectralpack {
namespace {

class WholeGrid final : public FreeRowReader {
  public:
    explicit WholeGrid(FreePositions positions) : positions_(std::move(positions)) {}

    const VoxelIndex& origin() const override { return positions_.origin; }
    const Extent& extent() const override { return positions_.free.extent(); }
    void words(int y, int z, int first, int count, std::uint64_t* free) override {
        std::copy_n(positions_.free.row(y, z) + first, count, free);
    }

  private:
    FreePositions positions_;
};

}  // namespace

std::unique_ptr<FreeRowReader> PlacementSearch::free_rows(const Tray& tray,
                                                          std::shared_ptr<const BitGrid> solid,
                                                          const FreeQuery& query) {
    Shape shape;
    shape.orientations.resize(1);
    shape.orientations.front().solid = std::move(solid);
    return std::make_unique<WholeGrid>(free_positions(tray, shape, 0, query));
}

}  // namespace spectralpack
