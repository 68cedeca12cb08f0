#pragma once
/// Which triangles meet at which edge.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/stopped.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/mesh_figures.hpp"

namespace spectralpack {

/// Every use of every edge by a triangle, uses of one edge side by side. 24 bytes a triangle;
/// linear time but for the sorting of vertices of very high degree. Triangles with two equal
/// corners count with their other two edges. Making it and walking over it throw Stopped once `stop` is requested.
class MeshEdges {
  public:
    explicit MeshEdges(const Mesh& mesh, const StopToken& stop = {});

    /// One triangle's use of an edge: `high` is the edge's larger vertex (the smaller one is known
    /// from where the use is stored), `code` the triangle and the direction.
    struct Use {
        std::uint32_t high, code;

        std::uint32_t triangle() const { return code >> 1; }
        bool forward() const { return (code & 1) == 0; }  ///< walked from the smaller to the larger vertex
    };

    /// Calls visit(smaller vertex, uses) for every edge.
    template <class Visit>
    void for_each(Visit visit) const {
        StopPoll poll(stop_);
        for (std::size_t low = 0; low + 1 < begin_.size(); ++low) {
            poll.step();
            for (std::uint32_t first = begin_[low]; first < begin_[low + 1];) {
                std::uint32_t last = first + 1;
                while (last < begin_[low + 1] && uses_[last].high == uses_[first].high) {
                    ++last;
                }
                visit(static_cast<std::uint32_t>(low), std::span<const Use>(uses_.get() + first, last - first));
                first = last;
            }
        }
    }

    const StopToken& stop() const { return stop_; }

  private:
    StopToken stop_;
    std::vector<std::uint32_t> begin_;  ///< by smaller vertex: where its uses start
    std::unique_ptr<Use[]> uses_;
};

EdgeCount count_edges(const MeshEdges& edges);

/// count_edges().closed: true when the oriented boundary is zero, every directed edge being met by as many
/// opposite ones. Exactly then the winding number is the same from wherever it is counted, and the mesh
/// encloses a solid.
bool is_closed(const Mesh& mesh, const StopToken& stop = {});

}  // namespace spectralpack
