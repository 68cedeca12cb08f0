#pragma once
/// The parsers behind read_meshes(), one per format: bytes to meshes as the file holds them, before
/// any repair. All of them bound what they allocate by the bytes at hand, not by what a header
/// says, refuse coordinates that are not finite, and throw InputError naming the file and the
/// place, or Stopped.

#include <string>
#include <string_view>
#include <vector>

#include "formats/mesh_reader.hpp"

namespace spectralpack {

/// A mesh as its file holds it.
struct ParsedMesh {
    LoadedMesh loaded;
    bool welded = false;  ///< equal coordinates are one vertex already
};

/// A mesh file in memory.
struct MeshBytes {
    std::string file;  ///< for messages
    std::string stem;  ///< name for objects that have none
    std::string_view bytes;
    StopToken stop = {};  ///< gives the reading up
};

std::vector<ParsedMesh> parse_stl(const MeshBytes& source);
std::vector<ParsedMesh> parse_obj(const MeshBytes& source);
std::vector<ParsedMesh> parse_ply(const MeshBytes& source);
std::vector<ParsedMesh> parse_off(const MeshBytes& source);
std::vector<ParsedMesh> parse_binvox(const MeshBytes& source);
std::vector<ParsedMesh> parse_3mf(const MeshBytes& source);

/// A mesh's vertices and triangles are counted in 32 bits; also a triangle soup's, three to a
/// triangle.
inline constexpr std::size_t kMostTriangles = 0xffffffffu / 3;
inline constexpr std::size_t kMostVertices = 0xfffffffeu;

}  // namespace spectralpack
