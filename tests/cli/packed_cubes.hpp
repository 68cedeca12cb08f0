#pragma once
/// A packing file of three cubes of 10 mm in a row, written by hand, so that faults can be planted.

#include "cli/program.hpp"
#include "core/parallel.hpp"
#include "formats/packing_file.hpp"
#include "packing/tray/measure.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {

class PackedCubes : public testing::Test {
  protected:
    PackedCubes() {
        mesh_ = std::make_shared<const Mesh>(cube_mesh(10));
        Packing cubes;
        cubes.container.size = {100, 100, 100};
        cubes.trays.resize(1);
        cubes.parts.resize(1);
        cubes.trays[0].placements = {{0, 0, 0, false, {Mat3{}, {0, 0, 0}}}};
        write_stl(cubes, {mesh_}, folder_ / "cube.stl");

        packing_.container.size = {100, 50, 40};
        packing_.options.tray = packing_.container.size;
        packing_.options.gap = 0;
        PackedPart part;
        part.name = "cube";
        part.mesh = (folder_ / "cube.stl").string();
        part.count = 3;
        part.volume = 1000;
        packing_.parts = {part};
        packing_.trays.resize(1);
        for (int copy = 0; copy < 3; ++copy) {
            packing_.trays[0].placements.push_back({0, copy, 0, false, {Mat3{}, {10.0 * copy, 0, 0}}});
        }
        packing_.metrics.copies = packing_.metrics.placed = 3;
    }

    /// States the figures as the placements have them.
    void measure() {
        measure_tray(packing_.trays[0], packing_.container, packing_.parts, {mesh_}, 2, Workers(1));
        packing_.metrics.density = packing_.trays[0].density;
    }

    void write() { write_packing(packing_, file()); }

    std::string file() const { return (folder_ / "b.json").string(); }

    Transform& transform(std::size_t copy) { return packing_.trays[0].placements[copy].transform; }
    std::optional<Disassembly>& plan() { return packing_.trays[0].disassembly; }

    TemporaryFolder folder_;
    std::shared_ptr<const Mesh> mesh_;
    Packing packing_;
};

}  // namespace spectralpack::test
