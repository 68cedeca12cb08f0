#include "search/cpu/tray_tables.hpp"

#include "core/error.hpp"

namespace spectralpack {
namespace {

constexpr std::uint64_t kTightenEvery = 8;   // versions between exact maxima of phi
constexpr std::uint64_t kRebuildAfter = 64;  // pending changes that make a fresh start cheaper

VoxelBox box_of(const TrayObject& object) {
    const Extent& s = object.solid->extent();
    return {object.position, object.position + VoxelIndex{s.x, s.y, s.z}};
}

}  // namespace

void TrayTables::note_occupied(const Tray& tray) {
    layer_used_.assign(static_cast<std::size_t>(bits_.layers()), false);
    for (int c = 0; c < tray.gap_classes(); ++c) {
        layer_used_[static_cast<std::size_t>(c)] = !tray.occupied(c).none();
    }
    if (!tray.blocked().extent().empty()) layer_used_.back() = !tray.blocked().none();
}

void TrayTables::rebuild_phi(const Tray& tray, const Workers& workers) {
    phi_ = DistanceGrid(tray.extent(), tray.setup().ceiling);
    phi_.add(tray.omega_place(), {}, workers);
    phi_.tighten_most();
    sums_.update(phi_, whole(tray.extent()), workers);
    coarse_.update(phi_, whole(tray.extent()), workers);
    minima_.update(phi_, whole(tray.extent()), workers);
    ++epoch_;
    epoch_start_ = tray.version();
    changes_.clear();
}

void TrayTables::rebuild(const Tray& tray, int margin, bool apart, const Workers& workers) {
    const Extent& n = tray.extent();
    const bool walls = !tray.blocked().extent().empty();
    bits_ = BitTables(n, margin, tray.gap_classes() + (walls ? 1 : 0));
    apart_ = apart;
    sums_ = SumTables(n, 1, false);
    coarse_ = SumTables(n, kBlock, apart);
    minima_ = BlockMinima(n, kBlock);
    for (int c = 0; c < tray.gap_classes(); ++c) {
        bits_.refresh(c, tray.occupied(c), whole(n));
    }
    if (walls) bits_.refresh(tray.gap_classes(), tray.blocked(), whole(n));
    rebuild_phi(tray, workers);
    instance_ = tray.instance();
}

void TrayTables::follow(const Tray& tray, int margin, bool apart, const Workers& workers) {
    const bool afresh = tray.instance() != instance_ || margin > bits_.margin() || (apart_ && !apart) ||
                        tray.version() < version_ || tray.version() - version_ > kRebuildAfter;
    if (afresh) {
        const bool same_tray = tray.instance() == instance_;
        rebuild(tray, std::max(margin, bits_.margin()), apart && (apart_ || !same_tray), workers);
    } else if (tray.version() > version_) {
        const std::uint64_t first = version_;
        bool removed = false;
        for (std::uint64_t v = first; v < tray.version(); ++v) {
            const TrayChange& change = tray.journal()[v];
            const TrayObject& object = tray.object(change.id);
            bits_.refresh(object.gap_class, tray.occupied(object.gap_class), box_of(object));
            removed = removed || !change.added;
        }
        if (removed) {
            rebuild_phi(tray, workers);
        } else {
            VoxelBox all;
            for (std::uint64_t v = first; v < tray.version(); ++v) {
                const TrayObject& object = tray.object(tray.journal()[v].id);
                const VoxelBox changed = phi_.add(*object.solid, object.position, workers);
                changes_.push_back(changed);
                all = hull(all, changed);
                if (v % kTightenEvery == 0) phi_.tighten_most();
            }
            sums_.update(phi_, all, workers);
            coarse_.update(phi_, all, workers);
            minima_.update(phi_, all, workers);
        }
    }
    if (version_ != tray.version() || afresh) note_occupied(tray);
    version_ = tray.version();
#ifndef NDEBUG
    if (version_ % 16 == 0 || afresh) check(tray);
#endif
}

VoxelBox TrayTables::changed_since(std::uint64_t since) const {
    VoxelBox box;
    for (std::uint64_t v = std::max(since, epoch_start_); v < version_; ++v) {
        box = hull(box, changes_[v - epoch_start_]);
    }
    return box;
}

std::int64_t TrayTables::bytes() const {
    return bits_.bytes() + phi_.bytes() + sums_.bytes() + coarse_.bytes() + minima_.bytes();
}

void TrayTables::check(const Tray& tray) const {
    const auto require = [](bool equal, const char* what) {
        if (!equal) throw InternalError(std::string("the engine's ") + what + " went wrong");
    };
    const Extent& n = tray.extent();
    const Grid<std::int32_t> phi = manhattan_distance(tray.omega_place(), tray.setup().ceiling);
    int most = 0;
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            for (int x = 0; x < n.x; ++x) {
                require(phi_.at(x, y, z) == phi.at(x, y, z), "distance field");
                most = std::max(most, phi.at(x, y, z));
            }
        }
    }
    require(most <= phi_.most(), "greatest distance");
    SumTables sums(n, 1, false), coarse(n, kBlock, apart_);
    const Workers one(1);
    sums.update(phi_, whole(n), one);
    coarse.update(phi_, whole(n), one);
    require(sums == sums_ && coarse == coarse_, "prefix sums");
    BlockMinima minima(n, kBlock);
    minima.update(phi_, whole(n), one);
    require(minima == minima_, "block minima");
    BitTables bits(n, bits_.margin(), bits_.layers());
    for (int c = 0; c < tray.gap_classes(); ++c) {
        bits.refresh(c, tray.occupied(c), whole(n));
    }
    if (bits.layers() > tray.gap_classes())
        bits.refresh(tray.gap_classes(), tray.blocked(), whole(n));
    require(bits == bits_, "bit tables");
}

}  // namespace spectralpack
