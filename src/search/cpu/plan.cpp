#include "search/cpu/plan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "search/cpu/depths.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kSumRange = 65535;   // what 16 bits hold
constexpr std::size_t kLoadsPerBatch = 24;  // between two looks at the limit
constexpr std::size_t kFirstBatch = 8;      // look-ups; later batches grow
constexpr std::size_t kLastBatch = 512;

struct Piece {
    BitTables::Place place;
    int level = 0;
};

/// Pieces of 2^k voxels that together cover the run and nothing else.
void cover(const Run& run, int axis, const VoxelIndex& offset, int layer, const BitTables& bits,
           std::vector<Piece>& pieces) {
    int level = 0;
    while (level < BitTables::kLevels && (2 << level) <= run.length)
        ++level;
    const int size = 1 << level;
    for (int done = 0; done < run.length; done += size) {
        VoxelIndex d = run.start + offset;
        d[axis] += std::min(done, run.length - size);
        pieces.push_back({bits.place(layer, axis, level, d), level});
    }
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
void append_batch(std::span<const Piece> pieces, CollisionPlan& plan) {
    std::array<std::int32_t, 65> begin{};
    for (const Piece& piece : pieces) {
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
    for (const Piece& piece : pieces) {
        plan.offsets[static_cast<std::size_t>(
            begin[static_cast<std::size_t>(piece.place.shift)]++)] = piece.place.offset;
    }
    plan.batches.push_back({first_group, static_cast<std::int32_t>(plan.groups.size())});
}

OrientationRuns::Widened runs_of(const WidenedVoxels& wide, int detail) {
    OrientationRuns::Widened result;
    result.runs = fewest_runs(wide.voxels);
    result.offset = wide.offset;
    if (detail == 1) return result;
    const CoarseVoxels core = filled_voxels(wide.voxels, wide.offset, detail);
    result.core = fewest_runs(core.voxels);
    result.core_offset = core.offset;
    const auto in_core = [&](const Run& run) {
        const int axis = result.runs.axis;
        for (int done = 0; done < run.length; ++done) {
            VoxelIndex at = run.start + wide.offset;
            at[axis] += done;
            for (int i = 0; i < 3; ++i) {
                at[i] = floor_div(at[i], detail) - core.offset[i];
            }
            if (!core.voxels.get(at.x, at.y, at.z)) return false;
        }
        return true;
    };
    std::erase_if(result.runs.runs, in_core);
    return result;
}

}  // namespace

OrientationRuns make_runs(const OrientedShape& shape, int detail, bool covers) {
    OrientationRuns result;
    result.solid = fewest_runs(*shape.solid);
    if (!covers) {
        result.least.assign(result.solid.runs.size(), 0);
    } else if (detail == 1) {
        result.least = depth_sums(*shape.solid, result.solid, result.solid);
    } else {
        const BitGrid core = filled_voxels(*shape.fine, {}, detail).voxels;
        result.least = depth_sums(core, runs_along(core, result.solid.axis), result.solid);
    }
    for (std::size_t c = 0; c < shape.widened.size(); ++c) {
        std::size_t same = 0;
        while (shape.widened[same] != shape.widened[c])
            ++same;
        if (same < c) {
            result.of_class.push_back(result.of_class[same]);
            continue;
        }
        result.of_class.push_back(static_cast<int>(result.widened.size()));
        result.widened.push_back(runs_of(*shape.widened[c], detail));
    }
    return result;
}

bool covers_solid(const Shape& shape) {
    for (const OrientedShape& oriented : shape.orientations) {
        for (std::size_t c = 0; c < oriented.widened.size(); ++c) {
            if (c > 0 && oriented.widened[c] == oriented.widened[c - 1]) continue;
            BitGrid bare = oriented.fine ? *oriented.fine : *oriented.solid;
            subtract(bare, oriented.widened[c]->voxels, oriented.widened[c]->offset);
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
    std::vector<Piece> pieces;
    const auto cover_all = [&](const Runs& shape, const VoxelIndex& offset, int layer) {
        for (const Run& run : shape.runs) {
            cover(run, shape.axis, offset, layer, tables.bits(), pieces);
        }
    };
    for (std::size_t c = 0; c < runs.of_class.size(); ++c) {
        const int gap_class = static_cast<int>(c);
        if (!tables.occupied(gap_class)) continue;
        const auto& widened = runs.widened[static_cast<std::size_t>(runs.of_class[c])];
        if (!widened.core.runs.empty()) cover_all(widened.core, widened.core_offset, tables.coarse_layer(gap_class));
        cover_all(widened.runs, widened.offset, tables.fine_layer(gap_class));
    }
    if (tables.walls()) cover_all(runs.solid, {}, tables.wall_layer());
    const std::vector<Piece> ordered = by_level(pieces, BitTables::kLevels + 1, kFirstBatch,
                                                [](const Piece& piece) { return piece.level; });
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
