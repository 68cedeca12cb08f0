#pragma once
/// Meshes to look at, as meshes.bin has them (openapi.json).

#include <cstdint>
#include <iosfwd>

#include <spectralpack/mesh.hpp>

namespace spectralpack::server {

inline constexpr std::uint32_t kBundleVersion = 1;

/// Adds one mesh: coordinates as multiples of 1/65535 of the box.
void write_mesh_record(std::ostream& out, std::uint32_t id, const Mesh& mesh);

/// Bytes of the record whose head (id, vertices, triangles) says these counts.
constexpr std::uint64_t record_bytes(std::uint64_t vertices, std::uint64_t triangles) {
    constexpr std::uint64_t kHead = 3 * 4 + 6 * 4;
    return kHead + (6 * vertices + 3) / 4 * 4 + 12 * triangles;
}

}  // namespace spectralpack::server
