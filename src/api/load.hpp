#pragma once
/// Mesh files into parts: each file is read once, in parallel; what cannot be used is set aside, not fatal.

#include <set>
#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/pack.hpp"

namespace spectralpack {

/// A copy that stands in its tray from the start.
struct FixedPlacement {
    int tray = 0;
    Placement placement;
};

struct LoadedJob {
    /// Those of fixed copies first, then in input order; an unusable file keeps its place as a part without mesh.
    std::vector<PackedPart> parts;
    std::size_t fixed_parts = 0;  ///< so many of them have fixed copies only
    std::vector<FixedPlacement> fixed;
    std::vector<std::set<int>> standing;  ///< by part: the copies of it that stand already (Job::keep)
    PartMeshes meshes;                    ///< by part, file's own coordinates; null where unusable
    std::vector<double> box_volume;       ///< by part: of the scaled mesh's box in file orientation, mm^3
    std::vector<std::string> problem;     ///< by part: why it cannot be used; empty where it can
    std::vector<InputError> unusable;
};

/// Tells repairs and warnings through the listener, once per file. Throws Stopped, in the midst of a mesh too, once the
/// workers are asked to stop.
LoadedJob load_parts(const Job& job, const Workers& workers, Listener& listener);

/// How many copies of the part are to be packed: none of those that stand already.
inline int copies_to_pack(const LoadedJob& loaded, std::size_t part) {
    return part < loaded.fixed_parts ? 0 : loaded.parts[part].count - static_cast<int>(loaded.standing[part].size());
}

}  // namespace spectralpack
