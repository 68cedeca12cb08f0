#include "search/cpu/lookup_plan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

#include "search/cpu/lists.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kFirstBatch = 8;                                        // look-ups; batches after the sift grow
constexpr std::size_t kAllThrough = CollisionPlan::kLeastSift * kFirstBatch;  // look-ups that most tiles go through
constexpr std::size_t kLoadsPerSifted = 8;  // of the sum that comes next, for each look-up of the sift
constexpr std::size_t kLastBatch = 512;
constexpr std::size_t kOfStacks = 16;      // look-ups
constexpr int kLeastOfStacks = 4;          // voxels of a piece
constexpr std::size_t kMostOfBlocks = 64;  // look-ups for whole blocks

struct Lookup {
    BitTables::Spot spot;
    int rank = 0;
    bool of_blocks = false;  // the crowd tables have it
};

/// How much a piece is likely to decide, 0 .. kRanks - 1.
constexpr int kRanks = 1 + std::max(BitTables::kForms.run_levels, BitTables::kForms.last_plate + 2);
int rank_of(const Form& form) { return form.level + std::popcount(static_cast<unsigned>(form.axes)) - 1; }
/// With s > 1 pieces in voxels of dx decide more, and there are s^3 times fewer tables to look them up in: all of them
/// come first.
constexpr int kCoarse = kRanks, kAllRanks = 2 * kRanks;

/// Puts look-ups that share the shift of a bit within its word one after the other, since a group of them is shifted
/// once; but those in voxels of dx stay first.
void by_shift(std::span<Lookup> lookups, const BitTables& bits) {
    std::ranges::stable_sort(lookups, {},
                             [&](const Lookup& of) { return std::pair(of.rank < kCoarse, bits.place(of.spot).shift); });
}

/// Of every form the largest in one of that form without its lowest `layers`; of one voxel where it has no more.
class Lowered {
  public:
    explicit Lowered(int layers) {
        for (int axes = 1; axes < 8; ++axes) {
            for (int level = 0; level <= BitTables::kForms.run_levels; ++level) {
                of(axes, level) = largest({axes, level}, layers);
            }
        }
    }
    const Form& operator()(const Form& form) const { return of(form.axes, form.level); }

  private:
    static Form largest(const Form& form, int layers) {
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
    const Form& of(int axes, int level) const {
        return forms_[static_cast<std::size_t>(axes)][static_cast<std::size_t>(level)];
    }
    Form& of(int axes, int level) { return forms_[static_cast<std::size_t>(axes)][static_cast<std::size_t>(level)]; }

    std::array<std::array<Form, BitTables::kForms.run_levels + 1>, 8> forms_;
};

/// The first of the pieces in what candidates fill from all positions of a stack, those first that are likely to decide
/// most.
class StackPieces {
  public:
    void add(const std::vector<Piece>& pieces, const VoxelIndex& offset, int layer, int detail, int first_rank) {
        const int rise = detail * (BitTables::kTileLayers - 1);  // from the lowest position to the highest
        const Lowered lowered(rise);
        all_.reserve(all_.size() + pieces.size());
        for (const Piece& piece : pieces) {
            const Form& form = lowered(piece.form);
            if (form.voxels() < kLeastOfStacks) continue;
            const VoxelIndex spared{(piece.form.size(0) - form.size(0)) / 2, (piece.form.size(1) - form.size(1)) / 2,
                                    rise + (piece.form.size(2) - rise - form.size(2)) / 2};
            all_.push_back({{form, piece.corner + offset + spared}, layer, first_rank + rank_of(form)});
        }
    }

    std::vector<Lookup> first(const BitTables& bits) {
        leave_highest_ranks();
        std::vector<Lookup> lookups;
        for (const std::uint32_t i :
             by_level(all_, kAllRanks, kFirstBatch, 1, [](const OfLayer& of) { return of.rank; })) {
            if (lookups.size() == kOfStacks) break;
            lookups.push_back(
                {.spot = bits.spot(all_[i].layer, all_[i].piece.form, all_[i].piece.corner), .rank = all_[i].rank});
        }
        by_shift(lookups, bits);
        return lookups;
    }

  private:
    struct OfLayer {
        Piece piece;
        int layer, rank;
    };

    /// Leaves only pieces of ranks among which first() stops.
    void leave_highest_ranks() {
        std::array<std::size_t, kAllRanks> of_rank{};
        for (const OfLayer& of : all_) {
            ++of_rank[static_cast<std::size_t>(of.rank)];
        }
        int least = kAllRanks;
        for (std::size_t more = 0; least > 0 && more < kOfStacks;) {
            more += of_rank[static_cast<std::size_t>(--least)];
        }
        std::erase_if(all_, [&](const OfLayer& of) { return of.rank < least; });
    }

