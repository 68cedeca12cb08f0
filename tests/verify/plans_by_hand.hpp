#pragma once
/// Trays with plans, written by hand, and what the judge makes of them.

#include <gtest/gtest.h>

#include "scenes.hpp"
#include "support/names.hpp"
#include "verify/check.hpp"

namespace spectralpack::test {

using Path = std::vector<Vec3>;

/// A tray with a plan, written by hand. Figures are not stated, so only findings of plans are looked at.
class PlansByHand : public testing::Test {
  protected:
    PlansByHand() {
        packing_.container.size = {100, 100, 100};
        packing_.trays.resize(1);
        tray().disassembly.emplace();
        plan().complete = true;
    }

    TrayPacking& tray() { return packing_.trays[0]; }
    Disassembly& plan() { return *tray().disassembly; }

    /// The placement's index.
    int place(const Mesh& mesh, const Vec3& at = {}, bool fixed = false) {
        PackedPart part;
        part.id = static_cast<int>(packing_.parts.size());
        part.name = "part" + std::to_string(part.id);
        packing_.parts.push_back(part);
        meshes_.push_back(std::make_shared<const Mesh>(mesh));
        tray().placements.push_back({part.id, 0, 0, fixed, {Mat3{}, at}});
        return part.id;
    }

    void step(const std::vector<int>& placements, const Path& path) { plan().steps.push_back({placements, path}); }

    CheckReport check(int threads = 1) {
        Listener quiet;
        return check_packing(packing_, meshes_, Workers(threads), quiet, StopToken());
    }

    std::vector<Finding> plan_findings(int threads = 1) {
        std::vector<Finding> findings;
        for (const Finding& finding : check(threads).findings) {
            if (finding.kind == FindingKind::plan) findings.push_back(finding);
        }
        return findings;
    }

    void expect_follows() {
        for (const Finding& finding : plan_findings()) {
            ADD_FAILURE() << finding.message;
        }
        EXPECT_TRUE(check().plans_complete());
    }

    /// The first finding is about these placements, and its message names them and `facts`.
    void expect_fails(const std::vector<int>& placements, const std::vector<Fact>& facts = {}) {
        const std::vector<Finding> findings = plan_findings();
        ASSERT_FALSE(findings.empty());
        const std::string& message = findings[0].message;
        EXPECT_EQ(findings[0].placements, placements) << message;
        for (const int placement : placements) {
            EXPECT_TRUE(names(message, {packing_.parts[static_cast<std::size_t>(placement)].name}));
        }
        EXPECT_TRUE(names(message, facts));
        EXPECT_FALSE(check().plans_complete());
    }

    Packing packing_;
    std::vector<std::shared_ptr<const Mesh>> meshes_;
};

/// Two boxes on top of each other, a third beside them, all touching.
class Pile : public PlansByHand {
  protected:
    Pile() {
        place(cube_mesh(10));
        place(cube_mesh(10), {0, 0, 10});
        place(cube_mesh(10), {10, 0, 0});
    }
};

}  // namespace spectralpack::test
