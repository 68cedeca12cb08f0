#include "tools/generate/loft.hpp"

namespace spectralpack::tools {
namespace {

Vec3 unit(const Vec3& v) { return 1 / length(v) * v; }

/// Vertex indices of a fan round the middle of a loop that starts at vertex `first`.
void add_fan(Mesh& mesh, std::uint32_t first, std::uint32_t count, bool reversed) {
    Vec3 middle;
    for (std::uint32_t i = 0; i < count; ++i) {
        middle = middle + mesh.vertices[first + i];
    }
    const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(1.0 / count * middle);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = first + i, b = first + (i + 1) % count;
        mesh.triangles.push_back(reversed ? Triangle{centre, b, a} : Triangle{centre, a, b});
    }
}

std::vector<Loop> turned_loops(const Outline& profile, int segments) {
    std::vector<Loop> loops;
    for (const Vec2& p : profile) {
        loops.push_back(at_height(circle(p.x, segments), p.y));
    }
    return loops;
}

}  // namespace

Mesh loft(const std::vector<Loop>& loops, LoftEnds ends) {
    Mesh mesh;
    const auto rows = static_cast<std::uint32_t>(loops.size());
    const auto count = static_cast<std::uint32_t>(loops.front().size());
    for (const Loop& loop : loops) {
        mesh.vertices.insert(mesh.vertices.end(), loop.begin(), loop.end());
    }
    const std::uint32_t walls = ends == LoftEnds::joined ? rows : rows - 1;
    for (std::uint32_t row = 0; row < walls; ++row) {
        const std::uint32_t low = row * count, high = (row + 1) % rows * count;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t j = (i + 1) % count;
            mesh.triangles.push_back({low + i, low + j, high + j});
            mesh.triangles.push_back({low + i, high + j, high + i});
        }
    }
    if (ends == LoftEnds::capped) {
        add_fan(mesh, 0, count, true);
        add_fan(mesh, (rows - 1) * count, count, false);
    }
    return mesh;
}

Loop at_height(const Outline& outline, double z) {
    Loop loop;
    for (const Vec2& p : outline) {
        loop.push_back({p.x, p.y, z});
    }
    return loop;
}

Mesh prism(const Outline& outline, double z0, double z1) {
    return loft({at_height(outline, z0), at_height(outline, z1)}, LoftEnds::capped);
}

Mesh ring_prism(const Outline& outline, const Outline& hole, double z0, double z1) {
    return loft({at_height(outline, z0), at_height(outline, z1), at_height(hole, z1), at_height(hole, z0)},
                LoftEnds::joined);
}

Mesh turned_ring(const Outline& profile, int segments) {
    return loft(turned_loops(profile, segments), LoftEnds::joined);
}

Mesh turned_solid(const Outline& profile, int segments) {
    return loft(turned_loops(profile, segments), LoftEnds::capped);
}

std::vector<Frame> frames_along(const std::vector<Vec3>& path, bool closed, const Vec3& up) {
    std::vector<Frame> frames;
    const std::size_t count = path.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool first = i == 0 && !closed, last = i + 1 == count && !closed;
        const Vec3 before = first ? Vec3{} : unit(path[i] - path[(i + count - 1) % count]);
        const Vec3 after = last ? Vec3{} : unit(path[(i + 1) % count] - path[i]);
        const Vec3 along = unit(before + after);
        const Vec3 x = unit(cross(up, along));
        frames.push_back({path[i], x, cross(along, x)});
    }
    return frames;
}

Mesh sweep(const std::vector<Vec3>& path, bool closed, const Outline& section, const Vec3& up) {
    std::vector<Loop> loops;
    for (const Frame& frame : frames_along(path, closed, up)) {
        Loop loop;
        for (const Vec2& p : section) {
            loop.push_back(frame.origin + p.x * frame.x + p.y * frame.y);
        }
        loops.push_back(std::move(loop));
    }
    return loft(loops, closed ? LoftEnds::joined : LoftEnds::capped);
}

std::vector<Vec3> flat_path(const Outline& line) { return at_height(line, 0); }

}  // namespace spectralpack::tools
