#pragma once
/// The laboratory: the placement search by itself (Algorithm 1; docs/conventions.md is its definition).
///
///     lab::Tray tray({.size = {100, 100, 80}, .voxel_size = 2});
///     const lab::Shape shape = tray.shape(mesh, orientation_set("90"));
///     if (const auto best = tray.best_placement(shape)) tray.add(shape, *best);
///
/// Positions q are voxels of the tray's grid; the lower corner of an orientation's voxels lies there. Millimetres are
/// from the grid's lower corner. Every engine gives the same answers.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "spectralpack/geometry.hpp"
#include "spectralpack/grid.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/orientations.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack::lab {

struct TrayOptions {
    Vec3 size{480, 245, 200};     ///< mm
    double voxel_size = 2;        ///< dx, mm
    int detail = 1;               ///< s: collisions between copies are decided on voxels of dx / s
    std::vector<double> gaps{0};  ///< distinct gaps of all shapes, ascending, mm
    EngineKind engine = EngineKind::automatic;
    int threads = 0;  ///< 0: all the machine has
};

/// A mesh's voxels in every orientation, equal ones merged. Immutable; copies of it share the voxels. Made by a tray,
/// and for trays of the same voxel size, detail and gaps.
class Shape {
  public:
    /// Distinct orientations, as indices into the set it was made from, ascending.
    const std::vector<int>& orientations() const;
    /// Voxels of dx of orientation orientations()[index], 1 = solid.
    Grid<std::uint8_t> voxels(std::size_t index) const;

  private:
    friend class Tray;
    struct Data;
    std::shared_ptr<const Data> data_;
};

/// sigma = rho + p (q_z / n_z)^3 (equations 4 to 6), or height before proximity.
struct CostOptions {
    double height_penalty = 4;  ///< p
    HeightReference height_at = HeightReference::bottom;
};

struct BestPlacement {
    int orientation = 0;         ///< index in the set that the shape was made from
    VoxelIndex position;         ///< q
    std::int64_t proximity = 0;  ///< rho(q)
    double cost = 0;             ///< sigma(q); with height at the top, the layer that the copy reaches up to
    Transform transform;         ///< from the mesh's coordinates to the tray's, mm
};

/// zeta and rho at every candidate position of one orientation, x fastest.
struct MetricFields {
    Grid<std::int64_t> collision;  ///< zeta (equation 2): 0 where the copy is free
    Grid<std::int64_t> proximity;  ///< rho (equation 4)
};

using CopyId = std::int64_t;

/// One container with what stands in it, and the engine that searches in it. Movable; for one thread at a time.
class Tray {
  public:
    /// Throws UsageError for options that make no sense or an engine that this build does not have.
    explicit Tray(const TrayOptions& options);
    Tray(Tray&&) noexcept;
    Tray& operator=(Tray&&) noexcept;
    ~Tray();

    const Extent& extent() const;  ///< n = ceil(size / dx)

    /// Voxelises `mesh`, mm, in each of the rotations and widens it for every gap. `gap`: one of the tray's. Throws
    /// InputError for a mesh that cannot be used, UsageError for another gap or no orientation.
    Shape shape(const Mesh& mesh, const std::vector<Mat3>& orientations, double gap = 0) const;

    /// The least (cost, orientation, z, y, x) over all orientations and free positions; none where there is none, or
    /// `stop` came first. Throws UsageError for a shape of another tray's options, as all below.
    std::optional<BestPlacement> best_placement(const Shape& shape, const CostOptions& cost = {},
                                                const StopToken& stop = {});

    /// Whole fields, computed as the paper does, whatever the tray's engine: slow, exact. Throws UsageError where this
    /// build has no reference engine, or for an orientation that the shape does not have.
    MetricFields metric_fields(const Shape& shape, int orientation) const;

    /// Collisions are not looked at: what is added may overlap.
    CopyId add(const Shape& shape, int orientation, const VoxelIndex& position);
    CopyId add(const Shape& shape, const BestPlacement& placement) {
        return add(shape, placement.orientation, placement.position);
    }
    /// Voxels that other copies hold stay. Throws UsageError for a copy that is not in the tray.
    void remove(CopyId copy);
    /// Voxels of dx that copies reach into, 1 = taken.
    Grid<std::uint8_t> occupied() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace spectralpack::lab
