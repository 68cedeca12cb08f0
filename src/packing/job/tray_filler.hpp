#pragma once
/// One tray from empty to done: what stands in it from the start, the greedy packing on top of that, and where each
/// copy comes to stand.

#include <memory>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "packing/containers/fixed_copies.hpp"
#include "packing/interlocking/unlinked_search.hpp"
#include "packing/interlocking/untangle.hpp"
#include "packing/order/beam.hpp"
#include "packing/tray/filled_tray.hpp"
#include "packing/tray/greedy.hpp"
#include "packing/tray/refinement.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// What all trays of a job have in common, and the fixed copies of each.
struct FillOptions {
    TraySetup tray;       ///< the container's grid, walls and keep-outs; every tray starts from it
    Container container;  ///< with open height its size.z is infinite
    double wall_gap = 0;  ///< mm
    std::vector<FixedCopy> fixed;
    CostModel model;
    std::optional<double> max_density, max_layer_fill;  ///< packing/caps.hpp
    int most_layers = 0;                                ///< open height: the grid may grow to so many
    std::optional<BeamOptions> beam;       ///< copies are not tried in one order; without refinement and caps only
    bool refine = false;                   ///< continuous refinement (section 3.2)
    Interlock interlock = Interlock::off;  ///< section 4
    Links links = Links::avoid;            ///< with Interlock::post: whether copies may be placed linked with another
    TakeOut take_out = TakeOut::thinnest;  ///< with Interlock::post: what goes where some are interlocked
    Unpack unpack = Unpack::any;           ///< how plans take copies out; which are placed does not depend on it
    std::optional<double> ray_spacing;     ///< BodyOptions's
    Disassembler::Left left, to_put_back;  ///< told while a tray is taken apart, and while copies are put back
    /// Ends placing: what stands by then is still made to come apart. Requested at the latest where the context's stop
    /// is; none: that ends all.
    std::optional<StopToken> enough = {};
};

/// What one tray is to be filled with.
struct TrayCopies {
    int number = 0;                          ///< of the tray, from 0: which fixed copies stand in it
    std::vector<Copy> copies;                ///< in the order to try
    bool next = false;                       ///< another tray follows for what finds no place
    int give_up_after = 0;                   ///< parts that find no place (PlaceLimits)
    std::optional<HeightAt> height_at = {};  ///< none: as the model says
    /// Only this part of the tray, from its lower corner on, mm inside the wall gap; of trays without a mask, caps,
    /// physical walls and fixed copies. None: all of it.
    std::optional<Vec3> within = {};
};

class TrayFiller {
  public:
    /// `part_of`: the meshes that are moved.
    TrayFiller(FillOptions options, const PackContext& context, PartSurfaces::PartOf part_of);

    /// Fills a new tray with what finds a place of `wanted`. `result` as in pack_greedily(); in the end it is a packing
    /// that comes apart, unless interlocking is off. What finds no place is tried again where interlocked copies made
    /// room, unless it is left to a next tray.
    void fill(const TrayCopies& wanted, const CopyDone& copy_done, FilledTray& result);

    /// Fills one new tray with as many copies as fit, in shares, as pack_in_shares(), and makes it come apart as fill()
    /// does; copies then count from 0 again, and where that changes numbers the tray is told of anew. Where one part
    /// found no further place long before the others, the tray is filled once more with that part first, and the
    /// filling stays that has more of its share.
    void fill_in_shares(const std::vector<PartShare>& shares, const CopyDone& copy_done, FilledTray& result);

    const PackContext& context() const { return context_; }
    /// What ends placing.
    const StopToken& enough() const { return options_.enough ? *options_.enough : context_.stop; }
    double voxel_size() const { return options_.tray.voxel_size; }
    double wall_gap() const { return options_.wall_gap; }
    int trays_with_fixed() const { return trays_with_fixed_; }     ///< the number of the last such tray, plus one
    double refine_seconds() const { return refine_seconds_; }      ///< over all trays, for the record
    double untangle_seconds() const { return untangle_seconds_; }  ///< the same

  private:
    bool avoids_links() const { return options_.interlock == Interlock::post && options_.links == Links::avoid; }
    /// Calls `pack` with a tray in which only fixed copies stand, with refinement then `fill_up`, which may add to it
    /// off the grid; then makes what they packed come apart. Where a run before did so, its decisions take the place of
    /// these steps; false where that was all of them. `copies` has one of each part at least.
    template <class Pack, class FillUp>
    bool fill_one(const TrayCopies& wanted, const std::vector<Copy>& copies, FilledTray& result, const Pack& pack,
                  const FillUp& fill_up);
    void stand_again(const PackedTray& known, Tray& tray, const TrayContext& context, Refinement* refinement,
                     FilledTray& result) const;

    void fill_in_shares(const std::vector<PartShare>& shares, const FirstCopies& first, const CopyDone& copy_done,
                        FilledTray& result);
    FirstCopies lagging(const std::vector<PartShare>& shares, const std::vector<PlacedCopy>& placed) const;

    Vec3 room_for_moves(const TrayCopies& wanted) const;
    std::vector<Body> stand_fixed_copies(int number, Tray& tray, Refinement* refinement, Caps* caps) const;
    UntangleOptions untangle_options(const TrayCopies& wanted, const FilledTray& result);
    void make_removable(Tray& tray, const TrayContext& context, const UntangleOptions& options, FilledTray& result);

    FillOptions options_;
    PackContext context_;
    UnlinkedSearch unlinked_;
    PartSurfaces::PartOf part_of_;
    std::vector<PlacedSurface> walls_;       // for refinement
    std::optional<PhysicalWalls> physical_;  // where ways out have to pass them
    int trays_with_fixed_ = 0;
    double refine_seconds_ = 0, untangle_seconds_ = 0;
};

}  // namespace spectralpack
