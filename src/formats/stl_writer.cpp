#include <bit>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>

#include "core/atomic_file.hpp"
#include "formats/packing_file.hpp"
#include "formats/tray_row.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little endian");

constexpr std::size_t kFacetBytes = 50;

char* put(char* at, const Vec3& v) {
    const float coordinates[3] = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    std::memcpy(at, coordinates, sizeof coordinates);
    return at + sizeof coordinates;
}

std::string facets(const Mesh& mesh) {
    std::string bytes(kFacetBytes * mesh.triangles.size(), '\0');
    char* at = bytes.data();
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 normal = cross(b - a, c - a);
        const double size = length(normal);
        at = put(at, size > 0 ? 1 / size * normal : Vec3{});
        at = put(put(put(at, a), b), c) + 2;
    }
    return bytes;
}

/// `count` facets that write(out) writes, under a header.
void write_facets(const std::filesystem::path& path, std::uint64_t count,
                  const std::function<void(std::ostream&)>& write) {
    if (count > std::numeric_limits<std::uint32_t>::max()) {
        throw ResourceError("cannot write " + path.string() + ": an STL holds no more than 4294967295 facets");
    }
    replace_file(path, [&](const std::filesystem::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        char header[84] = "binary STL, millimetres";
        const auto stated = static_cast<std::uint32_t>(count);
        std::memcpy(header + 80, &stated, sizeof stated);
        out.write(header, sizeof header);
        write(out);
        out.close();
        if (!out) throw write_failure(path);
    });
}

}  // namespace

void write_stl(const Mesh& mesh, const std::filesystem::path& path) {
    write_facets(path, mesh.triangles.size(), [&](std::ostream& out) {
        const std::string bytes = facets(mesh);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

void write_stl(const Packing& packing, const PartMeshes& meshes, const std::filesystem::path& path) {
    std::uint64_t count = 0;
    for (const TrayPacking& tray : packing.trays) {
        for (const Placement& placement : tray.placements) {
            count += meshes.at(static_cast<std::size_t>(placement.part))->triangles.size();
        }
    }
    write_facets(path, count, [&](std::ostream& out) {
        for (std::size_t i = 0; i < packing.trays.size(); ++i) {
            const Vec3 shift{tray_shift(packing, i), 0, 0};
            for (const Placement& placement : packing.trays[i].placements) {
                Transform transform = placement.transform;
                transform.translation = transform.translation + shift;
                const std::string bytes =
                    facets(transformed(*meshes.at(static_cast<std::size_t>(placement.part)), transform));
                out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
            }
        }
    });
}

}  // namespace spectralpack
