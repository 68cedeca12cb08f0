#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "api/engine_factory.hpp"
#include "core/parallel.hpp"
#include "formats/mesh_reader.hpp"
#include "geometry/bvh.hpp"
#include "geometry/mesh_distance.hpp"
#include "packing/tray/placed_copy.hpp"
#include "search/placement_search.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/lab/distance.hpp"
#include "spectralpack/lab/search.hpp"
#include "spectralpack/lab/voxels.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack::lab {
namespace {

/// As it would be packed; what was mended is not told.
Mesh usable(const Mesh& mesh) { return adopt_mesh(mesh, "the mesh", 1).mesh; }

Grid<std::uint8_t> bytes_of(const BitGrid& bits) {
    const Extent& extent = bits.extent();
    Grid<std::uint8_t> bytes(extent);
    for (int z = 0; z < extent.z; ++z) {
        for (int y = 0; y < extent.y; ++y) {
            for (int x = 0; x < extent.x; ++x) {
                bytes.at(x, y, z) = bits.get(x, y, z) ? 1 : 0;
            }
        }
    }
    return bytes;
}

void require_voxel_size(double size) {
    if (!(size > 0) || !std::isfinite(size)) throw UsageError("the voxel size must be a positive number");
}

struct VoxelisedMesh {
    BitGrid solid;
    Vec3 corner;
};

VoxelisedMesh voxelised(const Mesh& mesh, double voxel_size, int threads) {
    require_voxel_size(voxel_size);
    const Mesh sound = usable(mesh);
    const Box box = bounding_box(sound);
    return {spectralpack::voxelize(sound, voxel_size, Workers(threads)), box.min - inset(box.size(), voxel_size)};
}

}  // namespace

Voxels voxelize(const Mesh& mesh, double voxel_size, int threads) {
    const VoxelisedMesh made = voxelised(mesh, voxel_size, threads);
    return {bytes_of(made.solid), voxel_size, made.corner};
}

VoxelBits voxelize_bits(const Mesh& mesh, double voxel_size, int threads) {
    VoxelisedMesh made = voxelised(mesh, voxel_size, threads);
    return {made.solid.extent(), made.solid.words_per_row(), std::move(made.solid.words()), voxel_size, made.corner};
}

Distance distance(const Mesh& a, const Transform& pose_a, const Mesh& b, const Transform& pose_b) {
    for (const Mesh* mesh : {&a, &b}) {
        if (mesh->triangles.empty()) throw InputError("a mesh", "", "has no triangles: it has no distance");
    }
    const ClosestPoints closest = least_distance(Bvh(transformed(a, pose_a)), {}, Bvh(transformed(b, pose_b)), {});
    return {closest.distance, closest.a, closest.b};
}

struct Shape::Data {
    spectralpack::Shape shape;
    std::vector<Mat3> rotations;
    std::vector<int> orientations;  // distinct ones, ascending
    double voxel_size;
    int detail;
    std::vector<double> gaps;
};

const std::vector<int>& Shape::orientations() const { return data_->orientations; }

Grid<std::uint8_t> Shape::voxels(std::size_t index) const {
    return bytes_of(*data_->shape.orientations.at(index).solid);
}

struct Tray::Impl {
    TrayOptions options;
    Workers workers;
    spectralpack::Tray tray;
    std::unique_ptr<PlacementSearch> engine;

    explicit Impl(const TrayOptions& o)
        : options(o),
          workers(o.threads),
          tray(setup_of(o)),
          engine(make_engine(resolve_engine(o.engine), 0, workers)) {}

    static TraySetup setup_of(const TrayOptions& options) {
        require_voxel_size(options.voxel_size);
        if (options.detail < 1) throw UsageError("the detail must be 1 or more");
        const bool ascending =
            std::ranges::adjacent_find(options.gaps, std::ranges::greater_equal{}) == options.gaps.end();
        if (options.gaps.empty() || !ascending || !(options.gaps.front() >= 0)) {
            throw UsageError("the gaps of a tray are one or more distances, ascending");
        }
        TraySetup setup;
        setup.size = options.size;
        setup.voxel_size = options.voxel_size;
        setup.detail = options.detail;
        setup.gap_classes = options.gaps;
        return setup;
    }

