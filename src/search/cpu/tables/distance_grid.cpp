#include "search/cpu/tables/distance_grid.hpp"

#include <bit>
#include <limits>
#include <mutex>

#include "core/checked.hpp"
#include "search/cpu/tables/kernels.hpp"
#include "voxel/split.hpp"

namespace spectralpack {
namespace {

constexpr int kLanes = 32;  // of 16 bits, of the widest vectors

/// [first, last) of a row is occupied: distances around it, within [lo, hi). [first, last) grows to what changed.
void lower_around(std::uint16_t* row, int& first, int& last, int lo, int hi) {
    std::fill(row + first, row + last, std::uint16_t{0});
    for (std::uint16_t d = 1; first > lo && row[first - 1] > d; ++d)
        row[--first] = d;
    for (std::uint16_t d = 1; last < hi && row[last] > d; ++d)
        row[last++] = d;
}

/// Distance along x of one row to the occupied voxels of a solid's row; [lo, hi) grows to what
/// changed.
void lower_along_x(std::uint16_t* row, int nx, const BitGrid& solid, const VoxelIndex& at, int y, int z, int& lo,
                   int& hi) {
    const BitGrid::Word* bits = solid.row(y, z);
    for (int w = 0; w < solid.words_per_row(); ++w) {
        for (BitGrid::Word word = bits[w]; word != 0;) {
            const int bit = std::countr_zero(word);
            const int length = std::countr_one(word >> bit);
            word = bit + length < 64 ? word & (~BitGrid::Word{0} << (bit + length)) : 0;
            int first = std::max(0, at.x + 64 * w + bit);
            int last = std::min(nx, at.x + 64 * w + bit + length);
            if (first >= last) continue;
            lower_around(row, first, last, 0, nx);
            lo = std::min(lo, first);
            hi = std::max(hi, last);
        }
    }
}

/// Lowers row(i) from row(i - step), i from `first` on, up to `last` inclusive and beyond it while
/// something changes, inside [0, count). Returns one past the farthest index seen, in steps.
template <class RowLower>
int sweep(int first, int last, int step, int count, const RowLower& lower) {
    int i = first;
    for (; i >= 0 && i < count; i += step) {
        const bool changed = lower(i, i - step);
        const bool inside = step > 0 ? i <= last : i >= last;
        if (!changed && !inside) break;
    }
    return i;
}

/// Distance along x of [lo, hi) of a row to what is set of a row of bits there.
void lower_along_x(std::uint16_t* row, const BitGrid::Word* bits, int lo, int hi) {
    for (int w = lo / 64; w <= (hi - 1) / 64; ++w) {
        for (BitGrid::Word word = bits[w]; word != 0;) {
            const int bit = std::countr_zero(word);
            const int length = std::countr_one(word >> bit);
            word = bit + length < 64 ? word & (~BitGrid::Word{0} << (bit + length)) : 0;
            int first = std::max(lo, 64 * w + bit), last = std::min(hi, 64 * w + bit + length);
            if (first < last) lower_around(row, first, last, lo, hi);
        }
    }
}

/// How far v lies beyond [lo, hi).
int beyond(int v, int lo, int hi) { return std::max({0, lo - v, v - (hi - 1)}); }

/// Boxes that hold all of `boxes`, none of which meet or touch.
std::vector<VoxelBox> apart(std::vector<VoxelBox> boxes) {
    for (std::size_t i = 0; i < boxes.size();) {
        const VoxelBox around{boxes[i].lo - VoxelIndex{1, 1, 1}, boxes[i].hi + VoxelIndex{1, 1, 1}};
        const auto near = std::find_if(boxes.begin() + static_cast<std::ptrdiff_t>(i) + 1, boxes.end(),
                                       [&](const VoxelBox& box) { return !intersection(around, box).empty(); });
        if (near == boxes.end()) {
            ++i;
            continue;
        }
        boxes[i] = hull(boxes[i], *near);
        boxes.erase(near);
        i = 0;  // it may have come near to one before it
    }
    return boxes;
}

}  // namespace

DistanceGrid::DistanceGrid(const Extent& extent, Ceiling ceiling)
    : extent_(extent), ceiling_(ceiling), stride_(ceil_div(extent.x, kLanes) * kLanes), most_above_(most_ever()) {
    if (most_ever() >= std::numeric_limits<std::uint16_t>::max()) {
        throw ResourceError("the tray is too wide for this engine");
    }
    // Sums read rows of one element more than there are voxels (SumTables).
    values_ = ZeroedVector<std::uint16_t>(static_cast<std::size_t>(checked_product({stride_, extent.y, extent.z}) + 1));
    most_of_row_.assign(row_number(0, extent.z), 0);
    for (int x = 0; x < extent.x; ++x) {
        sides_.push_back(static_cast<std::uint16_t>(std::min(x + 1, extent.x - x)));
    }
}

/// Distance to what lies above and below the grid.
int DistanceGrid::from_floor_and_ceiling(int z) const {
    return ceiling_ == Ceiling::closed ? std::min(z + 1, extent_.z - z) : z + 1;
}

/// What [lo, hi) of a row holds where there is no object.
void DistanceGrid::fill_row(int y, int z, int lo, int hi) {
    const int other = std::min({from_floor_and_ceiling(z), y + 1, extent_.y - y});
    kernels().sums<std::uint16_t>().raise_row(row(y, z) + lo, sides_.data() + lo, 0, static_cast<std::uint16_t>(other),
                                              static_cast<std::size_t>(hi - lo));
}

void DistanceGrid::note_most_of_row(int y, int z) {
    most_of_row_[row_number(y, z)] = kernels().max_of_row(row(y, z), static_cast<std::size_t>(extent_.x));
}

void DistanceGrid::note_most() { most_ = kernels().max_of_row(most_of_row_.data(), most_of_row_.size()); }

ChangedLayers DistanceGrid::add(const BitGrid& solid, const VoxelIndex& at, const Workers& workers) {
    const Extent& s = solid.extent();
    const VoxelBox box = intersection({at, at + VoxelIndex{s.x, s.y, s.z}}, {{0, 0, 0}, {extent_.x, extent_.y, top_}});
    ChangedLayers changed(extent_.z);
    if (box.empty()) return changed;

    // Along x, in the object's own rows.
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            int lo = extent_.x, hi = 0;
            lower_along_x(row(y, z), extent_.x, solid, at, y - at.y, z - at.z, lo, hi);
            changed.add({{lo, y, z}, {hi, y + 1, z + 1}});
        }
    }
    if (changed.empty()) return changed;
    // Whole vectors of each row: what lies beside the change is not lowered.
    const int lo = changed.hull().lo.x / kLanes * kLanes;
    const auto width = static_cast<std::size_t>(ceil_div(changed.hull().hi.x - lo, kLanes) * kLanes);
    const auto lower = [&](int y, int z, int from_y, int from_z, ChangedLayers& lowered) {
        const RowChange change = kernels().lower_row(row(y, z) + lo, row(from_y, from_z) + lo, width);
        if (change.end == 0) return false;
        lowered.add({{lo + static_cast<int>(change.begin), y, z}, {lo + static_cast<int>(change.end), y + 1, z + 1}});
        return true;
    };
    std::mutex mutex;
    const auto add_up = [&](const ChangedLayers& lowered) {
        const std::lock_guard lock(mutex);
        changed.add(lowered);
    };

    // Along y, in the object's own layers.
    workers.for_ranges(box.hi.z - box.lo.z, 4, [&](std::int64_t begin, std::int64_t end) {
        ChangedLayers lowered(extent_.z);
        for (int z = box.lo.z + static_cast<int>(begin); z < box.lo.z + static_cast<int>(end); ++z) {
            const auto lower_y = [&](int y, int from) { return lower(y, z, from, z, lowered); };
            const int up = sweep(box.lo.y + 1, box.hi.y - 1, 1, extent_.y, lower_y);
            sweep(std::min(up, extent_.y) - 2, box.lo.y, -1, extent_.y, lower_y);
        }
        add_up(lowered);
    });

    // Along z, everywhere the first two came.
    const int first = changed.hull().lo.y;
    workers.for_ranges(changed.hull().hi.y - first, 8, [&](std::int64_t begin, std::int64_t end) {
        ChangedLayers lowered(extent_.z);
        for (int y = first + static_cast<int>(begin); y < first + static_cast<int>(end); ++y) {
            const auto lower_z = [&](int z, int from) { return lower(y, z, y, from, lowered); };
            const int up = sweep(box.lo.z + 1, box.hi.z - 1, 1, top_, lower_z);
            const int down = sweep(std::min(up, top_) - 2, box.lo.z, -1, top_, lower_z);
            for (int z = std::max(down, 0); z < std::min(up, top_); ++z) {
                note_most_of_row(y, z);
            }
        }
        add_up(lowered);
    });
    note_most();
    return changed;
}

