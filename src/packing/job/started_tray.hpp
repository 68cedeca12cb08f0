#pragma once
/// A new tray with what stands in it from the start, and all that packing copies into it takes: caps, refinement, and
/// the search that places them.

#include <memory>
#include <optional>
#include <vector>

#include "packing/containers/physical_walls.hpp"
#include "packing/interlocking/reachable_search.hpp"
#include "packing/interlocking/unlinked_search.hpp"
#include "packing/job/fill_options.hpp"
#include "packing/tray/caps.hpp"
#include "packing/tray/compaction.hpp"
#include "packing/tray/context.hpp"
#include "packing/tray/filled_tray.hpp"
#include "packing/tray/part_surfaces.hpp"
#include "packing/tray/refinement.hpp"

namespace spectralpack {

/// What all trays of a job share.
struct TraySurroundings {
    FillOptions options;
    PackContext context;
    PartSurfaces::PartOf part_of;           ///< the meshes that are moved
    std::vector<PlacedSurface> walls;       ///< for refinement
    std::optional<PhysicalWalls> physical;  ///< where ways out have to pass them
    UnlinkedSearch unlinked;

    TraySurroundings(FillOptions fill, const PackContext& pack, PartSurfaces::PartOf parts);

    const StopToken& enough() const { return options.enough ? *options.enough : context.stop; }
    bool avoids_links() const { return options.interlock == Interlock::post && options.links == Links::avoid; }
    /// Refinement for a tray, or the part of it that `wanted` says.
    RefineOptions refining(const TrayCopies& wanted) const;
};

class StartedTray {
  public:
    /// `around` and `wanted` outlive it. `refine`: whether copies slide off the grid.
    StartedTray(TraySurroundings& around, const TrayCopies& wanted, bool refine);
    StartedTray(const StartedTray&) = delete;
    StartedTray& operator=(const StartedTray&) = delete;

    /// For packing this tray, asked of `search` until `stop`.
    TrayContext context(PlacementSearch& search, const StopToken& stop);
    /// By which copies are placed: past links, to reachable places, or anywhere.
    PlacementSearch& search();
    HeightAt height_at() const { return model_.height_at; }
    /// Seconds that moving copies took since this was asked last.
    double take_refine_seconds();

    Tray& tray() { return tray_; }
    PartSurfaces& surfaces() { return surfaces_; }
    Caps* caps() { return caps_ ? &*caps_ : nullptr; }
    Refinement* refinement() { return refinement_.get(); }  ///< null: copies stand on the grid
    const std::vector<Body>& fixed() const { return fixed_; }
    /// What stands from the start, as surfaces: walls, where refinement needs them, and fixed copies.
    const std::vector<PlacedSurface>& standing() const { return standing_; }

    /// Stands copies where they were found to stand before, off the grid only with refinement. Their `object` becomes
    /// this tray's. The context's observer is told.
    void stand(std::vector<PlacedCopy>& placed, const TrayContext& context);
    /// A copy that stood on the grid stands there again. Returns its object.
    ObjectId add_on_grid(const PlacedCopy& placed, const Shape& shape);
    /// compact() for all that is placed here; with refinement. The context's observer is told.
    void compact(std::vector<PlacedCopy>& placed, const TrayContext& context);

  private:
    void make_caps();
    void make_refinement();
    void stand_fixed_copies();
    void stand(const PlacedSurface& obstacle);
    Settled settle(const Copy& copy, const Shape& shape, const BestPlacement& best);
    Settled settle_again(const PlacedCopy& placed);

    TraySurroundings& around_;
    const TrayCopies& wanted_;
    CostModel model_;
    Tray tray_;
    PartSurfaces surfaces_;
    std::optional<Caps> caps_;
    std::unique_ptr<Refinement> refinement_;
    std::vector<Body> fixed_;
    std::vector<PlacedSurface> standing_;
    ReachableSearch reachable_;
    double refining_ = 0, compacting_ = 0;
};

}  // namespace spectralpack
