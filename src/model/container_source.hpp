#pragma once
/// What a user names to stand in the trays besides the parts: files that are still to be read.

#include <optional>
#include <string>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/transform.hpp"

namespace spectralpack {

/// A mesh file and where it stands.
struct MeshSource {
    std::string file;   ///< usable from the working directory
    std::string place;  ///< where it was named, for messages: "job.json keep_out[0]"
    /// From the file's own coordinates, in its own unit, to the container's. None: the unit alone; a container is
    /// then moved to the origin.
    std::optional<Transform> transform = {};
    std::optional<double> unit = {};  ///< mm per unit where the file does not say; none: the job's
};

struct KeepOutSource {
    Box box;  ///< where there is no mesh
    std::optional<MeshSource> mesh = {};
};

struct ContainerSource {
    std::optional<MeshSource> mesh = {};  ///< none: the box of PackOptions::tray
    std::vector<KeepOutSource> keep_out = {};
    bool physical = false;
};

/// A copy that stands in the first tray and stays there.
struct FixedSource {
    MeshSource mesh;
    std::optional<std::string> name = {};
    std::optional<double> gap = {};  ///< mm; none: the job's
};

}  // namespace spectralpack
