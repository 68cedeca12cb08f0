#pragma once
/// One tray from empty to done: what stands in it from the start, the greedy packing on top of that, and where each
/// copy comes to stand.

#include <memory>
#include <optional>
#include <vector>

#include "packing/job/fill_options.hpp"
#include "packing/job/started_tray.hpp"
#include "packing/tray/filled_tray.hpp"
#include "packing/tray/greedy.hpp"

namespace spectralpack {

class TrayFiller {
  public:
    /// `part_of`: the meshes that are moved.
    TrayFiller(FillOptions options, const PackContext& context, PartSurfaces::PartOf part_of);

    /// Fills a new tray with what finds a place of `wanted`. `result` as in pack_greedily(); in the end it is a packing
    /// that comes apart, unless interlocking is off. What finds no place is tried again where interlocked copies made
    /// room, unless it is left to a next tray.
    void fill(const TrayCopies& wanted, const CopyDone& copy_done, FilledTray& result);

    /// Fills a new tray with a layout of some of `wanted`, whose copies stand on the grid or, with refinement,
    /// anywhere; with refinement it is compacted unless it `is_compact`. What found no place in it is tried again. Then
    /// as fill().
    void finish(const TrayCopies& wanted, const std::vector<PlacedCopy>& layout, bool is_compact, FilledTray& result);

    /// A new tray for who packs it by himself, on the grid. `wanted` outlives it.
    StartedTray start(const TrayCopies& wanted) { return {around_, wanted, false}; }
    /// The same pairs are asked about over and over: UnlinkedSearch::keep_answers().
    void keep_answers(std::int64_t bytes) { around_.unlinked.keep_answers(bytes); }
    RefineOptions refining(const TrayCopies& wanted) const { return around_.refining(wanted); }
    const FillOptions& options() const { return around_.options; }

    /// Fills one new tray with as many copies as fit, in shares, as pack_in_shares(), and makes it come apart as fill()
    /// does; copies then count from 0 again, and where that changes numbers the tray is told of anew. Where one part
    /// found no further place long before the others, the tray is filled once more with that part first, and the
    /// filling stays that has more of its share.
    void fill_in_shares(const std::vector<PartShare>& shares, const CopyDone& copy_done, FilledTray& result);

    const PackContext& context() const { return around_.context; }
    /// What ends placing.
    const StopToken& enough() const { return around_.enough(); }
    double voxel_size() const { return around_.options.tray.voxel_size; }
    double wall_gap() const { return around_.options.wall_gap; }
    int trays_with_fixed() const { return trays_with_fixed_; }     ///< the number of the last such tray, plus one
    double refine_seconds() const { return refine_seconds_; }      ///< over all trays, for the record
    double untangle_seconds() const { return untangle_seconds_; }  ///< the same

  private:
    /// Calls `pack` with a tray in which only fixed copies stand, with refinement then `fill_up`, which may add to it
    /// off the grid; where height counts at the top, and all found a place, it `compacts` that; then makes it come
    /// apart. Where a run before did so, its decisions take the place of these steps; false where that was all of them.
    /// `copies` has one of each part at least.
    template <class Pack, class FillUp>
    bool fill_one(const TrayCopies& wanted, bool compacts, const std::vector<Copy>& copies, FilledTray& result,
                  const Pack& pack, const FillUp& fill_up);

    void fill_in_shares(const std::vector<PartShare>& shares, const FirstCopies& first, const CopyDone& copy_done,
                        FilledTray& result);
    FirstCopies lagging(const std::vector<PartShare>& shares, const std::vector<PlacedCopy>& placed) const;

    UntangleOptions untangle_options(const TrayCopies& wanted, const FilledTray& result);
    void make_removable(Tray& tray, const TrayContext& context, const UntangleOptions& options, FilledTray& result);

    TraySurroundings around_;
    int trays_with_fixed_ = 0;
    double refine_seconds_ = 0, untangle_seconds_ = 0;
};

}  // namespace spectralpack
