#pragma once
/// Mesh files into parts: each file is read once, in parallel; what cannot be used is set aside, not fatal.

#include <vector>

#include "core/listener.hpp"
#include "core/parallel.hpp"
#include "spectralpack/pack.hpp"

namespace spectralpack {

struct LoadedJob {
    std::vector<Part> parts;      ///< in input order; an unusable file keeps its place as a part without mesh
    PartMeshes meshes;            ///< by part, file's own coordinates; null where unusable
    std::vector<double> box_volume;    ///< by part: of the scaled mesh's box in file orientation, mm^3
    std::vector<std::string> problem;  ///< by part: why it cannot be used; empty where it can
    std::vector<InputError> unusable;
};

/// Tells repairs and warnings through the listener, once per file.
LoadedJob load_parts(const Job& job, const Workers& workers, Listener& listener);

/// Hash of all that placements depend on: meshes, counts, scales and options. 32 hexadecimal digits.
std::string input_hash(const LoadedJob& loaded, const PackOptions& options);

}  // namespace spectralpack
