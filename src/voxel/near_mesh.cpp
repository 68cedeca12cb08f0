#include "voxel/near_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>

#include "geometry/bvh.hpp"
#include "voxel/box_distance.hpp"
#include "voxel/centre_distances.hpp"
#include "voxel/near_triangle.hpp"
#include "voxel/surface.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kLayers = 4;  ///< that a task takes at least
// Lengths in voxels.
constexpr double kLongReach = 4;    ///< from there on distances of centres are worth their time
constexpr double kTouching = 1e-6;  ///< what a triangle only touches counts as entered by it
constexpr double kRounding = 1e-6;  ///< boxes farther off than the reach by more hold nothing near
/// How many voxels take as long as a triangle, for each square of the reach.
constexpr double kVoxelsOfTriangle = 0.375;

/// Asks for one voxel after another whether some triangle is near; one that was near the last is asked about first.
class NearTriangles {
  public:
    NearTriangles(const Bvh& surface, double reach) : surface_(surface), reach_(reach) {}

    bool near(const Vec3& centre) {
        if (last_ < surface_.triangle_count() && is_near(last_, centre)) return true;
        const std::span<const Bvh::Node> nodes = surface_.nodes();
        const Vec3 half{0.5, 0.5, 0.5};
        const Box cube{centre - half, centre + half};
        const double limit = (reach_ + kRounding) * (reach_ + kRounding);
        std::array<std::size_t, 64> waiting;  // deeper than any tree
        std::size_t count = 0;
        if (!nodes.empty() && square_distance(nodes[0].box(), cube) < limit) waiting[count++] = 0;
        while (count > 0) {
            const std::size_t at = waiting[--count];
            const Bvh::Node& node = nodes[at];
            if (node.leaf()) {
                for (std::size_t i = node.first; i < node.first + node.count; ++i) {
                    if (!is_near(i, centre)) continue;
                    last_ = i;
                    return true;
                }
                continue;
            }
            std::size_t nearer = at + 1, farther = node.first;
            double least = square_distance(nodes[nearer].box(), cube),
                   most = square_distance(nodes[farther].box(), cube);
            if (most < least) {
                std::swap(nearer, farther);
                std::swap(least, most);
            }
            if (most < limit) waiting[count++] = farther;
            if (least < limit) waiting[count++] = nearer;
        }
        return false;
    }

  private:
    bool is_near(std::size_t triangle, const Vec3& centre) const {
        return NearCubes(surface_.corners(triangle), reach_).contain(centre);
    }

    const Bvh& surface_;
    double reach_;
    std::size_t last_ = ~std::size_t{0};
};

/// Calls visit(word of the grid, its open bits, first x, y, z) where voxels are in neither grid.
template <class Visit>
void for_open_words(BitGrid& grid, const BitGrid& closed, int begin, int end, Visit visit) {
    const Extent& n = grid.extent();
    for (int z = begin; z < end; ++z) {
        for (int y = 0; y < n.y; ++y) {
            BitGrid::Word* const row = grid.row(y, z);
            const BitGrid::Word* const closed_row = closed.row(y, z);
            for (int x = 0; x < n.x; x += BitGrid::kWordBits) {
                const int word = x / BitGrid::kWordBits;
                BitGrid::Word open = ~(row[word] | closed_row[word]);
                if (n.x - x < BitGrid::kWordBits) open &= (BitGrid::Word{1} << (n.x - x)) - 1;
                if (open != 0) visit(row[word], open, x, y, z);
            }
        }
    }
}

std::int64_t count_open(BitGrid& grid, const BitGrid& closed) {
    std::int64_t count = 0;
    for_open_words(grid, closed, 0, grid.extent().z,
                   [&](BitGrid::Word&, BitGrid::Word open, int, int, int) { count += std::popcount(open); });
    return count;
}

/// Asks for each voxel that is in neither grid.
void set_near_by_voxel(BitGrid& grid, const BitGrid& far, const VoxelIndex& first, const GridMesh& mesh, double reach,
                       const Workers& workers) {
    const Bvh surface(mesh.in_grid());
    workers.for_ranges(grid.extent().z, kLayers, [&](std::int64_t begin, std::int64_t end) {
        NearTriangles triangles(surface, reach);
        for_open_words(grid, far, static_cast<int>(begin), static_cast<int>(end),
                       [&](BitGrid::Word& word, BitGrid::Word open, int x, int y, int z) {
                           workers.check();
                           for (; open != 0; open &= open - 1) {
                               const VoxelIndex at = first + VoxelIndex{x + std::countr_zero(open), y, z};
                               if (triangles.near({at.x + 0.5, at.y + 0.5, at.z + 0.5})) word |= open & -open;
                           }
                       });
    });
}

void set_near_by_triangle(BitGrid& grid, const VoxelIndex& first, const GridMesh& mesh, double reach,
                          const Workers& workers) {
    for_each_triangle(mesh, workers,
                      [&](const GridTriangle& triangle) { set_near(grid, first, triangle, reach, workers); });
}

/// By the distances between voxels' centres all but a thin layer, and that by the voxel or by the triangle, whichever
/// are fewer for what they take.
void set_near_far_around(BitGrid& grid, const VoxelIndex& first, const GridMesh& mesh, double reach,
                         const Workers& workers) {
    const Vec3 corner{1.0 * first.x, 1.0 * first.y, 1.0 * first.z};
    BitGrid entered(grid.extent());
    for_each_triangle(mesh, workers, [&](const GridTriangle& t) {
        set_surface(entered, {t[0] - corner, t[1] - corner, t[2] - corner}, -kTouching);
    });
    ToldByCentres told = told_by_centres(entered, reach, workers);
    subtract(told.far, grid, {});  // as the inside of a solid
    unite(grid, told.near, {});
    const double by_triangle = kVoxelsOfTriangle * reach * reach * static_cast<double>(mesh.size());
    if (static_cast<double>(count_open(grid, told.far)) < by_triangle) {
        set_near_by_voxel(grid, told.far, first, mesh, reach, workers);
    } else {
        unite(grid, told.far, {});  // so that no triangle asks about it
        set_near_by_triangle(grid, first, mesh, reach, workers);
        subtract(grid, told.far, {});
    }
}

}  // namespace

void set_near(BitGrid& grid, const VoxelIndex& first, const GridMesh& mesh, double reach, const Workers& workers) {
    if (reach >= kLongReach && centres_can_tell(grid.extent(), reach)) {
        set_near_far_around(grid, first, mesh, reach, workers);
    } else {
        set_near_by_triangle(grid, first, mesh, reach, workers);
    }
}

}  // namespace spectralpack
