#include "search/cpu/plan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <span>
#include <tuple>

#include "search/cpu/depths.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kSumRange = 65535;   // what 16 bits hold
constexpr std::size_t kLoadsPerBatch = 24;  // between two looks at the limit
constexpr std::size_t kFirstBatch = 8;      // look-ups; later batches grow
constexpr std::size_t kLastBatch = 512;

struct Lookup {
    BitTables::Place place;
    int rank = 0;
};

/// How much a piece is likely to decide, 0 .. kRanks - 1.
constexpr int kRanks = BitTables::kLevels + 2;
int rank_of(const Form& form) {
    return form.level + std::popcount(static_cast<unsigned>(form.axes)) - 1;
}

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

/// What `level` rates highest comes first (levels 0 .. count - 1); among equals, neighbours far
/// apart.
template <class T, class Level>
std::vector<T> by_level(const std::vector<T>& items, std::size_t levels, std::size_t stretch,
                        const Level& level) {
    std::vector<std::vector<T>> shelves(levels);
    for (const T& item : items) {
        shelves[static_cast<std::size_t>(level(item))].push_back(item);
    }
    std::vector<T> result;
    result.reserve(items.size());
    for (auto shelf = shelves.rbegin(); shelf != shelves.rend(); ++shelf) {
        for_each_spread(shelf->size(), stretch,
                        [&](std::size_t i) { result.push_back((*shelf)[i]); });
    }
    return result;
}

/// Appends a batch of look-ups, grouped by shift.
void append_batch(std::span<const Lookup> pieces, CollisionPlan& plan) {
    std::array<std::int32_t, 65> begin{};
    for (const Lookup& piece : pieces) {
        ++begin[static_cast<std::size_t>(piece.place.shift) + 1];
    }
    const auto first_group = static_cast<std::int32_t>(plan.groups.size());
    begin[0] = static_cast<std::int32_t>(plan.offsets.size());
    for (std::size_t shift = 0; shift < 64; ++shift) {
        begin[shift + 1] += begin[shift];
        if (begin[shift + 1] > begin[shift]) {
            plan.groups.push_back({static_cast<int>(shift), begin[shift], begin[shift + 1]});
        }
    }
    plan.offsets.resize(plan.offsets.size() + pieces.size());
    for (const Lookup& piece : pieces) {
        plan.offsets[static_cast<std::size_t>(
            begin[static_cast<std::size_t>(piece.place.shift)]++)] = piece.place.offset;
    }
    plan.batches.push_back({first_group, static_cast<std::int32_t>(plan.groups.size()),
                            static_cast<std::int32_t>(pieces.size())});
}

OrientationRuns::Widened pieces_of(const WidenedVoxels& wide, int detail) {
    OrientationRuns::Widened result;
    result.offset = wide.offset;
    if (detail == 1) {
        result.pieces = cover(wide.voxels, wide.voxels);
        return result;
    }
    const CoarseVoxels core = filled_voxels(wide.voxels, wide.offset, detail);
    result.core = cover(core.voxels, core.voxels);
    result.core_offset = core.offset;
    BitGrid skin = wide.voxels;
    const Extent& n = core.voxels.extent();
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            for (int w = 0; w < core.voxels.words_per_row(); ++w) {
                for (BitGrid::Word bits = core.voxels.row(y, z)[w]; bits != 0; bits &= bits - 1) {
                    const VoxelIndex first{detail * (64 * w + std::countr_zero(bits) + core.offset.x) - wide.offset.x,
                                           detail * (y + core.offset.y) - wide.offset.y,
                                           detail * (z + core.offset.z) - wide.offset.z};
                    for (int part = 0; part < part_count(detail); ++part) {
                        skin.set(first.x + part % detail, first.y + part / detail % detail,
                                 first.z + part / (detail * detail), false);
                    }
                }
            }
        }
    }
    result.pieces = cover(wide.voxels, std::move(skin));
    return result;
}

}  // namespace

OrientationRuns make_runs(const OrientedShape& shape, int detail, bool covers, const TrayTables& tables) {
    OrientationRuns result;
    result.solid = fewest_runs(*shape.solid);
    result.cells =
        plan_cells(result.solid, shape.solid->extent(), tables.minima(), tables.phi().most(), tables.apart());
    if (!covers) {
        result.least.assign(result.solid.runs.size(), 0);
    } else if (detail == 1) {
        result.least = depth_sums(*shape.solid, result.solid, result.solid);
    } else {
        const BitGrid core = filled_voxels(*shape.fine, {}, detail).voxels;
        result.least = depth_sums(core, runs_along(core, result.solid.axis), result.solid);
    }
    if (tables.walls()) result.walled = cover(*shape.solid, *shape.solid);
    for (std::size_t c = 0; c < shape.widened.size(); ++c) {
        std::size_t same = 0;
        while (shape.widened[same] != shape.widened[c])
            ++same;
        if (same < c) {
            result.of_class.push_back(result.of_class[same]);
            continue;
        }
        result.of_class.push_back(static_cast<int>(result.widened.size()));
        result.widened.push_back(pieces_of(*shape.widened[c], detail));
    }
    return result;
}

