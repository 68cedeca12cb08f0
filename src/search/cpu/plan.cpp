#include "search/cpu/plan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace spectralpack {
namespace {

constexpr int kSumRange = 65535;                                              // what 16 bits hold
constexpr std::size_t kLoadsPerBatch = 24;                                    // between two looks at the limit
constexpr std::size_t kLoadsPerBunch = 2 * kLoadsPerBatch;                    // of neighbours, which share cache lines
constexpr std::size_t kFirstBatch = 8;                                        // look-ups; batches after the sift grow
constexpr std::size_t kAllThrough = CollisionPlan::kLeastSift * kFirstBatch;  // look-ups that most tiles go through
constexpr std::size_t kLoadsPerSifted = 8;  // of the sum that comes next, for each look-up of the sift
constexpr std::size_t kLastBatch = 512;
constexpr std::size_t kOfStacks = 16;      // look-ups
constexpr int kLeastOfStacks = 4;          // voxels of a piece
constexpr std::size_t kMostOfBlocks = 64;  // look-ups for whole blocks
constexpr std::size_t kMostCells = 1600;   // asked of nearly all blocks
constexpr int kCrowd = 21;                 // where no phi is above it, little lies in the open
constexpr std::size_t kMostFineCells = std::size_t{1} << 20;
constexpr std::size_t kRunsWorthCells = 200;  // with fewer, sums cost little more than fine cells

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

/// Calls visit(i) once for each i in [0, count): every n-th in ascending order, then every n-th
/// from another start, so that each stretch of about `stretch` is spread over all and yet walks
/// memory in one direction.
template <class Visit>
void for_each_spread(std::size_t count, std::size_t stretch, const Visit& visit) {
    const std::size_t strides = (count + stretch - 1) / stretch;
    std::size_t size = 1;
    while (size < strides)
        size *= 2;
    for (std::size_t i = 0; i < size; ++i) {
        std::size_t start = 0;  // i with its bits reversed: consecutive starts lie far apart
        for (std::size_t bit = 1; bit < size; bit *= 2) {
            if (i & bit) start += size / 2 / bit;
        }
        if (start >= strides) continue;
        for (std::size_t k = start; k < count; k += strides) {
            visit(k);
        }
    }
}

template <class T>
std::vector<T> in_order(const std::vector<T>& items, const std::vector<std::uint32_t>& order) {
    std::vector<T> result;
    result.reserve(order.size());
    for (const std::uint32_t i : order) {
        result.push_back(items[i]);
    }
    return result;
}

/// Indices of `items`: what `level` rates highest comes first (levels 0 .. count - 1); among equals, bunches of
/// neighbours far apart.
template <class T, class Level>
std::vector<std::uint32_t> by_level(const std::vector<T>& items, std::size_t levels, std::size_t stretch,
                                    std::size_t bunch, const Level& level) {
    const auto shelf_of = [&](const T& item) { return levels - 1 - static_cast<std::size_t>(level(item)); };
    std::vector<std::size_t> end(levels + 1, 0);
    for (const T& item : items) {
        ++end[shelf_of(item) + 1];
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<std::uint32_t> shelved(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        shelved[end[shelf_of(items[i])]++] = static_cast<std::uint32_t>(i);
    }
    std::vector<std::uint32_t> result;
    result.reserve(items.size());
    for (std::size_t shelf = 0, begin = 0; shelf < levels; begin = end[shelf++]) {
        const auto from = shelved.begin() + static_cast<std::ptrdiff_t>(begin);
        const std::size_t count = end[shelf] - begin;
        for_each_spread((count + bunch - 1) / bunch, stretch, [&](std::size_t i) {
            result.insert(result.end(), from + static_cast<std::ptrdiff_t>(i * bunch),
                          from + static_cast<std::ptrdiff_t>(std::min(count, (i + 1) * bunch)));
        });
    }
    return result;
}

/// Look-ups that share the shift of a bit within its word come one after the other, since a group of them is shifted
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
        for (const Piece& piece : pieces) {
            const Form& form = lowered(piece.form);
            if (form.voxels() < kLeastOfStacks) continue;
            const VoxelIndex spared{(piece.form.size(0) - form.size(0)) / 2, (piece.form.size(1) - form.size(1)) / 2,
                                    rise + (piece.form.size(2) - rise - form.size(2)) / 2};
            all_.push_back({{form, piece.corner + offset + spared}, layer, first_rank + rank_of(form)});
        }
    }

