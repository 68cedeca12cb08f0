#pragma once
/// What a run leaves: the packing file's contents, from what was loaded, planned and placed.

#include <cstdint>
#include <optional>

#include "api/load.hpp"
#include "api/plan.hpp"
#include "packing/job/packing_job.hpp"

namespace spectralpack {

/// A run as it ended, finished or not.
struct PackRun {
    const LoadedJob& loaded;
    const Container& container;
    const PackOptions& options;  ///< as used
    const Plan& plan;
    const std::vector<SettingsSource>& defaults;
    const TraysResult& trays;      ///< at least one
    std::optional<BaseSize> base;  ///< where it was searched for
    PhaseSeconds seconds;          ///< but for disassembly and re-insertion, which the trays tell
    std::int64_t verified = 0;
    int orders = 1;  ///< packed in, of which the best was kept
    std::optional<Improved> improvement = {};
};

Packing packing_of(const PackRun& run, const Workers& workers);

/// The transform from the mesh file's own coordinates to where the copy stands.
Transform transform_of(const LoadedJob& loaded, const Plan& plan, const PlacedCopy& placed);

/// For people: several trays were allowed, and one stayed empty of what is left.
std::string stuck_text(const LoadedJob& loaded, const TraysResult& trays);

}  // namespace spectralpack
