#include "geometry/mesh_shells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace spectralpack {
namespace {

/// More shells than this count as one group: comparing their boxes would take longer than it is
/// worth.
constexpr std::size_t kMostShells = 4096;
/// Solid angles that shells_overlap() may add up, and vertices of one shell it looks at.
constexpr std::size_t kMostAngles = 200'000, kMostSamples = 16;

class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) {
            i = parent_[i] = parent_[parent_[i]];
        }
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    /// Replaces each element by the number of its set, in order of least elements; returns how many
    /// there are.
    std::size_t number(std::vector<std::uint32_t>& of_element) {
        of_element.resize(parent_.size());
        std::uint32_t count = 0;
        for (std::uint32_t i = 0; i < parent_.size(); ++i) {
            const std::uint32_t least = root(i);
            of_element[i] = least == i ? count++ : of_element[least];
        }
        return count;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

/// Of the signed angle under which a facet is seen from `eye`, the half (van Oosterom and Strackee
/// 1983).
double half_solid_angle(const Mesh& mesh, const Triangle& t, const Vec3& eye) {
    const Vec3 a = mesh.vertices[t[0]] - eye, b = mesh.vertices[t[1]] - eye, c = mesh.vertices[t[2]] - eye;
    const double la = length(a), lb = length(b), lc = length(c);
    return std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

}  // namespace

std::size_t orient_consistently(Mesh& mesh, const MeshEdges& edges) {
    struct Neighbour {
        std::uint32_t facet;
        bool agrees;
    };
    std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
    edges.for_each([&](std::uint32_t, std::span<const MeshEdges::Use> uses) {
        if (uses.size() != 2) return;
        const bool agree = uses[0].forward() != uses[1].forward();
        neighbours[uses[0].triangle()].push_back({uses[1].triangle(), agree});
        neighbours[uses[1].triangle()].push_back({uses[0].triangle(), agree});
    });
    std::vector<signed char> turn(mesh.triangles.size(), -1);  // -1: not seen yet
    std::vector<std::uint32_t> shell;
    std::size_t turned = 0;
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (turn[seed] >= 0) continue;
        shell.assign(1, seed);
        turn[seed] = 0;
        std::size_t turns = 0;
        for (std::size_t next = 0; next < shell.size(); ++next) {
            const std::uint32_t facet = shell[next];
            for (const Neighbour& neighbour : neighbours[facet]) {
                const auto wanted = static_cast<signed char>(neighbour.agrees ? turn[facet] : 1 - turn[facet]);
                signed char& state = turn[neighbour.facet];
                if (state < 0) {
                    state = wanted;
                    turns += wanted == 1 ? 1 : 0;
                    shell.push_back(neighbour.facet);
                } else if (state != wanted) {
                    return 0;
                }
            }
        }
        if (2 * turns > shell.size()) {
            for (const std::uint32_t facet : shell) {
                turn[facet] = static_cast<signed char>(1 - turn[facet]);
            }
            turns = shell.size() - turns;
        }
        turned += turns;
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (turn[i] == 1) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
    }
    return turned;
}

ShellGroups shell_groups(const Mesh& mesh, const MeshEdges& edges) {
    DisjointSets facets(mesh.triangles.size());
    edges.for_each([&](std::uint32_t, std::span<const MeshEdges::Use> uses) {
        for (std::size_t i = 1; i < uses.size(); ++i) {
            facets.join(uses[0].triangle(), uses[i].triangle());
        }
    });
    ShellGroups groups;
    groups.shells.resize(facets.number(groups.shell_of_facet));
    const Vec3 origin = mesh.vertices.front();
    StopPoll poll(edges.stop());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        poll.step();
        Shell& shell = groups.shells[groups.shell_of_facet[i]];
        const Vec3 &a = mesh.vertices[mesh.triangles[i][0]], &b = mesh.vertices[mesh.triangles[i][1]],
                   &c = mesh.vertices[mesh.triangles[i][2]];
        shell.volume += dot(a - origin, cross(b - origin, c - origin)) / 6;
        shell.box.add(a);
        shell.box.add(b);
        shell.box.add(c);
    }
    DisjointSets shells(groups.shells.size());
    for (std::uint32_t a = 0; a < groups.shells.size(); ++a) {
        if (groups.shells.size() > kMostShells) {
            shells.join(0, a);
            continue;
        }
        for (std::uint32_t b = a + 1; b < groups.shells.size(); ++b) {
            if (meet(groups.shells[a].box, groups.shells[b].box)) shells.join(a, b);
        }
    }
    std::vector<std::uint32_t> of_shell;
    groups.volume.resize(shells.number(of_shell));
    for (std::size_t i = 0; i < of_shell.size(); ++i) {
        groups.shells[i].group = of_shell[i];
        groups.volume[of_shell[i]] += groups.shells[i].volume;
    }
    return groups;
}

std::size_t turn_outwards(Mesh& mesh, const ShellGroups& groups) {
    std::size_t turned = 0;
    if (std::none_of(groups.volume.begin(), groups.volume.end(), [](double v) { return v < 0; })) return 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (groups.volume[groups.shells[groups.shell_of_facet[i]].group] >= 0) continue;
        std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
        ++turned;
    }
    return turned;
}

bool shells_overlap(const Mesh& mesh, const ShellGroups& groups) {
    const std::size_t shells = groups.shells.size();
    if (shells == groups.volume.size()) return false;  // no boxes meet
    const std::size_t samples = std::min(kMostSamples, kMostAngles / (shells * mesh.triangles.size()));
    if (samples == 0) return false;
    std::vector<std::vector<std::uint32_t>> facets(shells);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        facets[groups.shell_of_facet[i]].push_back(static_cast<std::uint32_t>(i));
    }
    for (std::size_t shell = 0; shell < shells; ++shell) {
        const std::size_t step = std::max<std::size_t>(1, facets[shell].size() / samples);
        for (std::size_t i = 0; i < facets[shell].size(); i += step) {
            const Vec3& eye = mesh.vertices[mesh.triangles[facets[shell][i]][0]];
            double angle = 0;
            for (std::size_t other = 0; other < shells; ++other) {
                if (other == shell || distance(groups.shells[other].box, Box{eye, eye}) > 0) continue;
                for (const std::uint32_t facet : facets[other]) {
                    angle += half_solid_angle(mesh, mesh.triangles[facet], eye);
                }
            }
            // Matter stands in nothing, a cavity in matter; on a surface the number is a fraction,
            // which says nothing.
            const double winding = angle / (2 * std::numbers::pi);
            const double expected = groups.shells[shell].volume >= 0 ? 0 : 1;
            if (std::abs(winding - expected) > 0.9) return true;
        }
    }
    return false;
}

double winding_number(const Mesh& mesh, const Vec3& point) {
    double angle = 0;
    for (const Triangle& triangle : mesh.triangles) {
        angle += half_solid_angle(mesh, triangle, point);
    }
    return angle / (2 * std::numbers::pi);
}

}  // namespace spectralpack
