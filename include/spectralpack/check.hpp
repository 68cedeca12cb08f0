#pragma once
/// The independent judge of packings: from meshes and transforms alone. It shares no code with what it judges.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/events.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

inline constexpr double kCheckTolerance = 1e-3;  ///< mm; also as penetration: touching at gap 0 is allowed
inline constexpr int kWholePacking = -1;         ///< tray of findings that are about no single one

enum class FindingKind {
    outside,    ///< a copy sticks out of the container less the wall gap, or reaches into a keep-out
    overlap,    ///< two copies' materials share space deeper than the tolerance
    nested,     ///< a copy lies wholly inside another's material
    gap,        ///< two copies are nearer than their gap
    transform,  ///< a transform is not rotation x scale + translation (mirrored, sheared, wrong scale)
    density,    ///< a stated figure differs from the measured one
    count,      ///< a copy is placed twice, missing, or beyond its part's count
    plan,       ///< a step of the disassembly plan fails, or a complete one leaves a copy
};

struct Finding {
    FindingKind kind = FindingKind::overlap;
    int tray = 0;                 ///< or kWholePacking
    std::vector<int> placements;  ///< indices into the tray's placements, ascending: the copies it is about
    double amount = 0;            ///< mm of penetration (at least), of missing gap, sticking out or missing way;
                                  ///< difference of a figure; deviation from a rotation; 0 for counts
    std::string message;          ///< for people: names the copies as "61 tube"
};

/// What the replay of a tray's disassembly plan gave. What fails is a finding, too.
struct PlanReport {
    bool complete = false;  ///< it says so, and every copy that is not fixed has a step of its own
    std::int64_t steps = 0;
    std::int64_t sweeps = 0;         ///< moves of one copy past another that were followed on the meshes
    std::vector<int> failed_steps;   ///< ascending
    std::vector<int> without_step;   ///< placements that are not fixed and that no step takes out, ascending
    std::vector<int> staying;        ///< placements that stood there before (Placement::before) and have no step
    Unpack unpack = Unpack::any;     ///< the plan's
    std::int64_t through_walls = 0;  ///< steps that it says leave through the walls
    std::string message;             ///< for people: "plan: 12 steps replayed, ok"

    bool ok() const { return failed_steps.empty(); }
};

struct CheckReport {
    std::vector<Finding> findings;  ///< in tray order, then by placement; those of plans last, by step
    std::optional<double> min_gap;  ///< least distance between two copies of one tray, mm; none with < 2 copies
    std::vector<double> density;    ///< measured, per tray
    std::vector<std::optional<PlanReport>> plans;  ///< per tray; none: it has no plan, interlocking was not checked
    std::int64_t pairs_tested = 0;                 ///< pairs whose meshes were compared
    bool stopped = false;                          ///< ended early: the report is incomplete
    bool ok() const { return findings.empty() && !stopped; }
    /// Every tray has a plan that takes out all that is not fixed.
    bool plans_complete() const;
};

/// Judges a packing from its meshes alone: containment, overlap, nesting, gaps, transforms, counts, stated densities; a
/// disassembly plan is replayed by exact sweeps. Nested means inside *material*: a copy in another's closed hollow or
/// in a cavity is fine. A mesh that is not closed has a surface but no inside; the listener is warned. The report does
/// not depend on `threads` (<= 0: all the machine has). Throws InternalError where a placed part has no mesh.
CheckReport check(const Scene& scene, int threads = 0, const Control& control = {});

/// The report as JSON text.
std::string check_report_json(const Scene& scene, const CheckReport& report);

}  // namespace spectralpack
