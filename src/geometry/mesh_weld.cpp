#include "geometry/mesh_weld.hpp"

#include <bit>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "core/stopped.hpp"

namespace spectralpack {
namespace {

__extension__ typedef unsigned __int128 Wide;

constexpr std::uint32_t kNone = 0xffffffffu;

std::uint64_t mixed(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    // Multiply-and-fold: coordinates on a grid have many low zero bits, so both halves of the
    // product count.
    const auto fold = [](std::uint64_t a, std::uint64_t b) {
        const auto product = static_cast<Wide>(a) * b;
        return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
    };
    return fold(fold(x ^ 0x9e3779b97f4a7c15u, y ^ 0xbf58476d1ce4e5b9u) ^ z, 0x94d049bb133111ebu);
}

std::uint64_t hash_of(const Vec3& p) {
    // Adding 0 turns -0 into 0.
    return mixed(std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
                 std::bit_cast<std::uint64_t>(p.z + 0.0));
}

}  // namespace

VertexWelder::VertexWelder(std::size_t expected) {
    points_.reserve(expected);
    resize(std::bit_ceil(2 * expected + 2 * kBatch));
}

void VertexWelder::add(std::span<const Vec3> points, std::uint32_t* numbers) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        hashes_[i] = hash_of(points[i]);
        __builtin_prefetch(&table_[hashes_[i] & mask_]);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        numbers[i] = find_or_add(points[i], hashes_[i]);
    }
}

std::uint32_t VertexWelder::find_or_add(const Vec3& point, std::uint64_t hash) {
    const auto tag = static_cast<std::uint32_t>(hash >> 32);
    for (std::size_t slot = hash & mask_;; slot = (slot + 1) & mask_) {
        Entry& entry = table_[slot];
        if (entry.number == kNone) {
            const auto number = static_cast<std::uint32_t>(points_.size());
            entry = {number, tag};
            points_.push_back(point);
            if (2 * points_.size() > table_.size()) resize(2 * table_.size());
            return number;
        }
        if (entry.tag == tag && points_[entry.number] == point) return entry.number;
    }
}

void VertexWelder::resize(std::size_t slots) {
    table_.assign(slots, {kNone, 0});
    mask_ = slots - 1;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const std::uint64_t hash = hash_of(points_[i]);
        std::size_t slot = hash & mask_;
        while (table_[slot].number != kNone) {
            slot = (slot + 1) & mask_;
        }
        table_[slot] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(hash >> 32)};
    }
}

std::size_t weld_equal_vertices(Mesh& mesh, const StopToken& stop) {
    std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            number[corner] = 0;
        }
    }
    std::vector<std::uint32_t> used;
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i < number.size(); ++i) {
        if (number[i] == kNone) continue;
        used.push_back(i);
        points.push_back(mesh.vertices[i]);
    }
    VertexWelder welder(points.size());
    std::array<std::uint32_t, VertexWelder::kBatch> numbers;
    for (std::size_t i = 0; i < points.size(); i += VertexWelder::kBatch) {
        throw_if_stopped(stop);
        const std::size_t count = std::min(VertexWelder::kBatch, points.size() - i);
        welder.add({points.data() + i, count}, numbers.data());
        for (std::size_t k = 0; k < count; ++k) {
            number[used[i + k]] = numbers[k];
        }
    }
    mesh.vertices = welder.take();
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) {
            corner = number[corner];
        }
    }
    return points.size() - mesh.vertices.size();
}

std::size_t weld_near_vertices(Mesh& mesh, const std::vector<std::uint32_t>& candidates, double tolerance) {
    if (candidates.empty() || !(tolerance > 0)) return 0;
    // Cells of twice the tolerance: what is near lies in the same cell or in the nearer neighbour,
    // per axis.
    std::unordered_multimap<std::uint64_t, std::uint32_t> cells(candidates.size());
    std::vector<std::uint32_t> target(mesh.vertices.size());
    std::iota(target.begin(), target.end(), std::uint32_t{0});
    std::size_t merged = 0;
    for (const std::uint32_t vertex : candidates) {
        const Vec3& point = mesh.vertices[vertex];
        std::int64_t cell[3][2];
        for (int axis = 0; axis < 3; ++axis) {
            const double at = point[axis] / (2 * tolerance), floor = std::floor(at);
            cell[axis][0] = static_cast<std::int64_t>(floor);
            cell[axis][1] = cell[axis][0] + (at - floor < 0.5 ? -1 : 1);
        }
        const auto key_of = [&](unsigned corner) {
            return mixed(static_cast<std::uint64_t>(cell[0][corner & 1]),
                         static_cast<std::uint64_t>(cell[1][corner >> 1 & 1]),
                         static_cast<std::uint64_t>(cell[2][corner >> 2]));
        };
        std::uint32_t found = kNone;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const auto [begin, end] = cells.equal_range(key_of(corner));
            for (auto it = begin; it != end; ++it) {
                if (it->second < found && length(mesh.vertices[it->second] - point) <= tolerance) {
                    found = it->second;
                }
            }
        }
        if (found == kNone) {
            cells.emplace(key_of(0), vertex);
        } else {
            target[vertex] = found;
            ++merged;
        }
    }
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) {
            corner = target[corner];
        }
    }
    return merged;
}

}  // namespace spectralpack
