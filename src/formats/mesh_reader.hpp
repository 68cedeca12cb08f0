#pragma once
/// Meshes in: one function for every format. Chosen by content where that is possible, else by
/// ending.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/remarks.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// One object of a mesh file, in the file's own unit. The item transform of a 3MF is already
/// applied to the mesh (its matrix and the object's id are kept to name it).
struct LoadedMesh {
    Mesh mesh;
    std::string name;  ///< the object's own name or part number; else the file's stem
    std::optional<std::string> object;
    std::optional<Transform> item_transform;
    int instances = 1;                 ///< 3MF: build items that are this object in this orientation
    std::optional<double> unit;        ///< mm per unit where the file says it (3MF)
    std::vector<std::string> repairs;  ///< what was mended, in words
    std::vector<Remark> warnings;      ///< what the user should look at
};

/// Reads STL (binary, ASCII), OBJ, PLY, OFF, 3MF and binvox (its voxels' faces). Several objects of
/// a 3MF are elements of their own, in file order. Meshes come out welded (equal coordinates are one
/// vertex), without zero-area and duplicate facets, closed shells turned outwards; each such repair
/// is told. Throws InputError naming file, place and cause for what cannot be used: unreadable,
/// truncated, not finite, no triangles, zero volume or flat; one such object refuses the whole file.
/// `default_unit`: mm per unit of files that do not say theirs; only warnings about the size depend
/// on it. Throws Stopped once `stop` is requested.
std::vector<LoadedMesh> read_meshes(const std::filesystem::path& path, double default_unit = 1,
                                    const StopToken& stop = {});

/// A mesh from memory, mended as one from a file. Throws InputError naming it where it cannot be used: as read_meshes,
/// and for triangles of vertices that it does not have.
LoadedMesh adopt_mesh(Mesh mesh, const std::string& name, double unit, const StopToken& stop = {});

/// True for endings that read_meshes knows.
bool is_mesh_file(const std::filesystem::path& path);

}  // namespace spectralpack