    std::vector<Lookup> first(const BitTables& bits) const {
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
    std::vector<OfLayer> all_;
};

/// Appends a batch of look-ups into tables that know where a spot is, grouped by shift.
template <class Tables>
void append_batch(std::span<const Lookup> pieces, const Tables& tables, LookupPlan& plan) {
    std::vector<BitTables::Place> places;
    places.reserve(pieces.size());
    std::array<std::int32_t, 65> begin{};
    for (const Lookup& piece : pieces) {
        places.push_back(tables.place(piece.spot));
        ++begin[static_cast<std::size_t>(places.back().shift) + 1];
    }
    const auto first_group = static_cast<std::int32_t>(plan.groups.size());
    begin[0] = static_cast<std::int32_t>(plan.offsets.size());
    for (std::size_t shift = 0; shift < 64; ++shift) {
        begin[shift + 1] += begin[shift];
        if (begin[shift + 1] > begin[shift]) {
            plan.groups.push_back({shift, begin[shift], begin[shift + 1]});
        }
    }
    plan.offsets.resize(plan.offsets.size() + pieces.size());
    for (const BitTables::Place& place : places) {
        plan.offsets[static_cast<std::size_t>(begin[static_cast<std::size_t>(place.shift)]++)] = place.offset;
    }
    plan.batches.push_back(
        {first_group, static_cast<std::int32_t>(plan.groups.size()), static_cast<std::int32_t>(pieces.size())});
}

/// All of a few look-ups in batches of kFirstBatch.
template <class Tables>
void append_batches(std::span<const Lookup> pieces, const Tables& tables, LookupPlan& plan) {
    for (std::size_t begin = 0; begin < pieces.size(); begin += kFirstBatch) {
        append_batch(pieces.subspan(begin, std::min(pieces.size() - begin, kFirstBatch)), tables, plan);
    }
}

/// Clears bits [begin, end) of a row.
void clear_stretch(BitGrid::Word* row, int begin, int end) {
    using Word = BitGrid::Word;
    const Word from = ~Word{0} << (begin % 64), to = ~Word{0} >> (63 - (end - 1) % 64);
    const int first = begin / 64, last = (end - 1) / 64;
    if (first == last) {
        row[first] &= ~(from & to);
        return;
    }
    row[first] &= ~from;
    std::fill(row + first + 1, row + last, Word{0});
    row[last] &= ~to;
}

/// Indices of `items` by z, y, x of their voxels, which are not negative: what asks for them then walks memory in one
/// direction. Of those that have the axes from `first` on in common the order is right already. By counting, an axis at
/// a time: O(items + extents).
template <class T, class Voxel>
std::vector<std::uint32_t> by_place(const std::vector<T>& items, int first, const Voxel& voxel) {
    std::vector<std::uint32_t> order(items.size()), before(items.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::uint32_t> begin;
    for (int axis = first; axis < 3; ++axis) {
        const auto place = [&](const T& item) { return static_cast<std::size_t>(voxel(item)[axis]); };
        std::size_t last = 0;
        for (const T& item : items) {
            last = std::max(last, place(item));
        }
        begin.assign(last + 2, 0);
        for (const T& item : items) {
            ++begin[place(item) + 1];
        }
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        before.swap(order);
        for (const std::uint32_t i : before) {
            order[begin[place(items[i])]++] = i;
        }
    }
    return order;
}

VoxelBox box_of(const Piece& piece) {
    const Form& form = piece.form;
    return {piece.corner, piece.corner + VoxelIndex{form.size(0), form.size(1), form.size(2)}};
}

/// Calls visit(i, corner) for items that were by z, y, x, in that order again once the grid with these extents in which
/// `box_of` them lie is turned.
template <class T, class BoxOf, class Visit>
void for_each_turned(const std::vector<T>& items, const AxisTurn& turn, const Extent& grid, const BoxOf& box_of,
                     const Visit& visit) {
    std::vector<VoxelIndex> corners;
    corners.reserve(items.size());
    for (const T& item : items) {
        corners.push_back(turned(box_of(item), turn, grid).lo);
    }
    const int first = turn.reverses() ? 0 : turn.order[0] > turn.order[1] ? 1 : 2;
    for (const std::uint32_t i : by_place(corners, first, std::identity{})) {
        visit(i, corners[i]);
    }
}

/// Pieces of a grid with these extents once it is turned.
std::vector<Piece> turned(const std::vector<Piece>& pieces, const AxisTurn& turn, const Extent& grid) {
    std::vector<Piece> result;
    result.reserve(pieces.size());
    const auto box = [](const Piece& piece) { return box_of(piece); };
    for_each_turned(pieces, turn, grid, box, [&](std::size_t i, const VoxelIndex& corner) {
        int axes = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            axes |= (pieces[i].form.axes >> turn.order[axis] & 1) << axis;
        }
        result.push_back({{axes, pieces[i].form.level}, corner});
    });
    return result;
}

/// Pieces at an offset in a grid with these extents once that is turned, and their offset then.
std::pair<std::vector<Piece>, VoxelIndex> turned(const std::vector<Piece>& pieces, const VoxelIndex& offset,
                                                 const AxisTurn& turn, const Extent& grid) {
    VoxelBox all;
    for (const Piece& piece : pieces) {
        all = hull(all, box_of(piece));
    }
    const VoxelBox box{offset, offset + all.hi};
    return {turned(pieces, turn, {all.hi.x, all.hi.y, all.hi.z}), turned(box, turn, grid).lo};
}

/// cover() by z, y, x of the corners, of voxels that are `detail` to one of dx.
std::vector<Piece> ordered_cover(const BitGrid& solid, BitGrid wanted, int detail = 1) {
    const std::vector<Piece> pieces = cover(solid, std::move(wanted), BitTables::forms_for(detail));
    return in_order(pieces, by_place(pieces, 0, [](const Piece& piece) { return piece.corner; }));
}

OrientationRuns::Widened pieces_of(const WidenedVoxels& wide, int detail) {
    OrientationRuns::Widened result;
    result.offset = wide.offset;
    if (detail == 1) {
        result.pieces = ordered_cover(wide.voxels, wide.voxels);
        return result;
    }
    const CoarseVoxels core = filled_voxels(wide.voxels, wide.offset, detail);
    result.core = ordered_cover(core.voxels, core.voxels);
    result.core_offset = core.offset;
    BitGrid skin = wide.voxels;
    for (const Run& run : runs_along(core.voxels, 0).runs) {
        VoxelIndex first;
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = detail * (run.start[axis] + core.offset[axis]) - wide.offset[axis];
        }
        for (int row = 0; row < detail * detail; ++row) {
            clear_stretch(skin.row(first.y + row % detail, first.z + row / detail), first.x,
                          first.x + detail * run.length);
        }
    }
    result.pieces = ordered_cover(wide.voxels, std::move(skin), detail);
    return result;
}

