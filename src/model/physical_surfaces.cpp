#include "model/physical_surfaces.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

constexpr double kInPlane = 1e-4;  // mm; mesh files have single precision

Mesh container_surface(const Container& container) {
    return container.mesh ? *container.mesh->surface : box_surface({{}, container.size});
}

bool in_top(const Mesh& mesh, const Triangle& triangle, double top) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](std::uint32_t vertex) { return mesh.vertices[vertex].z >= top - kInPlane; });
}

}  // namespace

Mesh surface_of(const KeepOut& keep_out) { return keep_out.mesh ? *keep_out.mesh->surface : box_surface(keep_out.box); }

std::vector<Mesh> physical_surfaces(const Container& container) {
    Mesh walls = container_surface(container);
    std::erase_if(walls.triangles, [&](const Triangle& t) { return in_top(walls, t, container.size.z); });
    std::vector<Mesh> surfaces{inside_out(std::move(walls))};  // the room is outside of what stands in the way
    for (const KeepOut& keep_out : container.keep_out) {
        surfaces.push_back(surface_of(keep_out));
    }
    return surfaces;
}

bool opens_at_top(const Container& container) {
    const Mesh mesh = container_surface(container);
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                       [&](const Triangle& t) { return in_top(mesh, t, container.size.z); });
}

}  // namespace spectralpack
