#pragma once
/// The one place that knows which engines there are.

#include <cstdint>
#include <memory>

#include "core/parallel.hpp"
#include "search/metric_fields.hpp"
#include "search/placement_search.hpp"
#include "spectralpack/options.hpp"

namespace spectralpack {

/// What `kind` stands for in this build: automatic is the fast engine of this machine. Throws UsageError for an
/// engine that this build does not have.
EngineKind resolve_engine(EngineKind kind);

/// An engine of a resolved kind. `cache_bytes`: what it may keep to answer copies of a part faster.
std::unique_ptr<PlacementSearch> make_engine(EngineKind kind, std::int64_t cache_bytes, const Workers& workers);

/// Whole fields of orientation `index`, by the reference engine. Throws UsageError where this build has none.
MetricFields reference_fields(const Tray& tray, const Shape& shape, int index, const Workers& workers);

/// What decides an engine's memory.
struct EngineNeed {
    Extent tray;
    int overhang = 0;  ///< voxels by which A+g reaches beyond A on a side, at most
    int gap_classes = 1;
    int detail = 1;                ///< s of the tray
    Extent ways;                   ///< the grid in which it will be asked for ways out; empty where it will not
    std::size_t orientations = 1;  ///< of a part, at most
    double surface = 0;            ///< of a part's box, in squares of dx, at most
    bool copies = true;            ///< some part has more than one
};

/// Bytes an engine of a resolved kind needs without any cache, about.
std::int64_t engine_memory(EngineKind kind, const EngineNeed& need, const Workers& workers);
/// Those of them for the part asked about last, which a cache has room for, too.
std::int64_t part_memory(EngineKind kind, const EngineNeed& need);

}  // namespace spectralpack
