#include "voxel/outlines.hpp"

#include <algorithm>
#include <bit>

namespace spectralpack {
namespace {

// Beyond all voxels, and far enough from what an int holds to be moved by any of them.
constexpr int kFar = 1 << 29;

/// Calls visit(x) for the voxels of `row` that are not in `seen` yet, and adds them to it.
template <class Visit>
void for_fresh(const BitGrid::Word* row, std::vector<BitGrid::Word>& seen, const Visit& visit) {
    for (std::size_t w = 0; w < seen.size(); ++w) {
        for (BitGrid::Word fresh = row[w] & ~seen[w]; fresh != 0; fresh &= fresh - 1) {
            visit(static_cast<std::size_t>(64 * static_cast<int>(w) + std::countr_zero(fresh)));
        }
        seen[w] |= row[w];
    }
}

}  // namespace

Outlines::Outlines(const Extent& extent) : extent_(extent) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto lines = static_cast<std::size_t>(extent[across(axis)]) * static_cast<std::size_t>(extent[up(axis)]);
        along_[static_cast<std::size_t>(axis)] = {std::vector<int>(lines, kFar), std::vector<int>(lines, -kFar)};
    }
}

Outlines::Outlines(const BitGrid& voxels) : Outlines(voxels.extent()) {
    const Extent& n = extent_;
    const auto words = static_cast<std::size_t>(voxels.words_per_row());
    Ends& rows = along_[0];
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            const BitGrid::Word* row = voxels.row(y, z);
            const auto line = static_cast<std::size_t>(z) * static_cast<std::size_t>(n.y) + static_cast<std::size_t>(y);
            for (int w = 0; w < voxels.words_per_row(); ++w) {
                if (row[w] == 0) continue;
                rows.first[line] = std::min(rows.first[line], 64 * w + std::countr_zero(row[w]));
                rows.last[line] = 64 * w + 63 - std::countl_zero(row[w]);
            }
        }
    }
    // Along y in each layer, along z over each row of it, both ways: the first to be seen in a line is its end.
    const auto width = static_cast<std::size_t>(n.x);
    std::vector<BitGrid::Word> seen, all;
    for (int axis = 1; axis < 3; ++axis) {
        Ends& ends = along_[static_cast<std::size_t>(axis)];
        for (int j = 0; j < n[up(axis)]; ++j) {
            const auto see = [&](int i, std::vector<int>& of) {
                const BitGrid::Word* row = axis == 1 ? voxels.row(i, j) : voxels.row(j, i);
                for_fresh(row, seen, [&](std::size_t x) { of[static_cast<std::size_t>(j) * width + x] = i; });
            };
            seen.assign(words, 0);
            for (int i = 0; i < n[axis]; ++i)
                see(i, ends.first);
            all = seen;
            seen.assign(words, 0);
            for (int i = n[axis] - 1; seen != all; --i)  // until each line that has an end has its last
                see(i, ends.last);
        }
    }
}

void Outlines::join(const Outlines& others, const VoxelIndex& at) {
    for (int axis = 0; axis < 3; ++axis) {
        Ends& mine = along_[static_cast<std::size_t>(axis)];
        const Ends& theirs = others.along_[static_cast<std::size_t>(axis)];
        const int a = across(axis), u = up(axis);
        for (int j = std::max(0, -at[u]); j < std::min(others.extent_[u], extent_[u] - at[u]); ++j) {
            for (int i = std::max(0, -at[a]); i < std::min(others.extent_[a], extent_[a] - at[a]); ++i) {
                const auto from = static_cast<std::size_t>(j) * static_cast<std::size_t>(others.extent_[a]) +
                                  static_cast<std::size_t>(i);
                if (theirs.first[from] == kFar) continue;
                const auto to = static_cast<std::size_t>(j + at[u]) * static_cast<std::size_t>(extent_[a]) +
                                static_cast<std::size_t>(i + at[a]);
                mine.first[to] = std::min(mine.first[to], theirs.first[from] + at[axis]);
                mine.last[to] = std::max(mine.last[to], theirs.last[from] + at[axis]);
            }
        }
    }
}

std::int64_t Outlines::bytes_for(const Extent& extent) {
    std::int64_t lines = 0;
    for (int axis = 0; axis < 3; ++axis) {
        lines += static_cast<std::int64_t>(extent[across(axis)]) * extent[up(axis)];
    }
    return 2 * lines * static_cast<std::int64_t>(sizeof(int));
}

bool Outlines::leave(const Outlines& others, const VoxelIndex& at) const {
    return leave_along(2, others, at) || leave_along(0, others, at) || leave_along(1, others, at);
}

bool Outlines::leave_along(int axis, const Outlines& others, const VoxelIndex& at) const {
    const Ends& mine = along_[static_cast<std::size_t>(axis)];
    const Ends& theirs = others.along_[static_cast<std::size_t>(axis)];
    const int a = across(axis), u = up(axis);
    // Of the lines that both have, by mine.
    const int lo = std::max(0, -at[a]), hi = std::min(extent_[a], others.extent_[a] - at[a]);
    bool ahead = false, behind = false;  // something is in the way
    for (int j = std::max(0, -at[u]); j < std::min(extent_[u], others.extent_[u] - at[u]); ++j) {
        const auto my_line = static_cast<std::ptrdiff_t>(j) * extent_[a];
        const auto their_line = static_cast<std::ptrdiff_t>(j + at[u]) * others.extent_[a] + at[a];
        const int* my_first = mine.first.data() + my_line;
        const int* my_last = mine.last.data() + my_line;
        const int* their_first = theirs.first.data() + their_line;
        const int* their_last = theirs.last.data() + their_line;
        int ahead_here = 0, behind_here = 0;
        for (int i = lo; i < hi; ++i) {
            ahead_here |= static_cast<int>(their_last[i] > my_first[i] + at[axis]);
            behind_here |= static_cast<int>(their_first[i] < my_last[i] + at[axis]);
        }
        ahead = ahead || ahead_here != 0;
        behind = behind || behind_here != 0;
        if (ahead && behind) return false;
    }
    return true;
}

}  // namespace spectralpack
