#pragma once
/// Everything the engine derives from a tray, brought up to date from the tray's changes: bit tables and crowd tables,
/// phi, its prefix sums and block minima. Follows one tray at a time; a different one, or a wider margin, starts
/// afresh.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "search/cpu/tables/bit_tables.hpp"
#include "search/cpu/tables/block_minima.hpp"
#include "search/cpu/tables/crowd_tables.hpp"
#include "search/cpu/tables/distance_grid.hpp"
#include "search/cpu/tables/object_cells.hpp"
#include "search/cpu/tables/sum_tables.hpp"
#include "search/tray.hpp"

namespace spectralpack {

/// Of bit tables of a tray in voxels of dx: a fine layer for each gap class; with detail > 1 a coarse one for each as
/// well; one of the walls, if there may be any.
BitLayout bit_layout(const Extent& tray, int margin, int detail, int gap_classes, bool walls);

/// Of phi and of phi pooled over blocks.
template <class T>
struct Sums {
    SumTables<T> exact, coarse;

    void note(const ChangedLayers& changed) {
        exact.note(changed);
        coarse.note(changed);
    }
    void follow(const DistanceGrid& phi, int top, const Workers& workers) {
        workers.for_each(2, [&](std::int64_t i) {  // of either little can be done at once
            i == 0 ? exact.follow(phi, top, workers) : coarse.follow(phi, top, workers);
        });
    }
    std::int64_t bytes() const { return exact.bytes() + coarse.bytes(); }
};

/// What makes a tray differ from an earlier version of it: what was added since and stands, and what stood then and is
/// gone. What came and went meanwhile is neither.
struct TrayDifference {
    std::vector<ObjectId> added, removed;
    std::size_t size() const { return added.size() + removed.size(); }
};

/// `objects`: Tray::object_count() at the version `since`.
TrayDifference difference(const Tray& tray, std::uint64_t since, ObjectId objects);

class TrayTables {
  public:
    /// Blocks of positions that the coarse bound looks at.
    static constexpr int kBlock = SumLayout::kPooledBlock;

    /// `large_from`: how many voxels make a tray large(). `bytes`: sums may be in_bytes().
    explicit TrayTables(std::int64_t large_from = 0, bool bytes = true)
        : large_from_(large_from), may_use_bytes_(bytes) {}

    /// Brings the tables to the tray's version, sums and phi below layer top(). `margin`: voxels by which an A+g may
    /// reach beyond A.
    void follow(const Tray& tray, int margin, const Workers& workers);

    const BitTables& bits() const { return bits_; }
    /// In a large tray more is worth making than in a small one: crowd tables, small cells of solids. And threads keep
    /// together there.
    bool large() const { return large_; }
    const CrowdTables& crowd() const { return crowd_; }
    /// Right below its own top, which is a little higher than top() and where no block ends or begins in between.
    const DistanceGrid& phi() const { return phi_; }
    /// Calls visit(sums) with the Sums that follow: of bytes, which is half of what the search reads most, where no phi
    /// is above what they can tell; else of 16 bits.
    template <class Visit>
    void visit_sums(const Visit& visit) const {
        if (in_bytes_) {
            visit(*bytes_);
        } else {
            visit(*words_);
        }
    }
    bool in_bytes() const { return in_bytes_; }
    /// Pooled over quads of positions; where in_bytes(). Not followed unless asked to: only solids of few runs ask for
    /// it.
    const SumTables<std::uint8_t>& quads() const { return *quads_; }
    /// Brings quads() to the version of the rest, below layer top() as well.
    void follow_quads(const Workers& workers);
    /// Sums, and quads where they followed, are right below this layer: the whole tray, or as far as anybody asked.
    int top() const { return top_; }
    /// Raises top() to `top`.
    void raise(int top, const Workers& workers);
    /// Of phi where it is right; 0 above that.
    const BlockMinima& minima() const { return minima_; }

    /// True when copies share no voxel of dx (s = 1): as every A+g holds its A, the bounds here take that for granted.
    bool disjoint() const { return disjoint_; }

    /// True when objects of the class stand in the tray, or have stood there in this epoch.
    bool occupied(int gap_class) const { return class_used_[static_cast<std::size_t>(gap_class)]; }
    int occupied_classes() const { return static_cast<int>(std::ranges::count(class_used_, true)); }
    /// True when the container mask or a keep-out holds anything.
    bool walls() const { return walls_; }
    /// Layers of bits(): the gap class's objects in voxels of dx / s; in voxels of dx (with s > 1); the walls.
    int fine_layer(int gap_class) const { return gap_class; }
    int coarse_layer(int gap_class) const { return static_cast<int>(class_used_.size()) + gap_class; }
    int wall_layer() const { return bits_.layers() - 1; }

    /// Grows whenever what was derived before is void: a new tray, a fresh start.
    std::uint64_t epoch() const { return epoch_; }
    std::uint64_t version() const { return version_; }
    /// Boxes outside of which no phi is less than it was in this epoch when the tray had had `objects` objects.
    std::vector<VoxelBox> fallen_since(ObjectId objects) { return cells_.of_newer(objects, phi_); }
    /// No phi is above it. It moves in powers of two, so that what is made for it serves as phi falls and rises.
    int phi_bound() const;

    std::int64_t bytes() const;

  private:
    bool starts_afresh(const Tray& tray, int margin) const;
    void rebuild(const Tray& tray, int margin, const Workers& workers);
    void rebuild_phi(const Tray& tray, const Workers& workers);
    void follow_bits(const Tray& tray, const TrayDifference& changed, const Workers& workers);
    void follow_phi(const Tray& tray, const TrayDifference& changed, const Workers& workers);
    void raise_phi(int top, const Workers& workers);
    void note(const ChangedLayers& changed);
    void update_from_phi(const VoxelBox& changed, const Workers& workers);
    void choose_sums(const Workers& workers);
    void follow_sums(const Workers& workers);
    void note_occupied(const Tray& tray);

    std::int64_t large_from_;
    bool may_use_bytes_;
    bool large_ = false;
    BitTables bits_;
    CrowdTables crowd_;
    DistanceGrid phi_;
    // Those that nobody asks for are not there, or fall behind: they know what changed meanwhile.
    std::optional<Sums<std::uint16_t>> words_;
    std::optional<Sums<std::uint8_t>> bytes_;
    bool in_bytes_ = false;  // bytes_ follow
    std::optional<SumTables<std::uint8_t>> quads_;
    bool quads_follow_ = false;  // are of the version of the rest
    int top_ = 0;
    BlockMinima minima_;
    bool disjoint_ = true;
    std::vector<bool> class_used_;
    bool walls_ = false;
    std::uint64_t instance_ = 0, version_ = 0, epoch_ = 0;
    ObjectId objects_ = 0;  // that the tray had had at that version
    ObjectCells cells_;
};

}  // namespace spectralpack
