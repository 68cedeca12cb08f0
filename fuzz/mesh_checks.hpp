#pragma once
/// What must hold of every mesh that a reader lets through. A failure ends the program, which is
/// what a fuzzer sees.

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "formats/mesh_parsers.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/mesh_repair.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {

inline void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

inline void check_meshes(std::vector<ParsedMesh> meshes) {
    expect(!meshes.empty(), "a file that is read has a mesh");
    for (ParsedMesh& parsed : meshes) {
        Mesh& mesh = parsed.loaded.mesh;
        for (const Triangle& triangle : mesh.triangles) {
            for (const std::uint32_t corner : triangle) {
                expect(corner < mesh.vertices.size(), "indices are in range");
            }
        }
        const MeshRepair outcome = repair_mesh(mesh, parsed.welded);
        if (outcome.unusable) continue;
        expect(outcome.closed == is_closed(mesh), "closed means closed");
        expect(outcome.closed || !outcome.warnings.empty(), "an open mesh is told");
        expect(outcome.box == bounding_box(mesh), "the box is the mesh's");
        expect(std::isfinite(signed_volume(mesh)), "the volume is finite");
        expect(signed_volume(mesh) >= 0, "the volume is not negative");
    }
}

}  // namespace spectralpack
