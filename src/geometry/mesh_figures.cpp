#include "spectralpack/mesh_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/mesh_edges.hpp"
#include "geometry/mesh_shells.hpp"
#include "geometry/triangle_crossing.hpp"

namespace spectralpack {
namespace {

/// Of the longest side, and of the largest coordinate in single precision files: triangles that
/// reach into one another by less do so by rounding.
constexpr double kRelativeTolerance = 1e-6, kCoordinateTolerance = 0x1p-22;

double crossing_tolerance(const Box& box) {
    double side = 0, coordinate = 0;
    for (int axis = 0; axis < 3; ++axis) {
        side = std::max(side, box.size()[axis]);
        coordinate = std::max({coordinate, std::abs(box.min[axis]), std::abs(box.max[axis])});
    }
    return std::max(kRelativeTolerance * side, kCoordinateTolerance * coordinate);
}

using VertexPair = std::array<std::uint32_t, 2>;

/// Splits border edges into rings. Every vertex has an even number of them, so a walk along unused
/// ones can only end where it began; a ring is cut off wherever it comes back to its own path.
class BorderWalk {
  public:
    BorderWalk(const Mesh& mesh, const std::vector<VertexPair>& edges)
        : mesh_(mesh),
          edges_(edges),
          first_end_(mesh.vertices.size() + 1),
          place_on_path_(mesh.vertices.size()),
          used_(edges.size()) {
        for (const VertexPair& edge : edges_) {
            ++first_end_[edge[0]];
            ++first_end_[edge[1]];
        }
        std::uint32_t total = 0;
        for (std::uint32_t& end : first_end_) {
            total += end;
            end = total;
        }
        ends_.resize(total);
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            ends_[--first_end_[edges_[i][0]]] = i;
            ends_[--first_end_[edges_[i][1]]] = i;
        }
        next_end_ = first_end_;
    }

    std::vector<BorderLoop> loops() {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (!used_[i]) walk(edges_[i][0]);
        }
        return std::move(loops_);
    }

  private:
    void walk(std::uint32_t start) {
        path_.assign(1, start);
        place_on_path_[start] = 1;
        while (const auto edge = unused_edge(path_.back())) {
            used_[*edge] = true;
            const VertexPair& ends = edges_[*edge];
            const std::uint32_t there = ends[0] == path_.back() ? ends[1] : ends[0];
            if (place_on_path_[there] > 0) {
                cut_ring(there);
            } else {
                path_.push_back(there);
                place_on_path_[there] = path_.size();
            }
        }
        place_on_path_[start] = 0;
    }

    std::optional<std::uint32_t> unused_edge(std::uint32_t vertex) {
        for (std::uint32_t& next = next_end_[vertex]; next < first_end_[vertex + 1]; ++next) {
            if (!used_[ends_[next]]) return ends_[next];
        }
        return std::nullopt;
    }

    /// The path from `vertex` to its end closes to a ring; it goes on from `vertex`.
    void cut_ring(std::uint32_t vertex) {
        BorderLoop loop{mesh_.vertices[vertex], 0, 0};
        for (std::uint32_t from = vertex, to;; from = to) {
            to = path_.back();
            loop.length += length(mesh_.vertices[from] - mesh_.vertices[to]);
            ++loop.edges;
            if (to == vertex) break;
            place_on_path_[to] = 0;
            path_.pop_back();
        }
        loops_.push_back(loop);
    }

    const Mesh& mesh_;
    const std::vector<VertexPair>& edges_;
    std::vector<std::uint32_t> first_end_, next_end_;  ///< by vertex: into ends_
    std::vector<std::uint32_t> ends_;                  ///< edges at each vertex
    std::vector<std::size_t> place_on_path_;           ///< by vertex: 1, 2, ...; 0: not on it
    std::vector<bool> used_;
    std::vector<std::uint32_t> path_;
    std::vector<BorderLoop> loops_;
};

void find_holes(const Mesh& mesh, const MeshEdges& edges, MeshFigures& figures) {
    std::vector<VertexPair> border;
    edges.for_each([&](std::uint32_t low, std::span<const MeshEdges::Use> uses) {
        if (uses.size() % 2 != 0) border.push_back({low, uses.front().high});
    });
    figures.holes = BorderWalk(mesh, border).loops();
    figures.border_loops = figures.holes.size();
    const std::size_t listed = std::min(figures.holes.size(), MeshFigures::kMostListed);
    std::stable_sort(figures.holes.begin(), figures.holes.end(),
                     [](const auto& a, const auto& b) { return a.length > b.length; });
    figures.holes.resize(listed);
}

void find_places(const Mesh& mesh, const MeshEdges& edges, MeshFigures& figures) {
    edges.for_each([&](std::uint32_t low, std::span<const MeshEdges::Use> uses) {
        const Vec3 middle = 0.5 * (mesh.vertices[low] + mesh.vertices[uses.front().high]);
        if (uses.size() > 2 && !figures.crowded_place) figures.crowded_place = middle;
        if (uses.size() == 2 && uses[0].forward() == uses[1].forward() && !figures.misdirected_place) {
            figures.misdirected_place = middle;
        }
    });
}

std::size_t count_duplicates(const Mesh& mesh) {
    std::vector<Triangle> sorted = mesh.triangles;
    for (Triangle& t : sorted) {
        std::sort(t.begin(), t.end());
    }
    std::sort(sorted.begin(), sorted.end());
    std::size_t duplicates = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        duplicates += sorted[i] == sorted[i - 1] ? 1 : 0;
    }
    return duplicates;
}

}  // namespace

MeshFigures inspect_mesh(const Mesh& mesh) {
    MeshFigures figures;
    figures.box = bounding_box(mesh);
    figures.volume = signed_volume(mesh);
    figures.area = surface_area(mesh);
    figures.triangles = mesh.triangles.size();
    figures.vertices = mesh.vertices.size();
    if (mesh.triangles.empty()) return figures;
    const MeshEdges edges(mesh);
    figures.edges = count_edges(edges);
    figures.shells = shell_groups(mesh, edges).shells.size();
    if (figures.edges.border > 0) find_holes(mesh, edges, figures);
    if (figures.edges.crowded > 0 || figures.edges.misdirected > 0) {
        find_places(mesh, edges, figures);
    }
    figures.duplicates = count_duplicates(mesh);
    figures.crossings = self_crossings(mesh, crossing_tolerance(figures.box));
    return figures;
}

}  // namespace spectralpack
