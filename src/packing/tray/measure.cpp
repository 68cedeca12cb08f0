#include "packing/tray/measure.hpp"

#include <cmath>
#include <cstddef>

namespace spectralpack {

/// The area of a section is the sum over its segments of (p x q) / 2, each segment with the solid on its left
/// (Green's theorem).
void add_section_areas(const Mesh& mesh, double thickness, std::vector<double>& area) {
    for (const Triangle& t : mesh.triangles) {
        const Vec3 corner[3] = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
        const double low = std::min({corner[0].z, corner[1].z, corner[2].z});
        const double high = std::max({corner[0].z, corner[1].z, corner[2].z});
        const auto first = static_cast<std::ptrdiff_t>(std::max(0.0, std::ceil(low / thickness - 0.5)));
        for (std::ptrdiff_t k = first; k < static_cast<std::ptrdiff_t>(area.size()); ++k) {
            const double z = (static_cast<double>(k) + 0.5) * thickness;
            if (z > high) break;
            // Where the plane cuts the edges: once upwards (from below to z or above), once downwards.
            Vec3 up, down;
            bool cut = false;
            for (int i = 0; i < 3; ++i) {
                const Vec3& a = corner[i];
                const Vec3& b = corner[(i + 1) % 3];
                if ((a.z < z) == (b.z < z)) continue;
                const Vec3 point = a + (z - a.z) / (b.z - a.z) * (b - a);
                (a.z < z ? up : down) = point;
                cut = true;
            }
            // Seen from outside the corners run counter-clockwise, so the solid is on the left of the way
            // from where the boundary comes down to where it goes up.
            if (cut) area[static_cast<std::size_t>(k)] += (down.x * up.y - down.y * up.x) / 2;
        }
    }
}

std::vector<double> section_areas(const Mesh& mesh, double thickness) {
    const double top = bounding_box(mesh).max.z;
    std::vector<double> areas(static_cast<std::size_t>(std::max(0.0, std::ceil(top / thickness))), 0);
    add_section_areas(mesh, thickness, areas);
    return areas;
}

double reached_height(const TrayPacking& tray, const std::vector<std::shared_ptr<const Mesh>>& meshes) {
    double top = 0;
    for (const Placement& placement : tray.placements) {
        const Mesh& mesh = *meshes[static_cast<std::size_t>(placement.part)];
        top = std::max(top, bounding_box(transformed(mesh, placement.transform)).max.z);
    }
    return top;
}

void measure_tray(TrayPacking& tray, const Container& container, const std::vector<PackedPart>& parts,
                  const std::vector<std::shared_ptr<const Mesh>>& meshes, double thickness, const Workers& workers) {
    const std::size_t count = tray.placements.size();
    const auto layers = static_cast<std::size_t>(std::ceil(container.size.z / thickness - 1e-9));
    tray.layers = {thickness, std::vector<double>(layers, 0)};
    tray.bounding_box = {};

    // Copies are measured in parallel and summed in order, so that the sums do not depend on the threads.
    std::vector<Box> boxes(count);
    constexpr std::size_t kBatch = 64;
    for (std::size_t begin = 0; begin < count; begin += kBatch) {
        const std::size_t size = std::min(kBatch, count - begin);
        std::vector<std::vector<double>> areas(size, std::vector<double>(layers, 0));
        workers.for_each(static_cast<std::int64_t>(size), [&](std::int64_t i) {
            const auto k = static_cast<std::size_t>(i);
            const Placement& placement = tray.placements[begin + k];
            const Mesh placed = transformed(*meshes[static_cast<std::size_t>(placement.part)], placement.transform);
            boxes[begin + k] = bounding_box(placed);
            add_section_areas(placed, thickness, areas[k]);
        });
        for (const std::vector<double>& area : areas) {
            for (std::size_t layer = 0; layer < layers; ++layer) {
                tray.layers.area[layer] += area[layer];
            }
        }
    }
    double volume = 0;
    for (std::size_t i = 0; i < count; ++i) {
        volume += parts[static_cast<std::size_t>(tray.placements[i].part)].volume;
        tray.bounding_box.add(boxes[i]);
    }
    tray.density = volume / volume_of(container);
    const double box_volume = tray.bounding_box.volume();
    tray.density_bounding_box = box_volume > 0 ? volume / box_volume : 0;
    tray.height = count > 0 ? tray.bounding_box.max.z : 0;
}

}  // namespace spectralpack
