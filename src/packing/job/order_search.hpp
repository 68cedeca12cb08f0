#pragma once
/// Looking for the order to pack in (appendix B.3): pack in several, keep the best.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "packing/job/trays_packer.hpp"

namespace spectralpack {

struct OrderSearchOptions {
    int restarts = 1;        ///< orders to pack in, the first being the one given
    int beam = 1;            ///< more than 1: also by beam search from the order given
    std::uint64_t seed = 0;  ///< of the other orders
    std::vector<int> ranks;  ///< urgency_ranks(): copies of different rank keep their order
    PackingMeasures measures;
};

/// Packs in this order, on the grid. None where this order cannot be packed in the memory there is; what the stop token
/// cut short is a packing, too.
using PackInOrder = std::function<std::optional<TraysResult>(const std::vector<Copy>& copies, bool beam)>;

struct FoundOrder {
    std::vector<Copy> copies;  ///< as placed, tray by tray, then what is left over
    TraysResult trays;         ///< the packing; its searches are those of all packings
    int packings = 0;          ///< that were compared
};

/// Packs in the order given, by beam search where asked for, then in orders perturbed from it (perturbed()), until the
/// stop token says enough; the packing with the best score is the answer, the first of equals. The first call of `pack`
/// must not return none.
FoundOrder find_order(const std::vector<Copy>& copies, const OrderSearchOptions& search, const PackInOrder& pack,
                      const StopToken& stop);

/// Which orders of a job are packed in, and when that ends.
struct BestOrderOptions {
    int restarts = 1, beam = 1;  ///< as in OrderSearchOptions
    std::uint64_t seed = 0;
    StopToken stop;
    StopToken enough;  ///< ends the search for an order, whose best is then packed in
    /// Of a beam of so many states: one engine each.
    std::function<std::unique_ptr<PlacementSearch>(int states)> make_engine;
};

/// Looks for the order that packs best on the grid, then packs in it as the job asks for. Cut off before all copies
/// were tried, that is the packing on the grid. An order that memory is too short for is passed over, but for the
/// first. `packed` holds what there is when an exception leaves this function. `observer` (may be null) is told of
/// that: of the last packing as it is made, of one on the grid at the end.
void pack_in_best_order(TraysPacker& packer, const BestOrderOptions& options, const TellProgress& tell,
                        TrayObserver* observer, PackedJob& packed);

}  // namespace spectralpack