/// 0 where the nearest occupied voxel of none of `face` can lie in `gone`; else how much farther from `gone` a face has
/// to lie at least. `face` is one voxel thick. phi and the distance from `gone` are 1-Lipschitz: where they differ by
/// n, they do so by more than n - 2 k all around within k steps, so steps of n / 4 along both axes miss nothing. Once
/// something is in reach, only what is much more so is looked for.
int DistanceGrid::in_reach(const VoxelBox& face, const VoxelBox& gone) const {
    constexpr int kFar = std::numeric_limits<std::uint16_t>::max();
    constexpr int kCoarse = 4;
    int farther = 0;
    const auto step = [&](int difference) { return std::max(farther > 0 ? kCoarse : 1, difference / 4); };
    for (int z = face.lo.z; z < face.hi.z;) {
        int least_of_layer = kFar;
        for (int y = face.lo.y; y < face.hi.y;) {
            const int other = beyond(y, gone.lo.y, gone.hi.y) + beyond(z, gone.lo.z, gone.hi.z);
            const std::uint16_t* values = row(y, z);
            int least_of_row = kFar;
            for (int x = face.lo.x; x < face.hi.x;) {
                const int nearer = other + beyond(x, gone.lo.x, gone.hi.x) - values[x];
                if (nearer <= 0) farther = std::max(farther, -nearer / 2 + 1);
                least_of_row = std::min(least_of_row, nearer);
                x += step(nearer);
            }
            y += step(least_of_row);
            least_of_layer = std::min(least_of_layer, least_of_row);
        }
        z += step(least_of_layer);
    }
    return farther;
}

