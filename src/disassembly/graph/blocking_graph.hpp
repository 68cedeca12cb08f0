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
    /// No edges. Memory: 6 count^2 bits, and some bytes for each pair known to pass.
    explicit BlockingGraph(std::size_t count);

    /// What this graph knows of `members`, which become 0, 1, ... of the new one.
    BlockingGraph among(const std::vector<std::size_t>& members) const;

    std::size_t count() const { return count_; }
    bool present(std::size_t copy) const { return present_[copy]; }

    /// `copy`, moved in that direction, meets `other`.
    void add(std::size_t copy, AxisDirection direction, std::size_t other);
    /// Of those present, how many `copy` is known to meet.
    int blockers(std::size_t copy, AxisDirection direction) const {
        return blockers_[static_cast<std::size_t>(index(direction))][copy];
    }
    /// Whether it is known to meet that one, which is present.
    bool meets(std::size_t copy, AxisDirection direction, std::size_t other) const {
        return row(index(direction), copy)[other / 64] >> (other % 64) & 1;
    }
    /// Who is known to meet one of `copies` in that direction, or one who does, and so on; those themselves, too.
    /// O(count^2 / 64).
    std::vector<bool> behind(const std::vector<std::size_t>& copies, AxisDirection direction) const;
    /// The copy leaves, and its edges with it. O(count / 64 + edges).
    void remove(std::size_t copy);

    /// `copy`, moved in that direction for ever, passes `other`, by an exact sweep that need not be made again.
    void add_passed(std::size_t copy, AxisDirection direction, std::size_t other);
    /// O(pairs known to pass of one copy).
    bool passed(std::size_t copy, AxisDirection direction, std::size_t other) const;

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

    /// Whom `copy` meets in direction `d`; kept for both ways along an axis.
    Word* row(int d, std::size_t copy) { return edges_[d].data() + copy * words_; }
    const Word* row(int d, std::size_t copy) const { return edges_[d].data() + copy * words_; }

    template <class Visit>
    void for_each(const Word* row, Visit visit) const;

    std::size_t count_, words_;
    std::vector<bool> present_;
    std::vector<Word> edges_[kDirections];
    std::vector<int> blockers_[kDirections];
    std::vector<std::vector<std::uint32_t>>
        passed_[3];  ///< by axis and who moves up (or stays, where the other moves down)
};

}  // namespace spectralpack
