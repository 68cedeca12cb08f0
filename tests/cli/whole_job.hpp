#pragma once
/// Whole jobs on the built program: a cube of 10 mm and a slab of 40 x 40 x 10 mm, and containers to fill.

#include <fstream>

#include "cli/program.hpp"
#include "formats/packing_file.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {

class WholeJob : public testing::Test {
  protected:
    WholeJob() {
        stl("cube.stl", cube_mesh(10));
        stl("slab.stl", box_mesh({0, 0, 0}, {40, 40, 10}));
    }

    void stl(const std::string& name, const Mesh& mesh) { write_stl(mesh, folder_ / name); }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    /// Packs into build.json at 2 mm without gaps.
    Ran pack(const std::vector<std::string>& arguments) {
        return spectralpack(std::vector<std::string>{"pack"} + arguments +
                            std::vector<std::string>{"--gap", "0", "--threads", "1", "-o", at("build.json")});
    }

    nlohmann::json build() const { return read_json(folder_ / "build.json"); }

    void expect_sound() {
        const Ran checked = spectralpack({"check", at("build.json")});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    }

    /// The check of build.json, once `changed` is written into it, has one finding.
    nlohmann::json finding_of(const nlohmann::json& changed) {
        std::ofstream(at("build.json")) << changed;
        const nlohmann::json findings = check_report(at("build.json"), 1)["findings"];
        EXPECT_EQ(findings.size(), 1u) << findings;
        return findings[0];
    }

    TemporaryFolder folder_;
};

/// An L of 40 x 40 x 20 mm with arms of 20 mm.
inline Mesh angle_mesh() {
    Mesh mesh;
    const Vec3 corners[] = {{0, 0, 0}, {40, 0, 0}, {40, 20, 0}, {20, 20, 0}, {20, 40, 0}, {0, 40, 0}};
    for (const double z : {0.0, 20.0}) {
        for (const Vec3& corner : corners) {
            mesh.vertices.push_back({corner.x, corner.y, z});
        }
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t j = (i + 1) % 6;
        mesh.triangles.push_back({i, j, j + 6});
        mesh.triangles.push_back({i, j + 6, i + 6});
    }
    const Triangle faces[] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    for (const Triangle& f : faces) {
        mesh.triangles.push_back({f[0], f[2], f[1]});
        mesh.triangles.push_back({f[0] + 6, f[1] + 6, f[2] + 6});
    }
    return mesh;
}

/// A bottle's inside: 40 x 20 mm and 20 high, then a neck of 16 x 20 mm up to 40.
inline Mesh bottle_mesh() {
    const struct {
        double x, z;
    } corners[] = {{0, 0}, {40, 0}, {40, 20}, {28, 20}, {28, 40}, {12, 40}, {12, 20}, {0, 20}};
    const Triangle faces[] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 6}, {0, 6, 7}, {6, 3, 4}, {6, 4, 5}};  // seen from -y
    Mesh mesh;
    for (const double y : {0.0, 20.0}) {
        for (const auto& corner : corners) {
            mesh.vertices.push_back({corner.x, y, corner.z});
        }
    }
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::uint32_t j = (i + 1) % 8;
        mesh.triangles.push_back({i, j + 8, j});
        mesh.triangles.push_back({i, i + 8, j + 8});
    }
    for (const Triangle& f : faces) {
        mesh.triangles.push_back(f);
        mesh.triangles.push_back({f[0] + 8, f[2] + 8, f[1] + 8});
    }
    return mesh;
}

}  // namespace spectralpack::test