OrientationRuns permuted(const OrientationRuns& runs, const AxisOrder& axes, const Extent& extent,
                         const TrayTables& tables) {
    const auto exchanged = [&](const VoxelIndex& v) { return VoxelIndex{v[axes[0]], v[axes[1]], v[axes[2]]}; };
    // Ascending, so that they walk memory in one direction.
    const auto rank = [](const VoxelIndex& v) { return std::make_tuple(v.z, v.y, v.x); };
    const auto pieces = [&](std::vector<Piece> all) {
        for (Piece& piece : all) {
            int turned = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                turned |= (piece.form.axes >> axes[axis] & 1) << axis;
            }
            piece = {{turned, piece.form.level}, exchanged(piece.corner)};
        }
        std::ranges::sort(all, [&](const Piece& a, const Piece& b) { return rank(a.corner) < rank(b.corner); });
        return all;
    };

    OrientationRuns result;
    std::vector<std::size_t> order(runs.solid.runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<Run> turned = runs.solid.runs;
    for (Run& run : turned) {
        run.start = exchanged(run.start);
    }
    std::ranges::sort(order,
                      [&](std::size_t a, std::size_t b) { return rank(turned[a].start) < rank(turned[b].start); });
    result.solid.axis = static_cast<int>(std::ranges::find(axes, runs.solid.axis) - axes.begin());
    result.solid.voxels = runs.solid.voxels;
    for (const std::size_t i : order) {
        result.solid.runs.push_back(turned[i]);
        result.least.push_back(runs.least[i]);
    }
    for (const OrientationRuns::Widened& wide : runs.widened) {
        result.widened.push_back(
            {pieces(wide.pieces), exchanged(wide.offset), pieces(wide.core), exchanged(wide.core_offset)});
    }
    result.of_class = runs.of_class;
    result.walled = pieces(runs.walled);
    result.cells = plan_cells(result.solid, extent, tables.minima(), tables.phi().most(), tables.apart());
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
                most = std::max({most, -floor_div(widened->offset[axis], detail),
                                 last - oriented.solid->extent()[axis]});
            }
        }
    }
    return most;
}

CollisionPlan plan_collision(const OrientationRuns& runs, const TrayTables& tables) {
    std::vector<Lookup> lookups;
    const auto look_up = [&](const std::vector<Piece>& pieces, const VoxelIndex& offset, int layer) {
        for (const Piece& piece : pieces) {
            lookups.push_back({tables.bits().place(layer, piece.form, piece.corner + offset), rank_of(piece.form)});
        }
    };
    for (std::size_t c = 0; c < runs.of_class.size(); ++c) {
        const int gap_class = static_cast<int>(c);
        if (!tables.occupied(gap_class)) continue;
        const auto& widened = runs.widened[static_cast<std::size_t>(runs.of_class[c])];
        if (!widened.core.empty()) look_up(widened.core, widened.core_offset, tables.coarse_layer(gap_class));
        look_up(widened.pieces, widened.offset, tables.fine_layer(gap_class));
    }
    if (tables.walls()) look_up(runs.walled, {}, tables.wall_layer());
    const std::vector<Lookup> ordered =
        by_level(lookups, kRanks, kFirstBatch, [](const Lookup& lookup) { return lookup.rank; });
    CollisionPlan plan;
    std::size_t size = kFirstBatch;
    for (std::size_t begin = 0; begin < ordered.size();) {
        const std::size_t end = std::min(ordered.size(), begin + size);
        append_batch({ordered.data() + begin, end - begin}, plan);
        begin = end;
        if (plan.batches.size() >= kSiftBatches) size = std::min(2 * size, kLastBatch);
    }
    return plan;
}

SumPlan plan_sum(const OrientationRuns& orientation, const SumTables& tables, int most) {
    struct Weighed {
        Run run;
        std::uint32_t least;
    };
    const Runs& runs = orientation.solid;
    std::vector<Weighed> weighed;
    weighed.reserve(runs.runs.size());
    for (std::size_t i = 0; i < runs.runs.size(); ++i) {
        weighed.push_back({runs.runs[i], orientation.least[i]});
    }
    SumPlan plan;
    plan.loads.reserve(runs.runs.size());
    const int longest = static_cast<int>(kSumRange / std::max(1, most));
    std::int64_t room = 0;  // voxels the batch can still take
    std::size_t count = kLoadsPerBatch;
    std::int64_t summed = 0;
    const auto halvings = [](const Weighed& of) {
        return std::bit_width(static_cast<unsigned>(of.run.length));
    };
    for (const auto& [run, least] : by_level(weighed, 33, kLoadsPerBatch, halvings)) {
        for (int done = 0; done < run.length;) {
            const int length = std::min(run.length - done, longest);
            if (length > room || count == kLoadsPerBatch) {
                const auto at = static_cast<std::int32_t>(plan.loads.size());
                plan.batches.push_back({at, at, 0});
                room = longest;
                count = 0;
            }
            VoxelIndex from = run.start;
            from[runs.axis] += done;
            VoxelIndex to = from;
            to[runs.axis] += length;
            // Of a run that is split, no part is known to hold the deep voxels.
            const std::uint32_t known =
                length == run.length ? least : std::min(least, static_cast<std::uint32_t>(length));
            const auto part = static_cast<std::uint16_t>(std::min<std::uint32_t>(known, kSumRange));
            plan.loads.push_back({tables.offset(runs.axis, to), tables.offset(runs.axis, from), part});
            plan.batches.back().end = static_cast<std::int32_t>(plan.loads.size());
            plan.least += part;
            summed += length;
            plan.batches.back().share =
                static_cast<float>(summed) / static_cast<float>(runs.voxels);
            room -= length;
            ++count;
            done += length;
        }
    }
    return plan;
}

}  // namespace spectralpack