/// Grows a box until its faces are out of reach. Then so is what lies outside of them: all voxels on a shortest way to
/// an occupied one have that as a nearest one, and a way into `gone` goes through a face.
VoxelBox DistanceGrid::reach_of(const VoxelBox& gone) const {
    VoxelBox reach = intersection(gone, {{0, 0, 0}, {extent_.x, extent_.y, top_}});
    if (reach.empty()) return {};
    for (bool grown = true; grown;) {
        grown = false;
        for (int axis = 0; axis < 3; ++axis) {
            const int end = axis == 0 ? extent_.x : axis == 1 ? extent_.y : top_;
            VoxelBox low = reach, high = reach;
            low.hi[axis] = reach.lo[axis] + 1;
            high.lo[axis] = reach.hi[axis] - 1;
            const int below = reach.lo[axis] > 0 ? in_reach(low, gone) : 0;
            const int above = reach.hi[axis] < end ? in_reach(high, gone) : 0;
            reach.lo[axis] = std::max(0, reach.lo[axis] - below);
            reach.hi[axis] = std::min(end, reach.hi[axis] + above);
            grown = grown || below > 0 || above > 0;
        }
    }
    return reach;
}

/// Makes phi right in `window`, outside of which it is. The sweeps along each axis begin beside the window: phi there
/// is 1-Lipschitz, so the sweeps along the axes before it would not have lowered it.
void DistanceGrid::recompute(const VoxelBox& window, const std::vector<const BitGrid*>& occupied,
                             const Workers& workers, ChangedLayers& changed) {
    const VoxelIndex lo = window.lo, hi = window.hi;
    const auto width = static_cast<std::size_t>(hi.x - lo.x);
    std::vector<std::uint16_t> before(width * static_cast<std::size_t>(hi.y - lo.y) *
                                      static_cast<std::size_t>(hi.z - lo.z));
    const auto before_of = [&](int y, int z) {
        const int row = (z - lo.z) * (hi.y - lo.y) + y - lo.y;
        return before.data() + static_cast<std::size_t>(row) * width;
    };
    const auto lower = [&](int y, int z, int from_y, int from_z) {
        kernels().lower_row(row(y, z) + lo.x, row(from_y, from_z) + lo.x, width);
    };
    workers.for_ranges(hi.z - lo.z, 4, [&](std::int64_t begin, std::int64_t end) {
        for (int z = lo.z + static_cast<int>(begin); z < lo.z + static_cast<int>(end); ++z) {
            for (int y = lo.y; y < hi.y; ++y) {
                std::uint16_t* values = row(y, z);
                std::copy(values + lo.x, values + hi.x, before_of(y, z));
                fill_row(y, z, lo.x, hi.x);
                for (const BitGrid* grid : occupied) {
                    lower_along_x(values, grid->row(y, z), lo.x, hi.x);
                }
                if (lo.x > 0) {
                    for (int x = lo.x; x < hi.x && values[x] > values[x - 1] + 1; ++x)
                        values[x] = static_cast<std::uint16_t>(values[x - 1] + 1);
                }
                if (hi.x < extent_.x) {
                    for (int x = hi.x - 1; x >= lo.x && values[x] > values[x + 1] + 1; --x)
                        values[x] = static_cast<std::uint16_t>(values[x + 1] + 1);
                }
            }
            for (int y = std::max(1, lo.y); y < hi.y; ++y) {
                lower(y, z, y - 1, z);
            }
            for (int y = std::min(extent_.y - 1, hi.y) - 1; y >= lo.y; --y) {
                lower(y, z, y + 1, z);
            }
        }
    });
    std::mutex mutex;
    workers.for_ranges(hi.y - lo.y, 8, [&](std::int64_t begin, std::int64_t end) {
        const int first = lo.y + static_cast<int>(begin), last = lo.y + static_cast<int>(end);
        for (int z = std::max(1, lo.z); z < hi.z; ++z) {
            for (int y = first; y < last; ++y) {
                lower(y, z, y, z - 1);
            }
        }
        ChangedLayers here(extent_.z);
        for (int z = hi.z - 1; z >= lo.z; --z) {
            for (int y = first; y < last; ++y) {
                if (z + 1 < top_) lower(y, z, y, z + 1);
                const std::uint16_t *was = before_of(y, z), *is = row(y, z) + lo.x;
                const auto from = std::mismatch(was, was + width, is).first - was;
                if (from == static_cast<std::ptrdiff_t>(width)) continue;
                auto to = static_cast<std::ptrdiff_t>(width);
                while (was[to - 1] == is[to - 1])
                    --to;
                here.add({{lo.x + static_cast<int>(from), y, z}, {lo.x + static_cast<int>(to), y + 1, z + 1}});
                note_most_of_row(y, z);
            }
        }
        const std::lock_guard lock(mutex);
        changed.add(here);
    });
}

ChangedLayers DistanceGrid::remove(const std::vector<VoxelBox>& reaches, const std::vector<const BitGrid*>& occupied,
                                   const Workers& workers) {
    ChangedLayers changed(extent_.z);
    for (const VoxelBox& window : apart(reaches)) {
        if (!window.empty()) recompute(window, occupied, workers, changed);
    }
    note_most();
    return changed;
}

void DistanceGrid::raise(int top, const Workers& workers) {
    top = std::min(top, extent_.z);
    if (top <= top_) return;
    workers.for_ranges(extent_.y, 4, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int z = top_; z < top; ++z) {
                fill_row(y, z, 0, extent_.x);
                if (z > 0) kernels().lower_row(row(y, z), row(y, z - 1), static_cast<std::size_t>(stride_));
                note_most_of_row(y, z);
            }
        }
    });
    top_ = top;
    note_most();
    most_above_ = 0;
    for (int z = top; z < extent_.z; ++z) {
        most_above_ = std::max(most_above_, std::min(most_ever(), from_floor_and_ceiling(z)));
    }
}

}  // namespace spectralpack
