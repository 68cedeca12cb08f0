#include "search/cpu/tables/tray_tables.hpp"

#include <algorithm>
#include <bit>

#include "search/cpu/tuning.hpp"

namespace spectralpack {
namespace {

BitTables tables_for(const Tray& tray, int margin) {
    const bool walls = !tray.blocked().extent().empty();
    return BitTables(bit_layout(tray.extent(), margin, tray.detail(), tray.gap_classes(), walls));
}

template <class T>
Sums<T> make_sums(const Extent& grid, bool disjoint, const Workers& workers) {
    Sums<T> sums;
    workers.for_each(2, [&](std::int64_t i) {  // the system takes its time to find so much memory
        if (i == 0) sums.exact = {grid, SumLayout::kVoxel, false};
        if (i == 1) sums.coarse = {grid, SumLayout::kBlock, disjoint};
    });
    return sums;
}

void refresh_layer(BitTables& bits, CrowdTables& crowd, int layer, const std::vector<const BitGrid*>& parts,
                   const VoxelBox& changed, const Workers& workers) {
    bits.refresh(layer, parts, changed);
    crowd.refresh(bits, layer, changed, workers);
}

/// Brings the layers of a gap class up to date after a change within `changed`.
void refresh_class(BitTables& bits, CrowdTables& crowd, const Tray& tray, int gap_class, const VoxelBox& changed,
                   const Workers& workers) {
    std::vector<const BitGrid*> parts;
    for (int part = 0; part < part_count(tray.detail()); ++part) {
        parts.push_back(&tray.occupied_part(gap_class, part));
    }
    refresh_layer(bits, crowd, gap_class, parts, changed, workers);
    if (tray.detail() == 1) return;
    refresh_layer(bits, crowd, tray.gap_classes() + gap_class, {&tray.occupied(gap_class)}, changed, workers);
}

/// Fills empty tables.
void fill(BitTables& bits, CrowdTables& crowd, const Tray& tray, const Workers& workers) {
    for (int c = 0; c < tray.gap_classes(); ++c) {
        if (!tray.occupied(c).none()) refresh_class(bits, crowd, tray, c, whole(tray.extent()), workers);
    }
    if (tray.blocked().extent().empty() || tray.blocked().none()) return;
    refresh_layer(bits, crowd, bits.layers() - 1, {&tray.blocked()}, whole(tray.extent()), workers);
}

/// One more than the highest layer that holds anything.
int layers_used(const BitGrid& grid) {
    const std::vector<BitGrid::Word>& words = grid.words();
    const auto last = std::find_if(words.rbegin(), words.rend(), [](BitGrid::Word word) { return word != 0; });
    const std::int64_t in_layer = static_cast<std::int64_t>(grid.words_per_row()) * grid.extent().y;
    return static_cast<int>((words.rend() - last + in_layer - 1) / in_layer);
}

/// One more than the highest layer that an object reaches into, in the grid.
int layers_standing(const Tray& tray) {
    int top = 0;
    for (ObjectId id = 0; id < tray.object_count(); ++id) {
        if (const TrayObject* object = tray.find(id)) top = std::max(top, object->box().hi.z);
    }
    return std::min(top, tray.extent().z);
}

/// All that is occupied of Omega_place.
std::vector<const BitGrid*> occupied_grids(const Tray& tray) {
    std::vector<const BitGrid*> grids;
    for (int c = 0; c < tray.gap_classes(); ++c) {
        grids.push_back(&tray.occupied(c));
    }
    if (!tray.blocked().extent().empty()) grids.push_back(&tray.blocked());
    return grids;
}

}  // namespace

BitLayout bit_layout(const Extent& tray, int margin, int detail, int gap_classes, bool walls) {
    return {tray, margin, detail, gap_classes, (detail > 1 ? gap_classes : 0) + (walls ? 1 : 0)};
}

TrayDifference difference(const Tray& tray, std::uint64_t since, ObjectId objects) {
    TrayDifference result;
    for (std::uint64_t v = since; v < tray.version(); ++v) {
        const TrayChange& change = tray.changes()[v];
        if (change.added && tray.find(change.id)) result.added.push_back(change.id);
        if (!change.added && change.id < objects) result.removed.push_back(change.id);
    }
    return result;
}

/// A class that had objects once counts as occupied from then on: lists need not change each time its last one comes
/// and goes.
void TrayTables::note_occupied(const Tray& tray) {
    class_used_.resize(static_cast<std::size_t>(tray.gap_classes()), false);
    for (int c = 0; c < tray.gap_classes(); ++c) {
        if (!tray.occupied(c).none()) class_used_[static_cast<std::size_t>(c)] = true;
    }
    walls_ = !tray.blocked().none();
}

/// phi right wherever sums below layer `top` or minima of blocks that begin there look, and neighbours of what is
/// found.
void TrayTables::raise_phi(int top, const Workers& workers) {
    const int before = phi_.top();
    constexpr int kBeyond = kBlock - 1;
    phi_.raise((top + kBeyond + kBlock - 1) / kBlock * kBlock, workers);
    const Extent& n = phi_.extent();
    minima_.update(phi_, {{0, 0, before}, {n.x, n.y, phi_.top()}}, workers);
}

void TrayTables::rebuild_phi(const Tray& tray, const Workers& workers) {
    const Extent& n = tray.extent();
    phi_ = DistanceGrid(n, tray.setup().ceiling);
    minima_ = BlockMinima(n, kBlock);
    raise_phi(std::max(top_, layers_used(tray.omega_place())), workers);
    phi_.add(tray.omega_place(), {}, workers);
    ChangedLayers all(n.z);
    all.add({{0, 0, 0}, {n.x, n.y, phi_.top()}});
    note(all);
    update_from_phi(all.hull(), workers);
}

void TrayTables::rebuild(const Tray& tray, int margin, const Workers& workers) {
    const Extent& n = tray.extent();
    // What there was goes first.
    bits_ = {};
    crowd_ = {};
    words_.reset();
    bytes_.reset();
    quads_.reset();
    // As a run would have it that had searched for what stands. From the lowest layers up, each would be searched for a
    // best position of its own, and all of those asked about (Shape::admits).
    top_ = layers_standing(tray);
    minima_ = {};
    phi_ = {};
    large_ = n.count() >= large_from_;
    disjoint_ = tray.detail() == 1;
    // Bits and distances have nothing to do with each other.
    workers.for_each(2, [&](std::int64_t i) {
        if (i == 0) {
            bits_ = tables_for(tray, margin);
            crowd_ = large_ ? CrowdTables(bits_) : CrowdTables();
            fill(bits_, crowd_, tray, workers);
        } else {
            rebuild_phi(tray, workers);
        }
    });
    instance_ = tray.instance();
    class_used_.clear();
    ++epoch_;
    cells_ = {};
}

void TrayTables::follow_bits(const Tray& tray, const TrayDifference& changed, const Workers& workers) {
    for (const std::vector<ObjectId>* ids : {&changed.added, &changed.removed}) {
        for (const ObjectId id : *ids) {
            const TrayObject& object = tray.object(id);
            refresh_class(bits_, crowd_, tray, object.gap_class, object.box(), workers);
        }
    }
}

void TrayTables::follow_phi(const Tray& tray, const TrayDifference& changed, const Workers& workers) {
    VoxelBox all;
    // Before what went is taken out: additions stop where they lower nothing, which takes phi to be right everywhere.
    for (const ObjectId id : changed.added) {
        const TrayObject& object = tray.object(id);
        raise_phi(object.box().hi.z, workers);
        const ChangedLayers lowered = phi_.add(*object.solid, object.position, workers);
        note(lowered);
        cells_.add(id, object.box(), lowered.hull());
        all = hull(all, lowered.hull());
    }
    if (!changed.removed.empty()) {
        std::vector<VoxelBox> reaches;
        for (const ObjectId id : changed.removed) {
            reaches.push_back(phi_.reach_of(tray.object(id).box()));
        }
        const ChangedLayers raised = phi_.remove(reaches, occupied_grids(tray), workers);
        note(raised);
        all = hull(all, raised.hull());
        cells_.remove(changed.removed, reaches);
    }
    update_from_phi(all, workers);
}

void TrayTables::note(const ChangedLayers& changed) {
    if (words_) words_->note(changed);
    if (bytes_) bytes_->note(changed);
    if (quads_) quads_->note(changed);
    quads_follow_ = false;
}

/// What depends on phi, after it changed within `changed`.
void TrayTables::update_from_phi(const VoxelBox& changed, const Workers& workers) {
    workers.for_each(2, [&](std::int64_t i) {
        if (i == 0) choose_sums(workers);
        if (i == 1) minima_.update(phi_, changed, workers);
    });
}

/// Once phi is small enough for bytes it stays so until an object is removed.
void TrayTables::choose_sums(const Workers& workers) {
    in_bytes_ = may_use_bytes_ && phi_.most() <= SumTables<std::uint8_t>::kMostPooled;
    if (in_bytes_) {
        words_.reset();
        if (!bytes_) bytes_ = make_sums<std::uint8_t>(phi_.extent(), disjoint_, workers);
    } else {
        bytes_.reset();
        quads_.reset();
        quads_follow_ = false;
        if (!words_) words_ = make_sums<std::uint16_t>(phi_.extent(), disjoint_, workers);
    }
    follow_sums(workers);
}

void TrayTables::follow_sums(const Workers& workers) {
    if (in_bytes_) {
        bytes_->follow(phi_, top_, workers);
    } else {
        words_->follow(phi_, top_, workers);
    }
}

void TrayTables::follow_quads(const Workers& workers) {
    if (!quads_) quads_.emplace(phi_.extent(), SumLayout::kQuad, disjoint_);
    quads_->follow(phi_, top_, workers);
    quads_follow_ = true;
}

void TrayTables::raise(int top, const Workers& workers) {
    top_ = std::max(top_, std::min(top, phi_.extent().z));
    raise_phi(top_, workers);
    follow_sums(workers);
    if (quads_follow_) follow_quads(workers);
}

int TrayTables::phi_bound() const {
    if (in_bytes_) return SumTables<std::uint8_t>::kMostPooled;
    constexpr unsigned kLeast = SumTables<std::uint16_t>::kMostPooled;
    return static_cast<int>(std::bit_ceil(std::max(kLeast, static_cast<unsigned>(phi_.most()))));
}

bool TrayTables::starts_afresh(const Tray& tray, int margin) const {
    return tray.instance() != instance_ || margin > bits_.margin() || tray.version() < version_;
}

void TrayTables::follow(const Tray& tray, int margin, const Workers& workers) {
    bool afresh = starts_afresh(tray, margin);
    TrayDifference changed;
    if (!afresh) {
        changed = difference(tray, version_, objects_);
        afresh = changed.size() > tuning::kRebuildAfter;
    }
    if (afresh) {
        rebuild(tray, std::max(margin, bits_.margin()), workers);
    } else if (changed.size() > 0) {
        workers.for_each(2, [&](std::int64_t i) {
            i == 0 ? follow_bits(tray, changed, workers) : follow_phi(tray, changed, workers);
        });
    } else {
        choose_sums(workers);
    }
    if (version_ != tray.version() || afresh) note_occupied(tray);
    version_ = tray.version();
    objects_ = tray.object_count();
}

std::int64_t TrayTables::bytes() const {
    return bits_.bytes() + crowd_.bytes() + phi_.bytes() + minima_.bytes() + (words_ ? words_->bytes() : 0) +
           (bytes_ ? bytes_->bytes() : 0) + (quads_ ? quads_->bytes() : 0);
}

}  // namespace spectralpack
