#include "search/cpu/shape_cache.hpp"

#include <algorithm>
#include <utility>

#include "search/cpu/scan/reaching_blocks.hpp"
#include "search/cpu/tuning.hpp"

namespace spectralpack {
namespace {

/// True when a layer costs as much by one as by the other.
bool same_heights(const CostModel& a, const CostModel& b) {
    return a.height_penalty == b.height_penalty && a.height_at == b.height_at;
}

/// Reopens what may be free since objects went that stood when the entry was last brought up to date. Returns of which
/// orientations anything is still known.
std::vector<std::size_t> reopen_freed(const Shape& shape, const Tray& tray, const TrayTables& tables,
                                      const Workers& workers, ShapeCache::Entry& entry) {
    std::vector<VoxelBox> freed;
    for (const ObjectId id : difference(tray, entry.version, entry.objects).removed) {
        freed.push_back(tray.object(id).box());
    }
    std::vector<std::uint8_t> knows(entry.states.size(), 1);
    const BitGrid blocks = blocks_of(freed, tables.bits().margin(), tray.extent());
    if (!freed.empty()) {
        workers.for_each(std::ssize(entry.states), [&](std::int64_t i) {
            const auto k = static_cast<std::size_t>(i);
            knows[k] = entry.states[k].reopen(blocks_reaching(blocks, shape.orientations[k].solid.extent()));
        });
    }
    std::vector<std::size_t> known;
    for (std::size_t k = 0; k < knows.size(); ++k) {
        if (knows[k] != 0) known.push_back(k);
    }
    return known;
}

/// Forgets bounds of the `known` orientations where phi may have fallen since then; all of them where layers do not
/// cost what they did.
void forget_fallen(const Shape& shape, const Tray& tray, TrayTables& tables, bool same_heights, const Workers& workers,
                   const std::vector<std::size_t>& known, ShapeCache::Entry& entry) {
    const std::vector<VoxelBox> fallen =
        same_heights ? tables.fallen_since(entry.objects) : std::vector<VoxelBox>{whole(tray.extent())};
    if (fallen.empty()) return;
    const BitGrid blocks = blocks_of(fallen, 0, tray.extent());
    workers.for_each(std::ssize(known), [&](std::int64_t i) {
        const std::size_t k = known[static_cast<std::size_t>(i)];
        entry.states[k].forget(blocks_reaching(blocks, shape.orientations[k].solid.extent()));
    });
}

}  // namespace

ShapeCache::Entry& ShapeCache::at(const Shape& shape, const Tray& tray, TrayTables& tables, const CostModel& model,
                                  const Workers& workers) {
    if (tables.epoch() != epoch_) {
        epoch_ = tables.epoch();
        entries_.clear();  // also what takes no memory: that nothing fitted the last tray says nothing of the next
        bytes_ = 0;
    }
    auto found = entries_.find(shape.id);
    if (found == entries_.end()) {
        found = entries_.emplace(shape.id, fresh(shape, tray)).first;
    } else {
        Entry& entry = found->second;
        ++entry.hits;
        const std::vector<std::size_t> known = reopen_freed(shape, tray, tables, workers, entry);
        entry.known = !known.empty();
        if (entry.known) {
            forget_fallen(shape, tray, tables, same_heights(entry.model, model), workers, known, entry);
        }
    }
    Entry& entry = found->second;
    entry.version = tables.version();
    entry.objects = tray.object_count();
    entry.model = model;
    entry.last_use = ++uses_;
    return entry;
}

ShapeCache::Entry ShapeCache::fresh(const Shape& shape, const Tray& tray) {
    Entry entry;
    std::vector<Extent> counts;
    for (const OrientedShape& oriented : shape.orientations) {
        counts.push_back(tray.candidates(oriented.reach));
        entry.state_bytes += PositionState::bytes_for(counts.back(), !shape.is_once());
    }
    entry.bytes = entry.state_bytes;
    evict_for(entry.bytes);
    bytes_ += entry.bytes;
    for (const Extent& count : counts) {
        entry.states.emplace_back(count, !shape.is_once());
    }
    entry.runs.resize(counts.size());
    entry.lists.resize(counts.size());
    return entry;
}

void ShapeCache::evict_for(std::int64_t bytes) {
    while (bytes_ + bytes > budget_ && !entries_.empty()) {
        const auto less_useful = [](const auto& a, const auto& b) {
            const double worth_a = static_cast<double>(a.second.hits) / static_cast<double>(a.second.bytes + 1);
            const double worth_b = static_cast<double>(b.second.hits) / static_cast<double>(b.second.bytes + 1);
            return worth_a != worth_b ? worth_a < worth_b : a.second.last_use < b.second.last_use;
        };
        const auto gone = std::min_element(entries_.begin(), entries_.end(), less_useful);
        bytes_ -= gone->second.bytes;
        entries_.erase(gone);
    }
}

void ShapeCache::make_lists(Entry& entry, const std::vector<bool>& open, const TrayTables& tables,
                            const Workers& workers) {
    if (entry.listed_classes != tables.occupied_classes() || entry.listed_in_bytes != tables.in_bytes() ||
        entry.listed_phi_bound < tables.phi_bound()) {
        entry.listed_classes = tables.occupied_classes();
        entry.listed_phi_bound = tables.phi_bound();
        entry.listed_in_bytes = tables.in_bytes();
        std::ranges::fill(entry.lists, OrientationLists());
    }
    workers.for_each(std::ssize(open), [&](std::int64_t i) {
        const auto k = static_cast<std::size_t>(i);
        if (open[k] && entry.lists[k].exact.loads.empty()) {
            entry.lists[k] = lists_of(entry.runs[k], tables);
        }
    });
    bytes_ -= entry.bytes;
    entry.bytes = entry.state_bytes;
    for (std::size_t i = 0; i < entry.runs.size(); ++i) {
        entry.bytes += bytes_of(entry.runs[i]) + bytes_of(entry.lists[i]);
    }
    bytes_ += entry.bytes;
}

std::vector<bool> open_orientations(const Shape& shape, int margin, std::vector<PositionState>& states) {
    std::vector<bool> open;
    for (std::size_t i = 0; i < states.size(); ++i) {
        std::vector<VoxelBox> left;
        for (const VoxelBox& box : shape.only_near) {
            const Extent& a = shape.orientations[i].solid.extent();
            left.push_back({box.lo - VoxelIndex{a.x - 1 + margin, a.y - 1 + margin, a.z - 1 + margin},
                            box.hi + VoxelIndex{margin, margin, margin}});
        }
        if (!left.empty()) states[i].leave_only(left);
        open.push_back(!states[i].all_dead());
    }
    return open;
}

std::vector<ScoredPosition> seeds_after(const Incumbent& incumbent, const std::vector<ScoredPosition>& before) {
    std::vector<ScoredPosition> seeds = incumbent.beaten();
    for (const ScoredPosition& seed : before) {
        if (seeds.size() >= tuning::kSeeds) break;
        const auto same = [&](const ScoredPosition& s) { return s.index == seed.index && s.position == seed.position; };
        if (std::ranges::none_of(seeds, same)) seeds.push_back(seed);
    }
    return seeds;
}

}  // namespace spectralpack
