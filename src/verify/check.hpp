#pragma once
/// The independent judge of packings: from meshes and transforms alone. It shares no code with what it judges:
/// distances are decided by FCL, insides by its own winding count in double precision. Where there is a disassembly
/// plan it is replayed by exact sweeps (sweep.hpp).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/listener.hpp"
#include "core/parallel.hpp"
#include "core/stop.hpp"
#include "geometry/mesh.hpp"
#include "model/packing.hpp"

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
    std::string message;          ///< for people: names the copies as "name #copy"
};

/// What the replay of a tray's disassembly plan gave. What fails is a finding, too.
struct PlanReport {
    bool complete = false;  ///< it says so, and every copy that is not fixed has a step of its own
    std::int64_t steps = 0;
    std::int64_t sweeps = 0;        ///< moves of one copy past another that were followed on the meshes
    std::vector<int> failed_steps;  ///< ascending
    std::vector<int> without_step;  ///< placements that are not fixed and that no step takes out, ascending
    std::string message;            ///< for people: "plan: 12 steps replayed, ok"

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

/// `meshes`: by part, in the mesh file's own coordinates. Nested means inside *material*: a copy in another's
/// closed hollow or in a cavity is fine; a copy in solid matter is not, even if no triangles meet. A mesh that is
/// not closed has a surface but no inside; the listener is warned. How overlap is decided: overlap.hpp.
/// Meshes of parts without placements may be null. Does not depend on the number of threads. Throws InternalError where
/// a placed part has no mesh.
CheckReport check_packing(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                          const Workers& workers, Listener& listener, const StopToken& stop);

}  // namespace spectralpack
