#pragma once
/// How trays are filled, and with what.

#include <optional>
#include <vector>

#include "packing/containers/fixed_copies.hpp"
#include "packing/interlocking/untangle.hpp"
#include "packing/order/beam.hpp"
#include "packing/tray/placed_copy.hpp"
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
    bool take_apart = true;                ///< else what is packed is left as it is, whatever `interlock` says
    Links links = Links::avoid;            ///< with Interlock::post: whether copies may be placed linked with another
    TakeOut take_out = TakeOut::thinnest;  ///< with Interlock::post: what goes where some are interlocked
    bool repair = true;                    ///< what is interlocked is put back elsewhere
    Unpack unpack = Unpack::any;           ///< how plans take copies out; which are placed does not depend on it
    std::optional<double> ray_spacing;     ///< BodyOptions's
    Disassembler::Left left, to_put_back;  ///< told while a tray is taken apart, and while copies are put back
    /// Ends placing: what stands by then is still made to come apart. Requested at the latest where the context's stop
    /// is; none: that ends all.
    std::optional<StopToken> enough = {};
};

/// The same, for packings on the grid that are only compared: nothing is refined or taken apart.
inline FillOptions on_grid(FillOptions options) {
    options.refine = options.take_apart = false;
    return options;
}

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

}  // namespace spectralpack