/// Cells of the solid whose runs these are, of extents `solid`; `depths`: from before it was turned.
void add_cells(OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, const std::optional<Depths>& depths,
               const TrayTables::Frame& frame) {
    if (!frame.large && frame.most <= kCrowd) return;
    std::optional<TurnedDepths> here;
    if (depths) here.emplace(*depths, turn, solid);
    const auto cells = [&](int edge, std::size_t most) {
        return plan_cells(runs.solid, solid, frame.blocks, frame.most, edge, most, here ? &*here : nullptr);
    };
    runs.cells = cells(2 * TrayTables::kBlock, kMostCells);
    if (frame.large && runs.solid.runs.size() >= kRunsWorthCells) {
        runs.fine_cells = cells(TrayTables::kBlock, kMostFineCells);
    }
}

template <class T>
std::int64_t bytes_of(const std::vector<T>& list) {
    return static_cast<std::int64_t>(list.capacity() * sizeof(T));
}

}  // namespace

std::optional<Depths> depths_of(const OrientedShape& shape, const Runs& solid, int detail, bool covers) {
    if (!covers) return std::nullopt;
    if (detail == 1) return Depths(*shape.solid, solid);
    const BitGrid core = filled_voxels(*shape.fine, {}, detail).voxels;
    return Depths(core, runs_along(core, solid.axis));
}

OrientationRuns make_runs(const OrientedShape& shape, int detail, bool covers, const TrayTables::Frame& frame,
                          const Workers& workers, std::optional<Depths>* keep) {
    OrientationRuns result;
    std::vector<std::size_t> distinct;  // classes
    for (std::size_t c = 0; c < shape.widened.size(); ++c) {
        std::size_t same = 0;
        while (shape.widened[same] != shape.widened[c])
            ++same;
        result.of_class.push_back(same < c ? result.of_class[same] : static_cast<int>(distinct.size()));
        if (same == c) distinct.push_back(c);
    }
    result.widened.resize(distinct.size());
    const auto add_solid = [&] {
        result.solid = fewest_runs(*shape.solid);
        std::optional<Depths> depths = depths_of(shape, result.solid, detail, covers);
        if (depths) {
            result.least = depths->sums(result.solid);
        } else {
            result.least.assign(result.solid.runs.size(), 0);
        }
        add_cells(result, {}, shape.solid->extent(), depths, frame);
        if (keep) *keep = std::move(depths);
    };
    // What rho asks for takes about as long as one of the covers that a collision does.
    workers.for_each(std::ssize(distinct) + 2, [&](std::int64_t i) {
        if (i == 0) {
            add_solid();
        } else if (i == 1) {
            if (frame.walls) result.walled = ordered_cover(*shape.solid, *shape.solid);
        } else {
            const auto k = static_cast<std::size_t>(i - 2);
            result.widened[k] = pieces_of(*shape.widened[distinct[k]], detail);
        }
    });
    return result;
}