    const Shape::Data& checked(const Shape::Data* data) const {
        if (!data || data->voxel_size != options.voxel_size || data->detail != options.detail ||
            data->gaps != options.gaps) {
            throw UsageError("the shape was made for a tray of other voxels or gaps");
        }
        return *data;
    }

    /// Where the shape keeps the voxels of an orientation of the set.
    static int index_of(const Shape::Data& data, int orientation) {
        const auto found = std::ranges::find(data.orientations, orientation);
        if (found == data.orientations.end()) {
            throw UsageError("orientation " + std::to_string(orientation) + " is not among the shape's distinct ones");
        }
        return static_cast<int>(found - data.orientations.begin());
    }
};

Tray::Tray(const TrayOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Tray::Tray(Tray&&) noexcept = default;
Tray& Tray::operator=(Tray&&) noexcept = default;
Tray::~Tray() = default;

const Extent& Tray::extent() const { return impl_->tray.extent(); }

Shape Tray::shape(const Mesh& mesh, const std::vector<Mat3>& orientations, double gap) const {
    const TrayOptions& options = impl_->options;
    if (orientations.empty()) throw UsageError("a shape needs an orientation");
    if (std::ranges::find(options.gaps, gap) == options.gaps.end()) {
        throw UsageError("the shape's gap is not among the tray's");
    }
    for (const Mat3& matrix : orientations) {
        if (!as_rotation(matrix)) throw UsageError("an orientation is not a rotation");
    }
    // Engines know shapes by their numbers; those of one process never repeat.
    static std::atomic<std::uint64_t> made{0};
    auto data = std::make_shared<Shape::Data>();
    data->shape = make_shape(++made, usable(mesh), orientations, options.voxel_size, options.detail, gap, options.gaps,
                             impl_->workers);
    data->rotations = orientations;
    for (const OrientedShape& oriented : data->shape.orientations) {
        data->orientations.push_back(oriented.orientation);
    }
    data->voxel_size = options.voxel_size;
    data->detail = options.detail;
    data->gaps = options.gaps;
    Shape shape;
    shape.data_ = std::move(data);
    return shape;
}

std::optional<BestPlacement> Tray::best_placement(const Shape& shape, const CostOptions& cost, const StopToken& stop) {
    const Shape::Data& data = impl_->checked(shape.data_.get());
    const CostModel model{cost.height_penalty,
                          cost.height_at == HeightReference::top ? HeightAt::top : HeightAt::bottom};
    const SearchResult result = impl_->engine->best_placement(impl_->tray, data.shape, model, stop);
    if (!result.best || result.stopped) return std::nullopt;
    const spectralpack::BestPlacement& best = *result.best;
    const OrientedShape& oriented = data.shape.orientations[static_cast<std::size_t>(best.index)];
    const Vec3 corner =
        data.voxel_size * Vec3{static_cast<double>(best.position.x), static_cast<double>(best.position.y),
                               static_cast<double>(best.position.z)};
    return BestPlacement{
        oriented.orientation, best.position, best.proximity, best.cost.primary,
        Transform{data.rotations[static_cast<std::size_t>(oriented.orientation)], corner - oriented.corner}};
}

MetricFields Tray::metric_fields(const Shape& shape, int orientation) const {
    const Shape::Data& data = impl_->checked(shape.data_.get());
    auto [collision, proximity] =
        reference_fields(impl_->tray, data.shape, Impl::index_of(data, orientation), impl_->workers);
    return {std::move(collision), std::move(proximity)};
}

CopyId Tray::add(const Shape& shape, int orientation, const VoxelIndex& position) {
    const Shape::Data& data = impl_->checked(shape.data_.get());
    const spectralpack::BestPlacement at{Impl::index_of(data, orientation), position, 0, {}, {}};
    return impl_->tray.add(settle_on_grid(data.shape, at, data.voxel_size, data.detail, 0).object);
}

void Tray::remove(CopyId copy) {
    if (!impl_->tray.find(copy)) throw UsageError("copy " + std::to_string(copy) + " is not in the tray");
    impl_->tray.remove(copy);
}

Grid<std::uint8_t> Tray::occupied() const { return bytes_of(impl_->tray.omega_move()); }

}  // namespace spectralpack::lab
