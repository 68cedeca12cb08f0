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

Extent finer(const Extent& extent, int s) { return {s * extent.x, s * extent.y, s * extent.z}; }

/// Every s-th bit along each axis, from the first.
BitGrid every(const BitGrid& bits, int s) {
    if (s == 1) return bits;
    const Extent& e = bits.extent();
    BitGrid result({e.x / s, e.y / s, e.z / s});
    for (int z = 0; z < result.extent().z; ++z) {
        for (int y = 0; y < result.extent().y; ++y) {
            for (int x = 0; x < result.extent().x; ++x) {
                if (bits.get(s * x, s * y, s * z)) result.set(x, y, z);
            }
        }
    }
    return result;
}

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

const Tray& ReachableSearch::finest(const Tray& tray) {
    if (tray.detail() == 1) return tray;
    if (!finest_ || followed_ != tray.instance()) {
        finest_.emplace(finest_setup(tray.setup()));
        followed_ = tray.instance();
    }
    // Ids are given in the order of the journal.
    for (auto i = static_cast<std::size_t>(finest_->version()); i < tray.journal().size(); ++i) {
        const TrayChange& change = tray.journal()[i];
        if (!change.added) {
            finest_->remove(change.id);
            continue;
        }
        finest_->add(on_finest(tray.object(change.id)));
    }
    return *finest_;
}

std::optional<BitGrid> ReachableSearch::pocket(const Tray& tray, const OrientedShape& oriented,
                                               const VoxelIndex& position) {
    const Tray& fine = finest(tray);
    const int s = tray.detail();
    const std::shared_ptr<const BitGrid>& solid = s == 1 ? oriented.solid : oriented.fine;
    const std::unique_ptr<FreeRowReader> rows = engine_.free_rows(fine, solid, {});
    FloodFill flood(*rows, solid->extent(), whole(fine.extent()));
    if (!flood.way_out({s * position.x, s * position.y, s * position.z}).empty()) return std::nullopt;
    BitGrid visited(finer(tray.candidates(oriented.size), s));
    flood.mark_visited(visited);
    return every(visited, s);
}

BitGrid ReachableSearch::unreachable(const Tray& tray, const OrientedShape& oriented) {
    const int s = tray.detail();
    Shape alone;
    alone.orientations.push_back(oriented);
    if (s > 1) alone.orientations.front().solid = oriented.fine;
    FreePositions positions = engine_.free_positions(finest(tray), alone, 0, {});
    BitGrid colliding(positions.free.extent());
    colliding.fill(true);
    subtract(colliding, positions.free, {});
    fill_enclosed(colliding);
    BitGrid excluded(finer(tray.candidates(oriented.size), s));
    unite(excluded, colliding, positions.origin);
    return every(excluded, s);
}

}  // namespace spectralpack
