#pragma once
/// The packing file (docs/format.md) and the other files a packing is written as. Whole or not at
/// all.

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spectralpack/mesh.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Meshes of a packing's parts by part index, as loaded (the file's own coordinates).
using PartMeshes = std::vector<std::shared_ptr<const Mesh>>;

/// JSON text of `packing`; mesh paths are written relative to `folder` (the packing file's).
std::string packing_to_json(const Packing& packing, const std::filesystem::path& folder);
void write_packing(const Packing& packing, const std::filesystem::path& path);

/// Throws UsageError where a packing file in `folder` cannot hold the path of one of these mesh files, relative to the
/// folder: it is not valid UTF-8.
void require_mesh_paths(const std::set<std::string>& files, const std::filesystem::path& folder);

/// Reads and validates a packing file. Mesh paths come out usable from the working directory.
/// Throws InputError naming the key's path ("trays[0].placements[3].transform") for anything
/// missing, of the wrong type, out of range or not finite. Unknown keys are ignored (later versions
/// may add some); an unknown version is refused.
Packing read_packing(const std::filesystem::path& path);

/// The same for text at hand; `path` is for messages, and mesh paths are relative to its folder.
Packing parse_packing(const std::filesystem::path& path, std::string_view text);

/// 3MF: one object per distinct mesh and scale, one build item per copy, part numbers from names;
/// mm; all trays side by side when there are several.
void write_3mf(const Packing& packing, const PartMeshes& meshes, const std::filesystem::path& path);

/// Binary STL of all copies merged.
void write_stl(const Packing& packing, const PartMeshes& meshes, const std::filesystem::path& path);

/// Binary STL of one mesh as it stands.
void write_stl(const Mesh& mesh, const std::filesystem::path& path);

/// CSV of transforms: tray,part,name,copy,orientation,m00..m23. The packing's trays are numbered from `first` on.
void write_transforms_csv(const Packing& packing, const std::filesystem::path& path, std::size_t first = 1);

}  // namespace spectralpack
