#include "geometry/mesh_edges.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

template <class Visit>
void for_each_use(const Mesh& mesh, const StopToken& stop, Visit visit) {
    StopPoll poll(stop);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        poll.step();
        const Triangle& t = mesh.triangles[i];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = t[corner], b = t[corner == 2 ? 0 : corner + 1];
            if (a != b) visit(std::min(a, b), std::max(a, b), 2 * i + (a < b ? 0 : 1));
        }
    }
}

/// Most vertices have a handful of edges; inserting beats std::sort there.
void sort_uses(MeshEdges::Use* begin, MeshEdges::Use* end) {
    const auto key = [](const MeshEdges::Use& use) { return std::uint64_t{use.high} << 32 | use.code; };
    if (end - begin > 24) {
        std::sort(begin, end, [&](const auto& a, const auto& b) { return key(a) < key(b); });
        return;
    }
    for (MeshEdges::Use* next = begin; next != end; ++next) {
        const MeshEdges::Use moving = *next;
        MeshEdges::Use* to = next;
        for (; to != begin && key(moving) < key(to[-1]); --to) {
            *to = to[-1];
        }
        *to = moving;
    }
}

}  // namespace

MeshEdges::MeshEdges(const Mesh& mesh, const StopToken& stop) : stop_(stop), begin_(mesh.vertices.size() + 1) {
    for_each_use(mesh, stop, [&](std::uint32_t low, std::uint32_t, std::size_t) { ++begin_[low]; });
    // The counts become ends; each is then filled from its end downwards, and so becomes a begin.
    std::uint32_t total = 0;
    for (std::uint32_t& begin : begin_) {
        total += begin;
        begin = total;
    }
    uses_ = std::make_unique_for_overwrite<Use[]>(total);
    for_each_use(mesh, stop, [&](std::uint32_t low, std::uint32_t high, std::size_t code) {
        uses_[--begin_[low]] = {high, static_cast<std::uint32_t>(code)};
    });
    StopPoll poll(stop);
    for (std::size_t low = 0; low + 1 < begin_.size(); ++low) {
        poll.step();
        sort_uses(uses_.get() + begin_[low], uses_.get() + begin_[low + 1]);
    }
}

EdgeCount count_edges(const MeshEdges& edges) {
    EdgeCount count;
    bool balanced = true, any = false;
    edges.for_each([&](std::uint32_t, std::span<const MeshEdges::Use> uses) {
        any = true;
        if (uses.size() == 2) {  // nearly always
            if (uses[0].forward() == uses[1].forward()) {
                ++count.misdirected;
                balanced = false;
            }
            return;
        }
        std::size_t forward = 0;
        for (const MeshEdges::Use& use : uses) {
            forward += use.forward() ? 1 : 0;
        }
        if (2 * forward != uses.size()) balanced = false;
        if (uses.size() % 2 != 0) ++count.border;
        if (uses.size() > 2) ++count.crowded;
    });
    count.closed = any && balanced;
    return count;
}

bool is_closed(const Mesh& mesh, const StopToken& stop) { return count_edges(MeshEdges(mesh, stop)).closed; }

}  // namespace spectralpack
