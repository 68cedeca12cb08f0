#pragma once
/// Packings built by hand, and what the judge finds in them.

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.hpp"
#include "support/names.hpp"
#include "verify/check.hpp"

namespace spectralpack::test {

/// A packing built by hand whose figures are stated as its meshes have them.
class PackedByHand : public testing::Test {
  protected:
    PackedByHand() {
        packing_.container.size = {100, 80, 60};
        packing_.trays.resize(1);
    }

    void open_height() {
        packing_.container.open_height = true;
        double top = 0;
        for (const Placement& placement : packing_.trays[0].placements) {
            const Mesh& mesh = *meshes_[static_cast<std::size_t>(placement.part)];
            top = std::max(top, bounding_box(transformed(mesh, placement.transform)).max.z);
        }
        packing_.container.size.z = top;
    }

    int add_part(const std::string& name, Mesh mesh, double scale = 1, double unit = 1) {
        PackedPart part;
        part.id = static_cast<int>(packing_.parts.size());
        part.name = name;
        part.count = 0;
        part.scale = scale;
        part.unit = unit;
        packing_.parts.push_back(part);
        meshes_.push_back(std::make_shared<const Mesh>(std::move(mesh)));
        return part.id;
    }

    /// The next copy of a part.
    Placement& place(int part, const Vec3& at, const Mat3& rotation = {}, std::size_t tray = 0) {
        PackedPart& p = packing_.parts[static_cast<std::size_t>(part)];
        packing_.trays[tray].placements.push_back({part, p.count++, 0, false, {p.to_mm() * rotation, at}});
        return packing_.trays[tray].placements.back();
    }

    void state_figures() {
        const double container = packing_.container.size.x * packing_.container.size.y * packing_.container.size.z;
        double all = 0;
        for (TrayPacking& tray : packing_.trays) {
            double volume = 0;
            tray.bounding_box = {};
            for (const Placement& placement : tray.placements) {
                const Mesh& mesh = *meshes_[static_cast<std::size_t>(placement.part)];
                const double mm = packing_.parts[static_cast<std::size_t>(placement.part)].to_mm();
                volume += signed_volume(mesh) * mm * mm * mm;
                tray.bounding_box.add(bounding_box(transformed(mesh, placement.transform)));
            }
            tray.density = volume / container;
            const bool flat = tray.placements.empty();
            tray.density_bounding_box = flat ? 0 : volume / tray.bounding_box.volume();
            tray.height = flat ? 0 : tray.bounding_box.max.z;
            all += volume;
        }
        packing_.metrics.density = all / (container * static_cast<double>(packing_.trays.size()));
    }

    CheckReport check(int threads = 1) {
        Listener quiet;
        return check_packing(packing_, meshes_, Workers(threads), quiet, StopToken());
    }

    CheckReport check_stated() {
        state_figures();
        return check();
    }

    /// Exactly one finding: of this kind, about these placements, with a message that names them and `facts`.
    void expect_only(const CheckReport& report, FindingKind kind, const std::vector<int>& placements,
                     const std::vector<Fact>& facts = {}, int tray = 0) {
        EXPECT_FALSE(report.ok());
        ASSERT_EQ(report.findings.size(), 1u);
        const Finding& finding = report.findings[0];
        SCOPED_TRACE(finding.message);
        EXPECT_EQ(finding.kind, kind);
        EXPECT_EQ(finding.tray, tray);
        EXPECT_EQ(finding.placements, placements);
        for (const int placement : placements) {
            expect_named(finding, tray, placement);
        }
        EXPECT_TRUE(names(finding.message, facts));
    }

    /// By its part's name, and the number that pictures and sheet have; where there is no such copy, by the file's.
    void expect_named(const Finding& finding, int tray, int placement) {
        const Placement& p =
            packing_.trays[static_cast<std::size_t>(tray)].placements[static_cast<std::size_t>(placement)];
        const auto part = static_cast<std::size_t>(p.part);
        const bool known = part < packing_.parts.size();
        const std::string name = known ? packing_.parts[part].name : "part";
        const bool counted = known && p.copy >= 0 && p.copy < packing_.parts[part].count;
        EXPECT_TRUE(names(finding.message, {name, counted ? CopyNumbers(packing_.parts).of(p) : p.copy}));
    }

    Transform& transform(std::size_t placement, std::size_t tray = 0) {
        return packing_.trays[tray].placements[placement].transform;
    }

    Packing packing_;
    std::vector<std::shared_ptr<const Mesh>> meshes_;
};

/// Four cubes in a row that touch, a linked pair of rings, a rod through a ring.
class CubesAndRings : public PackedByHand {
  protected:
    CubesAndRings() {
        const int cube = add_part("cube", cube_mesh(10));
        for (int i = 0; i < 4; ++i) {
            place(cube, {10.0 * i, 0, 0});
        }
        const int ring = add_part("ring", torus_mesh(10, 2));
        place(ring, {20, 40, 30});
        place(ring, {30, 40, 30}, {{Vec3{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}});
        const int rod = add_part("rod", box_mesh({-1, -1, -15}, {1, 1, 15}));
        place(rod, {20, 46, 30});
    }
};

}  // namespace spectralpack::test
