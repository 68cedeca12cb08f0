#pragma once
/// What is in mesh files, and what is wrong with it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/error.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/files.hpp"
#include "spectralpack/mesh_figures.hpp"
#include "spectralpack/names.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack::tools {

/// Which way the facets of a mesh face.
enum class Facing {
    outward,       ///< as the file has them
    turned,        ///< outward, after some or all were turned on loading
    inconsistent,  ///< neighbours face opposite ways
};

/// One object of a mesh file, as it would be packed: after the repairs that are safe.
struct InspectedObject {
    std::string name;
    std::optional<std::string> object;  ///< its id in a 3MF
    int instances = 1;                  ///< build items of it in a 3MF
    double unit = 1;                    ///< mm per unit of the file
    bool unit_known = false;            ///< the file says so itself
    MeshFigures figures;                ///< millimetres
    Facing facing = Facing::outward;
    std::vector<std::string> repairs;      ///< what was mended on loading
    std::vector<std::string> warnings;     ///< what its user should look at
    std::optional<std::string> unit_hint;  ///< why the unit looks wrong
    std::shared_ptr<const Mesh> mesh;      ///< in the file's own coordinates; kept only when asked for
};

struct InspectedFile {
    std::string file;
    std::optional<InputError> unusable;  ///< why; it has no objects then
    std::vector<InspectedObject> objects;
};

struct InspectOptions {
    double unit = 1;  ///< millimetres per unit for files that do not say
    int threads = 0;  ///< 0: all the machine has
    bool keep_meshes = false;
};

/// Each file that the inputs name once, in their order, then what cannot be used among the inputs
/// themselves. Counts and scales do not matter here. Files are read in parallel; nothing is thrown
/// for what is wrong with one. Of `control` only the listener counts.
std::vector<InspectedFile> inspect(const ExpandedInputs& inputs, const InspectOptions& options,
                                   const Control& control = {});

/// The findings as JSON text (docs/format.md).
std::string inspection_json(const std::vector<InspectedFile>& files);

/// The kept meshes to be drawn: each stands alone in a container of its size, side by side as
/// trays.
Scene inspection_scene(const std::vector<InspectedFile>& files);

}  // namespace spectralpack::tools

namespace spectralpack {

template <>
inline constexpr Words<3> kWords<tools::Facing>{"outward", "turned", "inconsistent"};

}  // namespace spectralpack
