#include "search/cpu/shapes/lookups.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <span>
#include <utility>

#include "search/cpu/shapes/orders.hpp"
#include "search/cpu/tuning.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kAllThrough = tuning::kLeastPruning * tuning::kFirstBatch;  // look-ups that most tiles go through

/// How much a piece is likely to decide, 0 .. kRanks - 1.
constexpr int kRanks = 1 + std::max(BitTables::kForms.run_levels, BitTables::kForms.last_plate + 2);
int rank_of(const Form& form) { return form.level + std::popcount(static_cast<unsigned>(form.axes)) - 1; }
/// With s > 1 pieces in voxels of dx decide more, and there are s^3 times fewer tables to look them up in: all of them
/// come first.
constexpr int kCoarse = kRanks;

/// Pieces of one form that are looked up in one layer.
struct Lot {
    std::span<const VoxelIndex> corners;
    Form form;
    VoxelIndex offset;  // of the corners
    int layer = 0, rank = 0;
    BitTables::SpotsOf spots;
};

/// Calls visit(lots of one rank), until it answers false: those first that are likely to decide most. The lots are
/// ordered likewise.
template <class Visit>
void for_each_rank(std::vector<Lot>& lots, const Visit& visit) {
    std::ranges::stable_sort(lots, std::greater(), &Lot::rank);
    for (auto first = lots.begin(); first != lots.end();) {
        const auto last = std::find_if(first, lots.end(), [&](const Lot& lot) { return lot.rank != first->rank; });
        if (!visit(std::span<const Lot>(first, last))) return;
        first = last;
    }
}

/// Where look-ups lie, those that decide most first.
struct Places {
    std::vector<BitTables::Place> all;
    std::size_t coarse = 0;  // of kCoarse ranks: the first of them

    /// Puts those among the first `count` that share the shift of a bit within its word one after the other, since a
    /// group of them is shifted once; but those in voxels of dx stay first.
    void by_shift(std::size_t count) {
        const std::size_t end = std::min(count, all.size()), middle = std::min(coarse, end);
        std::ranges::sort(std::span(all).first(middle), {}, &BitTables::Place::shift);
        std::ranges::sort(std::span(all).subspan(middle, end - middle), {}, &BitTables::Place::shift);
    }
};

std::size_t pieces_in(std::span<const Lot> lots) {
    std::size_t count = 0;
    for (const Lot& lot : lots) {
        count += lot.corners.size();
    }
    return count;
}

/// Of the first `most` pieces, in tables that know where a spot is; those of one rank as for_each_spread() has them.
template <class Tables>
Places places_of(std::vector<Lot>& lots, const Tables& tables, std::size_t most) {
    Places places;
    places.all.reserve(std::min(most, pieces_in(lots)));
    for_each_rank(lots, [&](std::span<const Lot> same) {
        auto lot = same.begin();
        std::size_t before = 0;  // pieces of the lots before it
        return for_each_spread(pieces_in(same), tuning::kFirstBatch, [&](std::size_t k) {
            if (places.all.size() == most) return false;
            if (k < before) {
                lot = same.begin();
                before = 0;
            }
            while (k - before >= lot->corners.size())
                before += lot++->corners.size();
            places.all.push_back(tables.place(lot->spots(lot->corners[k - before] + lot->offset)));
            places.coarse += lot->rank >= kCoarse;
            return true;
        });
    });
    return places;
}

/// The largest form in one of that form without its lowest `layers`; of one voxel where it has no more.
Form lowered(const Form& form, int layers) {
    Form result{1, 0};
    const int height = form.size(2) - layers;
    if (height <= 0) return result;
    const auto consider = [&](const Form& smaller) {
        if (smaller.voxels() > result.voxels()) result = smaller;
    };
    if (const int flat = form.axes & 3; flat != 0) consider({flat, form.level});
    const int least = form.axes == 4 ? 1 : Forms::kFirstPlate;
    for (int level = least; level <= form.level && 1 << level <= height; ++level) {
        consider({form.axes, level});
    }
    return result;
}

/// Pieces in what candidates fill from all positions of a stack.
std::vector<Lot> lots_of_stacks(const std::vector<Lot>& lots, const BitTables& bits) {
    std::vector<Lot> result;
    result.reserve(lots.size());
    for (const Lot& lot : lots) {
        const int rise = bits.detail_of(lot.layer) * (BitTables::kTileLayers - 1);  // from the lowest to the highest
        const Form form = lowered(lot.form, rise);
        if (form.voxels() < tuning::kLeastVoxelsInStacks) continue;
        const VoxelIndex spared{(lot.form.size(0) - form.size(0)) / 2, (lot.form.size(1) - form.size(1)) / 2,
                                rise + (lot.form.size(2) - rise - form.size(2)) / 2};
        result.push_back({lot.corners, form, spared, lot.layer, lot.rank - rank_of(lot.form) + rank_of(form),
                          BitTables::SpotsOf(bits, lot.layer, form)});
    }
    return result;
}

