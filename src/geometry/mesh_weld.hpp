#pragma once
/// Welding: vertices that are the same point become the same index.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spectralpack/mesh.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// Numbers points in order of first appearance; equal coordinates (-0 equals 0) get the same
/// number. Expected time linear, memory by the number of distinct points.
class VertexWelder {
  public:
    /// `expected`: how many distinct points there may be; only speed depends on it.
    explicit VertexWelder(std::size_t expected);

    static constexpr std::size_t kBatch = 96;

    /// Numbers of at most kBatch points; in batches, because the memory accesses of one point then
    /// overlap with those of the next.
    void add(std::span<const Vec3> points, std::uint32_t* numbers);

    /// The distinct points by number; the welder is spent.
    std::vector<Vec3> take() { return std::move(points_); }

  private:
    struct Entry {
        std::uint32_t number, tag;  ///< the tag saves most looks at points that are not equal
    };

    std::uint32_t find_or_add(const Vec3& point, std::uint64_t hash);
    void resize(std::size_t slots);

    std::vector<Vec3> points_;
    std::vector<Entry> table_;  ///< open addressing, at most half full, a power of two
    std::size_t mask_ = 0;
    std::array<std::uint64_t, kBatch> hashes_{};
};

/// Merges vertices with equal coordinates and removes those that no triangle uses; the first of
/// equal ones stays, and their order. Returns how many used vertices were merged away. Throws Stopped, with the mesh as
/// it was, once `stop` is requested.
std::size_t weld_equal_vertices(Mesh& mesh, const StopToken& stop = {});

/// Merges each vertex listed in `candidates` into the first earlier one within `tolerance` of it.
/// Returns how many were merged away. Expected time linear in the candidates: a cell of the search
/// grid holds few vertices that are further apart than the tolerance. Precondition: coordinates are
/// below 2^62 tolerances.
std::size_t weld_near_vertices(Mesh& mesh, const std::vector<std::uint32_t>& candidates, double tolerance);

}  // namespace spectralpack
