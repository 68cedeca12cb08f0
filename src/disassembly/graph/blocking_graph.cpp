#include "disassembly/graph/blocking_graph.hpp"

#include <algorithm>
#include <bit>

namespace spectralpack {
namespace {

/// Tarjan's strongly connected components (1972), without recursion, of a graph given by successor lists.
class Components {
  public:
    explicit Components(const std::vector<std::vector<std::size_t>>& successors)
        : successors_(successors), order_(successors.size(), 0), low_(successors.size(), 0), of_(successors.size(), 0) {
        for (std::size_t i = 0; i < successors.size(); ++i) {
            if (order_[i] == 0) visit(i);
        }
    }

    std::size_t of(std::size_t node) const { return of_[node] - 1; }
    std::size_t count() const { return components_; }

  private:
    struct Frame {
        std::size_t node, next;
    };

    void enter(std::size_t node) {
        order_[node] = low_[node] = ++entered_;
        open_.push_back(node);
        frames_.push_back({node, 0});
    }

    void visit(std::size_t root) {
        enter(root);
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            const std::size_t node = frame.node;
            if (frame.next < successors_[node].size()) {
                const std::size_t to = successors_[node][frame.next++];
                if (order_[to] == 0) {
                    enter(to);
                } else if (of_[to] == 0) {
                    low_[node] = std::min(low_[node], order_[to]);
                }
                continue;
            }
            frames_.pop_back();
            if (!frames_.empty()) low_[frames_.back().node] = std::min(low_[frames_.back().node], low_[node]);
            if (low_[node] == order_[node]) close(node);
        }
    }

    void close(std::size_t root) {
        ++components_;
        std::size_t node;
        do {
            node = open_.back();
            open_.pop_back();
            of_[node] = components_;
        } while (node != root);
    }

    const std::vector<std::vector<std::size_t>>& successors_;
    std::vector<std::size_t> order_, low_;  // from 1; 0: not entered
    std::vector<std::size_t> of_;           // component from 1; 0: open
    std::vector<std::size_t> open_;
    std::vector<Frame> frames_;
    std::size_t entered_ = 0, components_ = 0;
};

}  // namespace

AxisDirection BlockingGraph::direction(int index) {
    constexpr AxisDirection kPreferred[kDirections] = {{2, 1}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, -1}};
    return kPreferred[index];
}

int BlockingGraph::index(AxisDirection direction) {
    if (direction.axis == 2) return direction.sign > 0 ? 0 : 5;
    return 1 + 2 * direction.axis + (direction.sign > 0 ? 0 : 1);
}

template <class Visit>
void BlockingGraph::for_each(const Word* row, Visit visit) const {
    for (std::size_t word = 0; word < words_; ++word) {
        for (Word bits = row[word]; bits != 0; bits &= bits - 1) {
            visit(64 * word + static_cast<std::size_t>(std::countr_zero(bits)));
        }
    }
}

BlockingGraph::BlockingGraph(std::size_t count) : count_(count), words_((count + 63) / 64), present_(count, true) {
    for (auto& edges : edges_) {
        edges.assign(count * words_, 0);
    }
    for (auto& blockers : blockers_) {
        blockers.assign(count, 0);
    }
    for (auto& passed : passed_) {
        passed.resize(count);
    }
}

std::vector<bool> BlockingGraph::behind(const std::vector<std::size_t>& copies, AxisDirection direction) const {
    const int back = index({direction.axis, -direction.sign});  // who meets a copy is whom it meets the other way
    std::vector<bool> found(count_, false);
    std::vector<std::size_t> open = copies;
    for (const std::size_t copy : copies) {
        found[copy] = true;
    }
    while (!open.empty()) {
        const std::size_t copy = open.back();
        open.pop_back();
        for_each(row(back, copy), [&](std::size_t other) {
            if (found[other]) return;
            found[other] = true;
            open.push_back(other);
        });
    }
    return found;
}

BlockingGraph BlockingGraph::among(const std::vector<std::size_t>& members) const {
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> renumbered(count_, kNone);
    for (std::size_t i = 0; i < members.size(); ++i) {
        renumbered[members[i]] = i;
    }
    BlockingGraph graph(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const AxisDirection up{axis, 1};
            for_each(row(index(up), members[i]), [&](std::size_t other) {
                if (renumbered[other] != kNone) graph.add(i, up, renumbered[other]);
            });
            for (const std::uint32_t other : passed_[axis][members[i]]) {
                if (renumbered[other] != kNone) graph.add_passed(i, up, renumbered[other]);
            }
        }
    }
    return graph;
}

void BlockingGraph::add(std::size_t copy, AxisDirection direction, std::size_t other) {
    const int there = index(direction), back = index({direction.axis, -direction.sign});
    Word& word = row(there, copy)[other / 64];
    const Word bit = Word{1} << (other % 64);
    if (word & bit) return;
    word |= bit;
    row(back, other)[copy / 64] |= Word{1} << (copy % 64);
    ++blockers_[there][copy];
    ++blockers_[back][other];
}

void BlockingGraph::remove(std::size_t copy) {
    present_[copy] = false;
    for (int d = 0; d < kDirections; ++d) {
        const AxisDirection there = direction(d);
        const int back = index({there.axis, -there.sign});
        for_each(row(d, copy), [&](std::size_t other) {
            row(back, other)[copy / 64] &= ~(Word{1} << (copy % 64));
            --blockers_[back][other];
        });
        std::fill_n(row(d, copy), words_, Word{0});
        blockers_[d][copy] = 0;
    }
}

void BlockingGraph::add_passed(std::size_t copy, AxisDirection direction, std::size_t other) {
    const std::size_t low = direction.sign > 0 ? copy : other, high = direction.sign > 0 ? other : copy;
    passed_[direction.axis][low].push_back(static_cast<std::uint32_t>(high));
}

bool BlockingGraph::passed(std::size_t copy, AxisDirection direction, std::size_t other) const {
    const std::size_t low = direction.sign > 0 ? copy : other, high = direction.sign > 0 ? other : copy;
    const std::vector<std::uint32_t>& known = passed_[direction.axis][low];
    return std::find(known.begin(), known.end(), high) != known.end();
}

std::vector<std::vector<std::size_t>> BlockingGraph::groups(AxisDirection direction) const {
    std::vector<std::vector<std::size_t>> successors(count_);
    for (std::size_t from = 0; from < count_; ++from) {
        for_each(row(index(direction), from), [&](std::size_t to) { successors[from].push_back(to); });
    }
    const Components components(successors);
    std::vector<std::vector<std::size_t>> members(components.count());
    std::vector<bool> held(components.count(), false);
    std::size_t standing = 0;
    for (std::size_t copy = 0; copy < count_; ++copy) {
        if (!present_[copy]) continue;
        ++standing;
        members[components.of(copy)].push_back(copy);
        for (const std::size_t to : successors[copy]) {
            if (components.of(to) != components.of(copy)) held[components.of(copy)] = true;
        }
    }
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (!held[i] && members[i].size() >= 2 && members[i].size() < standing) groups.push_back(std::move(members[i]));
    }
    std::sort(groups.begin(), groups.end(),
              [](const auto& a, const auto& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; });
    return groups;
}

}  // namespace spectralpack
