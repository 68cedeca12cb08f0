#include "spectralpack/tools/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/mesh_edges.hpp"
#include "geometry/mesh_repair.hpp"
#include "spectralpack/tools/simplify.hpp"

namespace spectralpack::tools {
namespace {

constexpr double kSurfaceError = 0.01;  ///< of the longest side
constexpr double kBoxChange = 0.02;     ///< of the longest side
constexpr double kVolumeChange = 0.03;

double longest_side(const Box& box) {
    const Vec3 size = box.size();
    return std::max({size.x, size.y, size.z});
}

std::string counted_edges(std::size_t count, const char* what) {
    return std::to_string(count) + (count == 1 ? " edge " : " edges ") + what;
}

/// Why a mesh is not kept; none where it is.
struct Fault {
    Prepared outcome;
    std::string detail;
};

std::optional<Fault> fault_of(const Mesh& mesh) {
    const EdgeCount edges = count_edges(MeshEdges(mesh));
    if (edges.crowded > 0) {
        return Fault{Prepared::non_manifold, counted_edges(edges.crowded, "of more than two facets")};
    }
    if (edges.border > 0) return Fault{Prepared::open, counted_edges(edges.border, "of one facet")};
    if (edges.misdirected > 0) {
        return Fault{Prepared::inconsistent, counted_edges(edges.misdirected, "whose facets face opposite ways")};
    }
    if (!(signed_volume(mesh) > 0)) return Fault{Prepared::no_volume, "its signed volume is not positive"};
    return std::nullopt;
}

bool like(const Mesh& simple, const Mesh& original) {
    if (simple.triangles.empty() || fault_of(simple)) return false;
    const Box was = bounding_box(original), is = bounding_box(simple);
    const double margin = kBoxChange * longest_side(was);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(is.min[axis] - was.min[axis]) > margin) return false;
        if (std::abs(is.max[axis] - was.max[axis]) > margin) return false;
    }
    const double volume = signed_volume(original);
    return std::abs(signed_volume(simple) - volume) <= kVolumeChange * volume;
}

/// The mesh with the fewest triangles that is still like the original.
Mesh simplified_like(const Mesh& mesh, std::size_t triangles) {
    for (std::size_t target = triangles; target < mesh.triangles.size(); target += target / 4 + 1) {
        Mesh simple = simplified(mesh, target, kSurfaceError);
        const MeshRepair repair = repair_mesh(simple, true);
        if (!repair.unusable && simple.triangles.size() < mesh.triangles.size() && like(simple, mesh)) return simple;
    }
    return mesh;
}

double scale_of(const Vec3& size, const PrepareRules& rules) {
    const double down = std::min({rules.tray.x / size.x, rules.tray.y / size.y, rules.tray.z / size.z});
    if (down < 1) return down;
    const double up = rules.least_side / std::max({size.x, size.y, size.z});
    return up > 1 ? std::min(up, down) : 1;
}

}  // namespace

PreparedMesh prepare_mesh(const Mesh& mesh, const PrepareRules& rules) {
    PreparedMesh prepared;
    if (std::optional<Fault> fault = fault_of(mesh)) {
        prepared.outcome = fault->outcome;
        prepared.detail = std::move(fault->detail);
        return prepared;
    }
    prepared.mesh = simplified_like(mesh, rules.triangles);
    if (prepared.mesh.triangles.size() > rules.triangles) {
        prepared.detail = prepared.mesh.triangles.size() < mesh.triangles.size() ? "simplified less than asked for"
                                                                                 : "could not be simplified";
    }
    prepared.scale = scale_of(bounding_box(prepared.mesh).size(), rules);
    prepared.mesh = transformed(prepared.mesh, {prepared.scale * Mat3{}, {}});
    prepared.mesh = transformed(prepared.mesh, {Mat3{}, -bounding_box(prepared.mesh).min});
    return prepared;
}

}  // namespace spectralpack::tools
