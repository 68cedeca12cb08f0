#include "tools/generate/blocks.hpp"

#include <algorithm>
#include <array>

namespace spectralpack::tools {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

Blocks& Blocks::add(const Vec3& low, const Vec3& high) {
    steps_.push_back({low, high, true});
    return *this;
}

Blocks& Blocks::cut(const Vec3& low, const Vec3& high) {
    steps_.push_back({low, high, false});
    return *this;
}

Mesh Blocks::mesh() const {
    std::array<std::vector<double>, 3> planes;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double>& list = planes[static_cast<std::size_t>(axis)];
        for (const Step& step : steps_) {
            list.insert(list.end(), {step.low[axis], step.high[axis]});
        }
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    const auto& xs = planes[0];
    const auto& ys = planes[1];
    const auto& zs = planes[2];
    // Cells with an empty layer all round, so that neighbours need no test.
    const std::size_t nx = xs.size() + 1, ny = ys.size() + 1, nz = zs.size() + 1;
    const std::array<std::size_t, 3> stride{1, nx, nx * ny};
    std::vector<char> filled(nx * ny * nz, 0);
    for (const Step& step : steps_) {
        const auto inside = [](double low, double high, double from, double to) { return from <= low && high <= to; };
        for (std::size_t z = 0; z + 1 < zs.size(); ++z) {
            if (!inside(zs[z], zs[z + 1], step.low.z, step.high.z)) continue;
            for (std::size_t y = 0; y + 1 < ys.size(); ++y) {
                if (!inside(ys[y], ys[y + 1], step.low.y, step.high.y)) continue;
                for (std::size_t x = 0; x + 1 < xs.size(); ++x) {
                    if (!inside(xs[x], xs[x + 1], step.low.x, step.high.x)) continue;
                    filled[(x + 1) + (y + 1) * stride[1] + (z + 1) * stride[2]] = step.filled;
                }
            }
        }
    }

    Mesh mesh;
    std::vector<std::uint32_t> vertex_at(xs.size() * ys.size() * zs.size(), kNone);
    const auto vertex = [&](const std::array<std::size_t, 3>& at) {
        std::uint32_t& index = vertex_at[at[0] + xs.size() * (at[1] + ys.size() * at[2])];
        if (index == kNone) {
            index = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back({xs[at[0]], ys[at[1]], zs[at[2]]});
        }
        return index;
    };
    for (std::size_t z = 1; z < nz; ++z) {
        for (std::size_t y = 1; y < ny; ++y) {
            for (std::size_t x = 1; x < nx; ++x) {
                const std::size_t cell = x + y * stride[1] + z * stride[2];
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const bool here = filled[cell], below = filled[cell - stride[axis]];
                    if (here == below) continue;
                    // The face between the two cells; its corners run counter-clockwise about +axis.
                    const std::array<std::size_t, 3> corner{x - 1, y - 1, z - 1};
                    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                    auto b = corner, c = corner, d = corner;
                    ++b[u];
                    ++c[u], ++c[v];
                    ++d[v];
                    std::array<std::uint32_t, 4> quad{vertex(corner), vertex(b), vertex(c), vertex(d)};
                    if (here) std::swap(quad[1], quad[3]);
                    mesh.triangles.push_back({quad[0], quad[1], quad[2]});
                    mesh.triangles.push_back({quad[0], quad[2], quad[3]});
                }
            }
        }
    }
    return mesh;
}

}  // namespace spectralpack::tools