/// All that an orientation is looked up in.
std::vector<Lot> lots_of(const OrientationRuns& runs, const TrayTables& tables) {
    std::vector<Lot> lots;
    const auto add = [&](const Pieces& pieces, int layer, int first_rank) {
        for (const Pieces::OfForm& of : pieces.forms) {
            lots.push_back({pieces.corners_of(of),
                            of.form,
                            {},
                            layer,
                            first_rank + rank_of(of.form),
                            BitTables::SpotsOf(tables.bits(), layer, of.form)});
        }
    };
    for (std::size_t c = 0; c < runs.of_class.size(); ++c) {
        const int gap_class = static_cast<int>(c);
        if (!tables.occupied(gap_class)) continue;
        const auto& widened = runs.widened[static_cast<std::size_t>(runs.of_class[c])];
        if (!widened.core.corners.empty()) add(widened.core, tables.coarse_layer(gap_class), kCoarse);
        add(widened.pieces, tables.fine_layer(gap_class), 0);
    }
    if (tables.walls()) add(runs.walled, tables.wall_layer(), 0);
    return lots;
}

/// Appends a batch of look-ups, grouped by shift.
void append_batch(std::span<const BitTables::Place> places, LookupList& list) {
    std::array<std::int32_t, 64> next{};  // of a shift: how many, then where the next one goes
    std::uint64_t shifts = 0;
    for (const BitTables::Place& place : places) {
        ++next[static_cast<std::size_t>(place.shift)];
        shifts |= std::uint64_t{1} << place.shift;
    }
    const auto first_group = static_cast<std::int32_t>(list.groups.size());
    auto end = static_cast<std::int32_t>(list.offsets.size());
    for (; shifts != 0; shifts &= shifts - 1) {
        const auto shift = static_cast<std::size_t>(std::countr_zero(shifts));
        const std::int32_t begin = end;
        end += std::exchange(next[shift], begin);
        list.groups.push_back({shift, begin, end});
    }
    list.offsets.resize(static_cast<std::size_t>(end));
    for (const BitTables::Place& place : places) {
        list.offsets[static_cast<std::size_t>(next[static_cast<std::size_t>(place.shift)]++)] = place.offset;
    }
    list.batches.push_back(
        {first_group, static_cast<std::int32_t>(list.groups.size()), static_cast<std::int32_t>(places.size())});
}

/// All of a few look-ups in batches of tuning::kFirstBatch.
void append_batches(std::span<const BitTables::Place> places, LookupList& list) {
    for (std::size_t begin = 0; begin < places.size(); begin += tuning::kFirstBatch) {
        append_batch(places.subspan(begin, std::min(places.size() - begin, tuning::kFirstBatch)), list);
    }
}

}  // namespace

CollisionLookups list_lookups(const OrientationRuns& runs, const TrayTables& tables, std::size_t loads) {
    const BitTables& bits = tables.bits();
    std::vector<Lot> lots = lots_of(runs, tables);
    Places all = places_of(lots, bits, pieces_in(lots));
    all.by_shift(kAllThrough);
    CollisionLookups result;
    result.pruning = std::clamp(loads / tuning::kLoadsPerPruningLookup / tuning::kFirstBatch, tuning::kLeastPruning,
                                tuning::kMostPruning);
    result.of_positions.offsets.reserve(all.all.size());
    std::size_t size = tuning::kFirstBatch;
    for (std::size_t begin = 0; begin < all.all.size();) {
        const std::size_t count = std::min(all.all.size() - begin, size);
        append_batch(std::span(all.all).subspan(begin, count), result.of_positions);
        begin += count;
        if (result.of_positions.batches.size() >= result.pruning) size = std::min(2 * size, tuning::kLastBatch);
    }
    std::vector<Lot> lots_in_stacks = lots_of_stacks(lots, bits);
    Places of_stacks = places_of(lots_in_stacks, bits, tuning::kStackLookups);
    of_stacks.by_shift(tuning::kStackLookups);
    append_batches(of_stacks.all, result.of_stacks);
    const CrowdTables& crowd = tables.crowd();
    std::erase_if(lots, [&](const Lot& lot) { return !crowd.holds(lot.layer, lot.form); });
    append_batches(places_of(lots, crowd, tuning::kCrowdLookups).all, result.of_blocks);
    return result;
}

std::int64_t bytes_of(const CollisionLookups& all) {
    std::int64_t bytes = 0;
    for (const LookupList* list : {&all.of_positions, &all.of_blocks, &all.of_stacks}) {
        bytes += bytes_of(list->offsets) + bytes_of(list->groups) + bytes_of(list->batches);
    }
    return bytes;
}

}  // namespace spectralpack
