#pragma once
/// The search over one orientation's positions, brick layer by brick layer, in two stages. Prune: leave out what lies
/// in a crowd (a few look-ups for many blocks) or in the open (a few values of phi a block), then stacks (a few
/// look-ups for four positions one above the other), then single positions (a few look-ups each), then blocks by a
/// bound of rho (pooled phi). Evaluate what is left: the remaining look-ups, the exact rho
/// (docs/algorithm/fast-engine.md, step 7).

#include <cstdint>
#include <vector>

#include "search/cpu/scan/incumbent.hpp"
#include "search/cpu/scan/position_state.hpp"
#include "search/cpu/shapes/orientation_lists.hpp"

namespace spectralpack {

/// One search's question and its answer so far; shared by all orientations and threads.
struct SearchContext {
    const TrayTables& tables;
    CostModel model;
    int reference_layers = 0;
    const SumTables<std::uint8_t>* quads = nullptr;  ///< to be asked before single positions; null: none
    Incumbent incumbent;
};

/// An orientation to search. Refers to what it was made from.
struct OrientationTask {
    SearchContext& context;
    PositionState& state;
    const OrientationRuns& runs;
    const OrientationLists& lists;
    int index = 0;                   ///< in Shape::orientations
    int layers = 0;                  ///< the solid's extent along z
    bool for_copy = false;           ///< something is known of the state from searches before
    const Admits* admits = nullptr;  ///< Shape::admits; null: every candidate
};

/// Offers the best free position of brick layers [begin, end) to the incumbent, if it could be the
/// answer. Different ranges may run on different threads.
void search_layers(OrientationTask& task, int begin, int end);

/// Offers one candidate, if it is free and could be the answer.
void search_position(OrientationTask& task, const VoxelIndex& position);

}  // namespace spectralpack
