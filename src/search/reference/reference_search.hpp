#pragma once
/// The paper's placement search written plainly (section 3.1, appendix A.1, Algorithm 1): phi by
/// the full Manhattan distance field, zeta and rho as circular correlations by Fourier transforms
/// of the full tray. It is what every other engine is tested and timed against.

#include <cstdint>
#include <memory>

#include "search/metric_fields.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

struct ReferenceOptions {
    /// For timing only: answers may be wrong (zeta and rho are not exact, and nothing says so).
    bool single_precision = false;
    /// Lets FFTW time its ways of transforming a tray first: seconds at the start, faster
    /// afterwards.
    bool measure = false;
    /// Orientations at work at once, each with two transforms' memory; 0: as many as there are
    /// workers.
    int lanes = 0;
};

class ReferenceSearch : public PlacementSearch {
  public:
    /// Whole fields (equations 2 and 4) of orientation `index` of the shape. Throws as best_placement() does.
    virtual MetricFields metric_fields(const Tray& tray, const Shape& shape, int index) = 0;
};

/// Per orientation one forward and two inverse transforms; one more forward for each distinct A+g,
/// g > 0, that some object asks for. A transform has the tray's extent plus the overhang of A+g, so
/// that nothing wraps onto the tray, rounded up to transform_extent(). Exact: zeta and rho
/// are rounded to integers. Throws ResourceError for trays so large that double precision cannot
/// tell them apart (correlation_error_bound() reaches 0.5), and where there is no memory. Results
/// do not depend on the number of workers or lanes. What is kept of a tray is for the last one
/// only.
std::unique_ptr<ReferenceSearch> make_reference_search(const ReferenceOptions& options, const Workers& workers);

/// What decides the memory of a reference engine.
struct ReferenceMemory {
    Extent tray;
    VoxelIndex overhang;  ///< voxels by which an A+g reaches beyond A on a side, at most
    int gap_classes = 1;
    bool blocked = false;  ///< the tray has a container mask or keep-out
    int lanes = 1;
    bool single_precision = false;
};

/// Bytes that best_placement() holds at most: the peak of memory() without free_positions().
std::int64_t reference_memory(const ReferenceMemory& need);

/// Bytes more while free_positions() answers for an object of `object` voxels in a tray of `tray`
/// voxels.
std::int64_t reference_free_memory(const Extent& tray, const Extent& object, bool single_precision);

}  // namespace spectralpack
