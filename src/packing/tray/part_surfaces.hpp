#pragma once
/// The meshes of a job's parts as they are packed, and their surfaces in the orientations in use: refinement slides
/// them, disassembly sweeps them.

#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "geometry/bvh.hpp"
#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// The scaled mesh (mm, not turned) of a part, and what else packing needs of it.
struct ScaledPart {
    std::shared_ptr<const Mesh> mesh;
    double gap = 0;
    const std::vector<Mat3>* orientations = nullptr;  ///< its set
    double volume = 0;                                ///< signed, mm^3
};

/// A part in an orientation of its set.
struct TurnedPart {
    int part = 0;
    int orientation = 0;

    auto operator<=>(const TurnedPart&) const = default;
};

class PartSurfaces {
  public:
    using PartOf = std::function<ScaledPart(int part)>;

    /// `part_of` is called from several threads.
    PartSurfaces(PartOf part_of, const Workers& workers) : part_of_(std::move(part_of)), workers_(workers) {}

    ScaledPart part(int part) const { return part_of_(part); }
    Mesh turned_mesh(int part, int orientation) const;

    /// Of the turned mesh. Made when first asked for, then kept. Throws Stopped once `stop` is requested.
    std::shared_ptr<const Bvh> at(int part, int orientation, const StopToken& stop = {});
    /// Makes what is missing of `wanted`, in parallel by part.
    void make(const std::vector<TurnedPart>& wanted);

  private:
    PartOf part_of_;
    Workers workers_;
    int part_ = -1;  // whose surface the next one is: copies of a part mostly come one after the other
    std::unique_ptr<const Bvh> plain_;
    std::map<TurnedPart, std::shared_ptr<const Bvh>> made_;
};

}  // namespace spectralpack
