#pragma once
/// What a shape's orientation asks of a tray's tables, worked out once.

#include <cstdint>

#include "search/cpu/shapes/loads.hpp"
#include "search/cpu/shapes/lookups.hpp"

namespace spectralpack {

/// All that an orientation asks of the tables of a tray. It holds until they start afresh or objects of a class come
/// in of which there were none.
struct OrientationLists {
    CollisionLookups lookups;
    LoadList exact;   ///< of single positions and of quads
    LoadList coarse;  ///< of blocks
};
OrientationLists lists_of(const OrientationRuns& runs, const TrayTables& tables);

/// Of what it holds in lists, about.
std::int64_t bytes_of(const OrientationLists& lists);

}  // namespace spectralpack
