#pragma once
/// Continuous placement refinement (section 3.2): a copy placed on the grid slides towards its
/// neighbours until their true meshes are the gap apart. Millimetres in the container's
/// coordinates, its lower corner the origin.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "geometry/box_index.hpp"
#include "geometry/bvh.hpp"
#include "search/cost.hpp"

namespace spectralpack {

struct RefineOptions {
    Vec3 container;  ///< size of the box, z infinite where there is no ceiling; what else bounds it is added as walls
    double wall_gap = 0;      ///< least distance of a mesh's box to the container's sides
    double longest_move = 4;  ///< along one axis in one round: 2 dx in the paper
    int rounds = 3;           ///< of x, y, z each
};

/// A mesh where it stands: its surface, turned and scaled to millimetres, moved by `offset`.
struct PlacedSurface {
    std::shared_ptr<const Bvh> surface;
    Vec3 offset;
    double gap = 0;     ///< two copies keep the larger of their gaps
    bool wall = false;  ///< a wall or keep-out: who comes near keeps this gap, not its own

    Box box() const { return {surface->box().min + offset, surface->box().max + offset}; }
};

/// The way down the cost along x, y and z (-1, 0, +1): minus the sign of
/// sigma(q + e) - sigma(q - e). `neighbours` as in BestPlacement: q - ex, q + ex, q - ey, ...
std::array<int, 3> descent(const std::array<Cost, 6>& neighbours);

struct Refined {
    Vec3 offset;           ///< where the copy goes
    double way = 0;        ///< length of the path there, mm; 0: it stays
    double shortfall = 0;  ///< mm missing to the gap from some copy, as it was to begin with
};

/// The copies that stand in one tray.
class Refiner {
  public:
    using CopyId = std::int64_t;

    /// Throws UsageError for a wall gap that is negative, not a number or leaves no room;
    /// InternalError for other values that make no sense.
    explicit Refiner(const RefineOptions& options);

    /// Throws UsageError for a gap that is negative or not finite.
    CopyId add(PlacedSurface copy);
    /// Throws InternalError where `id` does not stand here.
    void remove(CopyId id);
    const PlacedSurface* find(CopyId id) const;  ///< null when removed or never added

    /// Moves `copy`, which must not have been added yet, in options.rounds rounds along x, y, z as
    /// `direction` says (that of the voxel it was placed at, in every round, as in the paper), each
    /// time until the first contact, the wall or longest_move. The path is free throughout: at
    /// every moment the copy keeps from each other copy
    ///     min(the larger of the two gaps, their distance at the start) - 1e-9 mm,
    /// and where that gap is 0 surfaces do not cross (geometry/slide.hpp). Contact is between gap
    /// and gap + 1e-6. A copy that starts a little too near to others (up to 2e-4 dx, because
    /// voxels are drawn in, see docs/conventions.md) is first moved away by that much where there
    /// is room; else `shortfall` tells. One that starts crossing another does not move.
    /// Deterministic; may be called from several threads at once. Time grows with the triangles
    /// near to the copy, not with the tray.
    Refined refine(const PlacedSurface& copy, const std::array<int, 3>& direction,
                   const Workers& workers = Workers(1)) const;

    /// Least distance of the surface of `copy` to those of the others (walls and `except` left out), if it is
    /// below `upper_bound`; else upper_bound.
    double clearance(const PlacedSurface& copy, double upper_bound, std::optional<CopyId> except = std::nullopt) const;
    /// Least distance between the surfaces of two copies that stand here, walls left out; none with fewer than two.
    std::optional<double> least_gap(const Workers& workers = Workers(1)) const;

  private:
    /// clearance() to those copies that `counts(id)` is true of.
    template <class Counts>
    double clearance_to(const PlacedSurface& copy, double upper_bound, const Counts& counts) const;

    RefineOptions options_;
    std::vector<std::optional<PlacedSurface>> copies_;  // by id
    BoxIndex index_;
    double largest_gap_ = 0;  // of all copies ever added
};

}  // namespace spectralpack
