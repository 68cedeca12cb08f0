#pragma once
/// The directional blocking graphs of a set of copies (Wilson and Latombe 1994; section 4.4): for each axis, who meets
/// whom when moved along it for ever. What is moved up meets what, moved down, meets it, so one graph serves both ways
/// along an axis.
///
/// An edge is never wrong, but some may be missing: rays find most of them, exact sweeps add the rest as they are met.

#include <cstdint>
#include <vector>

#include "geometry/slide.hpp"

namespace spectralpack {

class BlockingGraph {
  public:
    /// No edges. Memory: 3 count^2 bits.
    explicit BlockingGraph(std::size_t count);

    std::size_t count() const { return count_; }
    bool present(std::size_t copy) const { return present_[copy]; }

    /// `copy`, moved in that direction, meets `other`.
    void add(std::size_t copy, AxisDirection direction, std::size_t other);
    /// Of those present, how many `copy` is known to meet.
    int blockers(std::size_t copy, AxisDirection direction) const {
        return blockers_[static_cast<std::size_t>(index(direction))][copy];
    }
    /// The copy leaves, and its edges with it. O(count).
    void remove(std::size_t copy);

    /// Sets of two or more, but not of all present, that may leave in that direction as one and of which no part is
    /// known to (strongly connected components without a way to another), smallest first, each ascending.
    /// O(count^2 / 64 + edges).
    std::vector<std::vector<std::size_t>> groups(AxisDirection direction) const;

    /// +z, +x, -x, +y, -y, -z: 0 to 5, in the order in which ways are preferred.
    static constexpr int kDirections = 6;
    static AxisDirection direction(int index);
    static int index(AxisDirection direction);

  private:
    using Word = std::uint64_t;

    /// Row of `copy` in the graph of an axis: whom it meets on its way in the positive direction.
    Word* row(int axis, std::size_t copy) {
        return edges_[static_cast<std::size_t>(axis)].data() + copy * words_;
    }
    const Word* row(int axis, std::size_t copy) const {
        return edges_[static_cast<std::size_t>(axis)].data() + copy * words_;
    }
    bool edge(int axis, std::size_t from, std::size_t to) const {
        return row(axis, from)[to / 64] >> (to % 64) & 1;
    }

    std::size_t count_, words_;
    std::vector<bool> present_;
    std::vector<Word> edges_[3];
    std::vector<int> blockers_[kDirections];
};

}  // namespace spectralpack
