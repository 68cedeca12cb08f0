#include "children/mesh_record.hpp"

#include <bit>
#include <cmath>
#include <ostream>

namespace spectralpack::server {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

constexpr double kSteps = 65535;

template <class Value>
void put(std::ostream& out, Value value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

}  // namespace

void write_mesh_record(std::ostream& out, std::uint32_t id, const Mesh& mesh) {
    const Box box = bounding_box(mesh);
    const Vec3 step = (1 / kSteps) * box.size();
    put(out, id);
    put(out, static_cast<std::uint32_t>(mesh.vertices.size()));
    put(out, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Vec3& vector : {box.min, step}) {
        for (int axis = 0; axis < 3; ++axis) {
            put(out, static_cast<float>(vector[axis]));
        }
    }
    for (const Vec3& vertex : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = step[axis] > 0 ? (vertex[axis] - box.min[axis]) / step[axis] : 0;
            put(out, static_cast<std::uint16_t>(std::lround(std::fmin(std::fmax(steps, 0), kSteps))));
        }
    }
    if (mesh.vertices.size() % 2 == 1) put(out, std::uint16_t{0});
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            put(out, vertex);
        }
    }
}

}  // namespace spectralpack::server
