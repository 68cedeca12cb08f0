#include "packing/reachable_search.hpp"

#include <algorithm>
#include <utility>

#include "disassembly/flood_fill.hpp"
#include "voxel/enclosed.hpp"

namespace spectralpack {
namespace {

constexpr std::uint64_t kOwnIds = std::uint64_t{1} << 63;

// Pockets of one orientation after which everything unreachable is looked for: that costs as much as dozens of them.
constexpr int kPockets = 24;

}  // namespace

SearchResult ReachableSearch::best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                             const StopToken& stop) {
    // Something left since: what could not be reached perhaps can be now.
    const bool shrunk = std::any_of(tray.journal().begin() + static_cast<std::ptrdiff_t>(
                                        tray_ == tray.instance() ? std::min(journal_, tray.journal().size()) : 0),
                                    tray.journal().end(), [](const TrayChange& change) { return !change.added; });
    if (tray_ != tray.instance() || shape_ != shape.id || shrunk) {
        excluded_.assign(shape.orientations.size(), nullptr);
        ++asked_;
    }
    tray_ = tray.instance();
    shape_ = shape.id;
    journal_ = tray.journal().size();

    Shape asked = shape;
    asked.id = kOwnIds + asked_;
    for (std::size_t i = 0; i < excluded_.size(); ++i) {
        asked.orientations[i].excluded = excluded_[i];
    }
    std::vector<int> pockets(shape.orientations.size(), 0);
    for (;;) {
        SearchResult result = engine_.best_placement(tray, asked, model, stop);
        if (result.stopped || !result.best) return result;
        const auto index = static_cast<std::size_t>(result.best->index);
        OrientedShape& oriented = asked.orientations[index];
        if (pockets[index] > kPockets) return result;
        std::optional<BitGrid> excluded = pocket(tray, oriented, result.best->position);
        if (!excluded) return result;
        if (++pockets[index] > kPockets) excluded = unreachable(tray, oriented);
        if (oriented.excluded) unite(*excluded, *oriented.excluded, {});
        oriented.excluded = excluded_[index] = std::make_shared<const BitGrid>(std::move(*excluded));
    }
}

std::optional<BitGrid> ReachableSearch::pocket(const Tray& tray, const OrientedShape& oriented,
                                               const VoxelIndex& position) {
    const std::unique_ptr<FreeRowReader> rows = engine_.free_rows(tray, oriented.solid, {});
    FloodFill flood(*rows, oriented.solid->extent(), whole(tray.extent()));
    if (!flood.way_out(position).empty()) return std::nullopt;
    BitGrid positions(tray.candidates(oriented.size));
    flood.mark_visited(positions);
    return positions;
}

BitGrid ReachableSearch::unreachable(const Tray& tray, const OrientedShape& oriented) {
    Shape alone;
    alone.orientations.push_back(oriented);
    FreePositions positions = engine_.free_positions(tray, alone, 0, {});
    BitGrid colliding(positions.free.extent());
    colliding.fill(true);
    subtract(colliding, positions.free, {});
    fill_enclosed(colliding);
    BitGrid excluded(tray.candidates(oriented.size));
    unite(excluded, colliding, positions.origin);
    return excluded;
}

}  // namespace spectralpack