OrientationRuns turned(const OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, int detail,
                       const std::optional<Depths>& depths, const TrayTables::Frame& frame) {
    OrientationRuns result;
    result.solid.axis = static_cast<int>(std::ranges::find(turn.order, runs.solid.axis) - turn.order.begin());
    result.solid.voxels = runs.solid.voxels;
    result.solid.runs.reserve(runs.solid.runs.size());
    result.least.reserve(runs.solid.runs.size());
    const auto box = [&](const Run& run) { return box_of(run, runs.solid.axis); };
    for_each_turned(runs.solid.runs, turn, solid, box, [&](std::size_t i, const VoxelIndex& start) {
        result.solid.runs.push_back({start, runs.solid.runs[i].length});
        result.least.push_back(runs.least[i]);
    });
    const Extent fine{detail * solid.x, detail * solid.y, detail * solid.z};  // exact where it is asked for
    for (const OrientationRuns::Widened& wide : runs.widened) {
        OrientationRuns::Widened& to = result.widened.emplace_back();
        std::tie(to.pieces, to.offset) = turned(wide.pieces, wide.offset, turn, fine);
        std::tie(to.core, to.core_offset) = turned(wide.core, wide.core_offset, turn, solid);
    }
    result.of_class = runs.of_class;
    result.walled = turned(runs.walled, turn, solid);
    if (turn.reverses()) {
        const Extent& n = solid;
        add_cells(result, turn, {n[turn.order[0]], n[turn.order[1]], n[turn.order[2]]}, depths, frame);
        return result;
    }
    result.cells = runs.cells;
    result.fine_cells = runs.fine_cells;
    for (CellPlan* plan : {&result.cells, &result.fine_cells}) {
        for (SolidCell& cell : plan->cells) {
            cell.block = {cell.block[turn.order[0]], cell.block[turn.order[1]], cell.block[turn.order[2]]};
            cell.offset = frame.blocks.offset(cell.block);
        }
    }
    return result;
}

bool covers_solid(const Shape& shape) {
    for (const OrientedShape& oriented : shape.orientations) {
        for (std::size_t c = 0; c < oriented.widened.size(); ++c) {
            if (c > 0 && oriented.widened[c] == oriented.widened[c - 1]) continue;
            const WidenedVoxels& widened = *oriented.widened[c];
            const BitGrid& fine = oriented.fine ? *oriented.fine : *oriented.solid;
            if (widened.offset == VoxelIndex{} && widened.voxels == fine) continue;
            BitGrid bare = fine;
            subtract(bare, widened.voxels, widened.offset);
            if (!bare.none()) return false;
        }
    }
    return true;
}

int overhang(const Shape& shape, int detail) {
    int most = 0;
    for (const OrientedShape& oriented : shape.orientations) {
        for (const auto& widened : oriented.widened) {
            for (int axis = 0; axis < 3; ++axis) {
                const int last = ceil_div(widened->voxels.extent()[axis] + widened->offset[axis], detail);
                most =
                    std::max({most, -floor_div(widened->offset[axis], detail), last - oriented.solid->extent()[axis]});
            }
        }
    }
    return most;
}

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
    std::vector<Lookup> ordered = in_order(
        lookups, by_level(lookups, kAllRanks, kFirstBatch, 1, [](const Lookup& lookup) { return lookup.rank; }));
    by_shift(std::span(ordered).first(std::min(ordered.size(), kAllThrough)), tables.bits());
    const std::span<const Lookup> all = ordered;
    CollisionPlan plan;
    plan.sift = std::clamp(loads / kLoadsPerSifted / kFirstBatch, CollisionPlan::kLeastSift, CollisionPlan::kMostSift);
    std::size_t size = kFirstBatch;
    for (std::size_t begin = 0; begin < all.size();) {
        const std::size_t count = std::min(all.size() - begin, size);
        append_batch(all.subspan(begin, count), tables.bits(), plan.of_positions);
        begin += count;
        if (plan.of_positions.batches.size() >= plan.sift) size = std::min(2 * size, kLastBatch);
    }
    const std::vector<Lookup> of_all_layers = of_stacks.first(tables.bits());
    append_batches(of_all_layers, tables.bits(), plan.of_stacks);
    std::vector<Lookup> of_blocks;
    for (const Lookup& lookup : all) {
        if (of_blocks.size() == kMostOfBlocks) break;
        if (lookup.of_blocks) of_blocks.push_back(lookup);
    }
    append_batches(of_blocks, tables.crowd(), plan.of_blocks);
    return plan;
}

