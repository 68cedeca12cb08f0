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
            std::fill(row + first, row + last, std::uint16_t{0});
            for (std::uint16_t d = 1; first > 0 && row[first - 1] > d; ++d)
                row[--first] = d;
            for (std::uint16_t d = 1; last < nx && row[last] > d; ++d)
                row[last++] = d;
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

}  // namespace

DistanceGrid::DistanceGrid(const Extent& extent, Ceiling ceiling)
    : extent_(extent), ceiling_(ceiling), stride_(ceil_div(extent.x, kLanes) * kLanes), most_above_(from_sides()) {
    if (from_sides() >= std::numeric_limits<std::uint16_t>::max()) {
        throw ResourceError("the tray is too wide for this engine");
    }
    values_ = ZeroedVector<std::uint16_t>(static_cast<std::size_t>(checked_product({stride_, extent.y, extent.z})));
    most_of_row_.assign(row_number(0, extent.z), 0);
}

/// Distance to what lies above and below the grid.
int DistanceGrid::from_floor_and_ceiling(int z) const {
    return ceiling_ == Ceiling::closed ? std::min(z + 1, extent_.z - z) : z + 1;
}

/// What a row holds where there is no object.
void DistanceGrid::fill_row(int y, int z) {
    const int other = std::min({from_floor_and_ceiling(z), y + 1, extent_.y - y});
    std::uint16_t* values = row(y, z);
    for (int x = 0; x < extent_.x; ++x) {
        values[x] = static_cast<std::uint16_t>(std::min({other, x + 1, extent_.x - x}));
    }
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

void DistanceGrid::raise(int top, const Workers& workers) {
    top = std::min(top, extent_.z);
    if (top <= top_) return;
    workers.for_ranges(extent_.y, 4, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int z = top_; z < top; ++z) {
                fill_row(y, z);
                if (z > 0) kernels().lower_row(row(y, z), row(y, z - 1), static_cast<std::size_t>(stride_));
                note_most_of_row(y, z);
            }
        }
    });
    top_ = top;
    note_most();
    most_above_ = 0;
    for (int z = top; z < extent_.z; ++z) {
        most_above_ = std::max(most_above_, std::min(from_sides(), from_floor_and_ceiling(z)));
    }
}

}  // namespace spectralpack
