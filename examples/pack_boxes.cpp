// Packs boxes that are made here, in memory, and prints where they stand: no file is read or written.
#include <cstdio>
#include <exception>

#include "spectralpack/mesh.hpp"
#include "spectralpack/pack.hpp"

namespace sp = spectralpack;

namespace {

sp::Mesh box(double x, double y, double z) { return sp::box_surface({{0, 0, 0}, {x, y, z}}); }

// Told of every copy as it is placed; it may still be moved or taken out after that.
class Narrator : public sp::Listener {
  public:
    void on_event(const sp::Event& event) override {
        if (event.kind == sp::EventKind::copy_placed) std::printf("placed a copy of part %d\n", event.part);
    }
};

void pack_boxes() {
    sp::Job job;
    job.parts.push_back({.name = "brick", .mesh = box(40, 20, 10), .count = 12});
    job.parts.push_back({.name = "cube", .mesh = box(15, 15, 15), .count = 6, .gap = 2.0});
    job.options.tray = {100, 80, 60};  // mm, like all lengths
    job.options.voxel = 1;
    job.options.gap = 1;

    Narrator narrator;
    const sp::PackResult result = sp::pack(job, {.listener = &narrator});

    for (const sp::TrayPacking& tray : result.packing.trays) {
        for (const sp::Placement& placement : tray.placements) {
            const sp::PackedPart& part = result.packing.parts[static_cast<std::size_t>(placement.part)];
            const sp::Mesh& mesh = *result.meshes[static_cast<std::size_t>(placement.part)];
            const sp::Box stands = sp::bounding_box(sp::transformed(mesh, placement.transform));
            std::printf("%s %d: from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f)\n", part.name.c_str(), placement.copy,
                        stands.min.x, stands.min.y, stands.min.z, stands.max.x, stands.max.y, stands.max.z);
        }
        std::printf("%zu boxes fill %.1f %% of the tray\n", tray.placements.size(), 100 * tray.density);
    }
    std::printf("%zu found no place\n", result.packing.unplaced.size());
}

}  // namespace

int main() {
    try {
        pack_boxes();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
