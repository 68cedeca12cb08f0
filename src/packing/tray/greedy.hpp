#pragma once
/// Greedy packing (Algorithm 2): copies in order, each at its best placement among those already placed.

#include <cstddef>
#include <functional>
#include <vector>

#include "packing/tray/context.hpp"
#include "packing/tray/filled_tray.hpp"

namespace spectralpack {

/// Called after each copy with how many are done.
using CopyDone = std::function<void(std::size_t copies_done)>;

/// The best placement that `search` finds for `shape`, of `copy`, within the limits. Under an open ceiling `tray` is
/// replaced by a higher one while a place above its grid could be the best (packing/tray/open_height.hpp); throws
/// ResourceError where that takes more than most_layers.
SearchResult find_place(Tray& tray, PlacementSearch& search, const TrayContext& context, const Copy& copy,
                        const Shape& shape);

enum class PlaceOutcome { placed, no_place, stopped };

/// Only asked for where a copy is searched for.
using ShapeOfCopy = std::function<const Shape&()>;

/// Stands the copy at its best placement, within the limits, and settles it there: it is added to the tray, the caps
/// and what `result` has placed; the observer is told. Else `result` says why where a cap left no place.
PlaceOutcome place_copy(Tray& tray, const TrayContext& context, const Copy& copy, const ShapeOfCopy& shape_of,
                        GreedyResult& result);

/// Packs `copies` into `tray` on top of what stands there; the shapes have been told of them (start_tray). A copy whose
/// part has already found no place is left over without a search: the tray only fills up. `result` is filled as it
/// goes, so that it holds what was done when an exception (out of memory, two engines that disagree) leaves this
/// function.
/// Under an open ceiling `tray` is replaced by a higher one whenever a place above its grid could be the best
/// (packing/tray/open_height.hpp), so that its height to begin with does not matter and no copy that fits the base is
/// left over; throws ResourceError where that takes more than most_layers.
void pack_greedily(Tray& tray, const TrayContext& context, const std::vector<Copy>& copies, const CopyDone& copy_done,
                   GreedyResult& result);

/// A part and how many of its copies there should be for so many of the others'.
struct PartShare {
    int part = 0;
    int share = 1;
};

/// Each time asks `place` for one more copy of the part that lacks most of its share among the parts that still find a
/// place (the first of them in `shares`); a part that finds none is out. Ends when all are out, or stopped. `placed`
/// holds the copies of each that there are, and counts on.
void share_out(const std::vector<PartShare>& shares, std::vector<int>& placed,
               const std::function<PlaceOutcome(std::size_t index, const Copy& copy)>& place);

/// So many copies of a part, by its place in the shares.
struct FirstCopies {
    std::size_t index = 0;
    int count = 0;
};

/// As many copies as find a place, by share_out(), but `first` first. Copies count from 0 in each part. The shapes have
/// been told of one copy a part, in the order of `shares`. Nothing is left over.
void pack_in_shares(Tray& tray, const TrayContext& context, const std::vector<PartShare>& shares,
                    const FirstCopies& first, const CopyDone& copy_done, GreedyResult& result);

}  // namespace spectralpack
