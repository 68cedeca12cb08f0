#pragma once
/// Beam search over the order of copies (appendix B.3).

#include <functional>
#include <memory>
#include <vector>

#include "packing/order/packing_score.hpp"
#include "packing/tray/greedy.hpp"

namespace spectralpack {

struct BeamOptions {
    int width = 1;           ///< states that are kept
    std::vector<int> ranks;  ///< urgency_ranks(): only copies of equal rank change places
    /// For each state, so that one that goes on keeps the tables of its tray.
    std::function<std::unique_ptr<PlacementSearch>()> make_engine;
    PackingMeasures measures;
};

/// Which copies a state may place next: one of each of so many parts that come first and find a place. Of a beam of one
/// only the first, so that it is pack_greedily().
inline constexpr int kBeamBranch = 2;

/// Packs `copies` into `tray` as pack_greedily() does, but not in one order. A state is a tray in which some copies
/// stand. Each goes on by one copy, at its best placement, in up to kBeamBranch ways; of all states that result, the
/// `width` with the least cost go on: the sum of the costs of the copies placed by the sum of their voxels (with height
/// at the top, that of top layers times voxels by the sum of voxels, then that of proximities). States in which copies
/// of the same parts stand alike are one. Ties go to the earlier state, then the earlier copy. A state where nothing
/// finds a place any more is done; the result is the one with the best score, its copies in the order in which they
/// were placed: pack_greedily() in that order gives the same packing. When stopped, the best of what there is.
/// Deterministic; about width * kBeamBranch times the searches of pack_greedily(), and a tray and an engine a state.
/// For trays without caps.
void pack_in_beam(Tray& tray, const BeamOptions& options, const TrayContext& context, const std::vector<Copy>& copies,
                  const CopyDone& copy_done, GreedyResult& result);

}  // namespace spectralpack