    std::vector<OfLayer> all_;
};

/// Where look-ups lie in tables that know where a spot is.
template <class Tables>
std::vector<BitTables::Place> places_of(std::span<const Lookup> lookups, const Tables& tables) {
    std::vector<BitTables::Place> places;
    places.reserve(lookups.size());
    for (const Lookup& lookup : lookups) {
        places.push_back(tables.place(lookup.spot));
    }
    return places;
}

/// Appends a batch of look-ups, grouped by shift.
void append_batch(std::span<const BitTables::Place> places, LookupPlan& plan) {
    std::array<std::int32_t, 64> next{};  // of a shift: how many, then where the next one goes
    std::uint64_t shifts = 0;
    for (const BitTables::Place& place : places) {
        ++next[static_cast<std::size_t>(place.shift)];
        shifts |= std::uint64_t{1} << place.shift;
    }
    const auto first_group = static_cast<std::int32_t>(plan.groups.size());
    auto end = static_cast<std::int32_t>(plan.offsets.size());
    for (; shifts != 0; shifts &= shifts - 1) {
        const auto shift = static_cast<std::size_t>(std::countr_zero(shifts));
        const std::int32_t begin = end;
        end += std::exchange(next[shift], begin);
        plan.groups.push_back({shift, begin, end});
    }
    plan.offsets.resize(static_cast<std::size_t>(end));
    for (const BitTables::Place& place : places) {
        plan.offsets[static_cast<std::size_t>(next[static_cast<std::size_t>(place.shift)]++)] = place.offset;
    }
    plan.batches.push_back(
        {first_group, static_cast<std::int32_t>(plan.groups.size()), static_cast<std::int32_t>(places.size())});
}

/// All of a few look-ups in batches of kFirstBatch.
void append_batches(std::span<const BitTables::Place> places, LookupPlan& plan) {
    for (std::size_t begin = 0; begin < places.size(); begin += kFirstBatch) {
        append_batch(places.subspan(begin, std::min(places.size() - begin, kFirstBatch)), plan);
    }
}

}  // namespace

CollisionPlan plan_collision(const OrientationRuns& runs, const TrayTables& tables, std::size_t loads) {
    std::vector<Lookup> lookups;
    StackPieces of_stacks;
    const auto look_up = [&](const std::vector<Piece>& pieces, const VoxelIndex& offset, int layer, int first_rank) {
        of_stacks.add(pieces, offset, layer, tables.bits().detail_of(layer), first_rank);
        lookups.reserve(lookups.size() + pieces.size());
        for (const Piece& piece : pieces) {
            // Field by field: a whole one that was just put together out of smaller parts is slow to copy.
            Lookup& lookup = lookups.emplace_back();
            lookup.spot = tables.bits().spot(layer, piece.form, piece.corner + offset);
            lookup.rank = first_rank + rank_of(piece.form);
            lookup.of_blocks = tables.crowd().holds(layer, piece.form);
        }
    };
    for (std::size_t c = 0; c < runs.of_class.size(); ++c) {
        const int gap_class = static_cast<int>(c);
        if (!tables.occupied(gap_class)) continue;
        const auto& widened = runs.widened[static_cast<std::size_t>(runs.of_class[c])];
        if (!widened.core.empty()) {
            look_up(widened.core, widened.core_offset, tables.coarse_layer(gap_class), kCoarse);
        }
        look_up(widened.pieces, widened.offset, tables.fine_layer(gap_class), 0);
    }
    if (tables.walls()) look_up(runs.walled, {}, tables.wall_layer(), 0);
    const BitTables& bits = tables.bits();
    std::vector<Lookup> ordered = in_order(
        lookups, by_level(lookups, kAllRanks, kFirstBatch, 1, [](const Lookup& lookup) { return lookup.rank; }));
    by_shift(std::span(ordered).first(std::min(ordered.size(), kAllThrough)), bits);
    CollisionPlan plan;
    plan.sift = std::clamp(loads / kLoadsPerSifted / kFirstBatch, CollisionPlan::kLeastSift, CollisionPlan::kMostSift);
    const std::vector<BitTables::Place> all = places_of(ordered, bits);
    plan.of_positions.offsets.reserve(all.size());
    std::size_t size = kFirstBatch;
    for (std::size_t begin = 0; begin < all.size();) {
        const std::size_t count = std::min(all.size() - begin, size);
        append_batch(std::span(all).subspan(begin, count), plan.of_positions);
        begin += count;
        if (plan.of_positions.batches.size() >= plan.sift) size = std::min(2 * size, kLastBatch);
    }
    append_batches(places_of(of_stacks.first(bits), bits), plan.of_stacks);
    std::vector<Lookup> of_blocks;
    for (const Lookup& lookup : ordered) {
        if (of_blocks.size() == kMostOfBlocks) break;
        if (lookup.of_blocks) of_blocks.push_back(lookup);
    }
    append_batches(places_of(of_blocks, tables.crowd()), plan.of_blocks);
    return plan;
}

std::int64_t bytes_of(const CollisionPlan& plan) {
    std::int64_t bytes = 0;
    for (const LookupPlan* lookups : {&plan.of_positions, &plan.of_blocks, &plan.of_stacks}) {
        bytes += bytes_of(lookups->offsets) + bytes_of(lookups->groups) + bytes_of(lookups->batches);
    }
    return bytes;
}

}  // namespace spectralpack
