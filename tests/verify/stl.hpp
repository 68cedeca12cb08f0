#pragma once
/// A tiny reader of binary STL, so that the judge's tests depend on no reader of the library.

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "geometry/mesh_weld.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack::test {

inline Mesh read_stl(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    Mesh mesh;
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
        float numbers[12];
        std::memcpy(numbers, bytes.data() + at, sizeof numbers);
        const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int corner = 1; corner <= 3; ++corner) {
            mesh.vertices.push_back({numbers[3 * corner], numbers[3 * corner + 1], numbers[3 * corner + 2]});
        }
        mesh.triangles.push_back({base, base + 1, base + 2});
    }
    weld_equal_vertices(mesh);
    return mesh;
}

}  // namespace spectralpack::test