std::vector<std::uint32_t> order_of_loads(const Runs& runs) {
    return by_level(runs.runs, 33, 1, kLoadsPerBunch,
                    [](const Run& run) { return std::bit_width(static_cast<unsigned>(run.length)); });
}

SumPlan plan_sum(const OrientationRuns& orientation, const std::vector<std::uint32_t>& order, const SumLayout& tables,
                 int range, int most) {
    const Runs& runs = orientation.solid;
    SumPlan plan;
    plan.loads.reserve(order.size());
    const int longest = range / std::max(1, most);
    const int together = kSumRange / std::max(1, most);  // voxels of a batch
    int room = 0;                                        // that it can still take
    std::size_t count = kLoadsPerBatch;
    for (const std::uint32_t i : order) {
        const Run& run = runs.runs[i];
        VoxelIndex at = run.start;
        std::int32_t from = tables.offset(runs.axis, at);
        for (int left = run.length; left > 0;) {
            const int length = std::min(left, longest);
            if (length > room || count == kLoadsPerBatch) {
                const auto begin = static_cast<std::int32_t>(plan.loads.size());
                plan.batches.push_back({begin, begin});
                room = together;
                count = 0;
            }
            const std::int32_t to = tables.further(runs.axis, at, from, length);
            // Of a run that is split, no part is known to hold the deep voxels.
            const std::uint32_t known = length == run.length ? orientation.least[i] : 0;
            const auto part = static_cast<std::uint16_t>(std::min(known, static_cast<std::uint32_t>(range)));
            plan.loads.push_back({to, from, part});
            plan.least += part;
            SumBatch& batch = plan.batches.back();
            batch.end = static_cast<std::int32_t>(plan.loads.size());
            batch.least = static_cast<std::uint16_t>(batch.least + part);
            room -= length;
            ++count;
            left -= length;
            at[runs.axis] += length;
            from = to;
        }
    }
    return plan;
}

OrientationPlan make_plan(const OrientationRuns& runs, const TrayTables& tables) {
    OrientationPlan plan;
    const std::vector<std::uint32_t> order = order_of_loads(runs.solid);
    tables.visit_sums([&]<class T>(const Sums<T>& sums) {
        constexpr int kRange = SumTables<T>::kRange, kMostPooled = SumTables<T>::kMostPooled;
        const int most = tables.phi().most();
        const int most_pooled = tables.apart() ? kMostPooled : most;
        plan.fine = plan_sum(runs, order, sums.exact, kRange, std::max(most, most_pooled));
        plan.coarse = plan_sum(runs, order, sums.coarse, kRange, most_pooled);
    });
    plan.collision = plan_collision(runs, tables, plan.coarse.loads.size());
    return plan;
}

std::int64_t bytes_of(const OrientationRuns& runs) {
    std::int64_t bytes = bytes_of(runs.solid.runs) + bytes_of(runs.least) + bytes_of(runs.walled) +
                         bytes_of(runs.cells.cells) + bytes_of(runs.fine_cells.cells);
    for (const OrientationRuns::Widened& wide : runs.widened) {
        bytes += bytes_of(wide.pieces) + bytes_of(wide.core);
    }
    return bytes;
}

std::int64_t bytes_of(const OrientationPlan& plan) {
    std::int64_t bytes = 0;
    for (const LookupPlan* lookups :
         {&plan.collision.of_positions, &plan.collision.of_blocks, &plan.collision.of_stacks}) {
        bytes += bytes_of(lookups->offsets) + bytes_of(lookups->groups) + bytes_of(lookups->batches);
    }
    for (const SumPlan* sums : {&plan.fine, &plan.coarse}) {
        bytes += bytes_of(sums->loads) + bytes_of(sums->batches);
    }
    return bytes;
}

}  // namespace spectralpack
