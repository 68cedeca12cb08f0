#include "search/cpu/tables/sum_tables.hpp"

#include <bit>
#include <limits>

#include "core/checked.hpp"
#include "search/cpu/tables/kernels.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr std::uint16_t kNone = std::numeric_limits<std::uint16_t>::max();
static_assert(SumLayout::kPooledBlock == 4);  // as the kernels have it

}  // namespace

std::int64_t SumLayout::elements() const {
    constexpr int kOverrun = 256;  // lanes past the last position are read, never used
    return checked_product({layer_, grid_.z + 1}) + stride_ + kOverrun;
}

SumLayout::SumLayout(const Extent& grid, int block)
    : grid_(grid),
      block_(block),
      shift_(std::countr_zero(static_cast<unsigned>(block))),
      phase_((grid.x + block) / block),
      stride_(phase_ * block),
      table_(checked_product({stride_, grid.y + 1})),
      layer_(3 * table_) {
    if (block != 1 && block != kPooledBlock) throw InternalError("no sums are kept for blocks of that size");
    if (elements() > std::numeric_limits<std::int32_t>::max()) {
        throw ResourceError("the tray is too large for this engine");
    }
}

template <class T>
SumTables<T>::SumTables(const Extent& grid, const Extent& window, bool disjoint)
    : SumLayout(grid, window.x), window_(window), disjoint_(disjoint), noted_(grid.z) {
    values_ = ZeroedVector<T>(static_cast<std::size_t>(elements()));
    if (window != kVoxel || kBytes) pooled_ = ZeroedVector<T>(static_cast<std::size_t>(table_ * (grid.z + 1)));
}

template <class T>
const T* SumTables<T>::pooled_row(const DistanceGrid& phi, int y, int z) const {
    if constexpr (!kBytes) {
        if (window_ == kVoxel) return phi.row(y, z);
    }
    return pooled_.data() + in_pooled(y, z);
}

template <class T>
std::uint16_t SumTables<T>::most() const {
    return kBytes || disjoint_ ? kMostPooled : kNone;
}

/// Copies what lies in `layer`.
template <class T>
void SumTables<T>::copy(const DistanceGrid& phi, const VoxelBox& layer) {
    const int z = layer.lo.z;
    for (int y = layer.lo.y; y < layer.hi.y; ++y) {
        kernels().sums<T>().raise_row(pooled_.data() + in_pooled(y, z) + layer.lo.x, phi.row(y, z) + layer.lo.x, 0,
                                      most(), static_cast<std::size_t>(layer.hi.x - layer.lo.x));
    }
}

/// Prefix sums of one row of which [lo, hi) changed: anew there; what lies behind moves by what that grew.
template <class T>
void SumTables<T>::sum_along(T* out, const T* from, int lo, int hi) const {
    const auto move = [](T* begin, T* end, int by) {
        for (; begin != end; ++begin) {
            *begin = static_cast<T>(*begin + by);
        }
    };
    const SumKernels<T>& run = kernels().sums<T>();
    if (block_ == 1) {
        const int end = out[hi];
        run.prefix_sums(out + lo, from + lo, static_cast<std::size_t>(hi - lo));
        move(out + hi + 1, out + grid_.x + 1, out[hi] - end);
        return;
    }
    const int first = lo / block_, last = std::min((hi + block_ - 1) / block_, phase_);
    const int end = run.prefix_sums_dealt(out + first, from + first, static_cast<std::size_t>(phase_),
                                          static_cast<std::size_t>(last - first));
    if (last == phase_) return;
    const int grown = end - out[last];
    for (int p = 0; p < block_; ++p) {
        move(out + p * phase_ + last, out + (p + 1) * phase_, grown);
    }
}

/// Pools what lies in `layer`.
template <class T>
void SumTables<T>::pool_quads(const DistanceGrid& phi, const VoxelBox& layer) {
    const int z = layer.lo.z;
    const auto width = static_cast<std::size_t>(layer.hi.x - layer.lo.x);
    std::vector<std::uint16_t> least(width);
    for (int y = layer.lo.y; y < layer.hi.y; ++y) {
        const auto beside = [&](int dy, int dz) {
            return phi.row(std::min(y + dy, grid_.y - 1), std::min(z + dz, grid_.z - 1)) + layer.lo.x;
        };
        kernels().min_of_four(least.data(), {beside(0, 0), beside(1, 0), beside(0, 1), beside(1, 1)}, floor(), width);
        kernels().sums<T>().raise_row(pooled_.data() + in_pooled(y, z) + layer.lo.x, least.data(), floor(), most(),
                                      width);
    }
}

/// Pools what lies in `layer`, whose rows begin and end with a block (which may end beyond the grid).
template <class T>
void SumTables<T>::pool_blocks(const DistanceGrid& phi, const VoxelBox& layer) {
    const Extent& n = grid_;
    const int z = layer.lo.z;
    const auto width = static_cast<std::size_t>(std::min(n.x, layer.hi.x + block_ - 1) - layer.lo.x);
    const int rows = std::min(n.y, layer.hi.y + block_ - 1) - layer.lo.y;
    std::vector<std::uint16_t> above_each_other(width * static_cast<std::size_t>(rows));
    const auto row_of_layer = [&](int y) { return above_each_other.data() + width * static_cast<std::size_t>(y); };
    for (int y = 0; y < rows; ++y) {
        const auto above = [&](int dz) { return phi.row(layer.lo.y + y, std::min(z + dz, n.z - 1)) + layer.lo.x; };
        kernels().min_of_four(row_of_layer(y), {above(0), above(1), above(2), above(3)}, floor(), width);
    }
    // Beyond the grid nothing counts.
    std::vector<std::uint16_t> least(width + static_cast<std::size_t>(2 * block_), kNone);
    for (int y = 0; y < layer.hi.y - layer.lo.y; ++y) {
        const auto behind = [&](int dy) { return row_of_layer(std::min(y + dy, rows - 1)); };
        kernels().min_of_four(least.data(), {behind(0), behind(1), behind(2), behind(3)}, 0, width);
        kernels().sums<T>().deal_least_of_four(pooled_.data() + in_pooled(layer.lo.y + y, z) + layer.lo.x / block_,
                                               static_cast<std::size_t>(phase_), least.data(), floor(), most(),
                                               static_cast<std::size_t>((layer.hi.x - layer.lo.x) / block_));
    }
}

template <class T>
void SumTables<T>::pool(const DistanceGrid& phi, const VoxelBox& layer) {
    if (block_ > 1) {
        pool_blocks(phi, layer);
    } else if (window_ == kQuad) {
        pool_quads(phi, layer);
    } else if (kBytes) {
        copy(phi, layer);
    }
}

template <class T>
void SumTables<T>::note(const ChangedLayers& changed) {
    for (int z = changed.hull().lo.z; z < changed.hull().hi.z; ++z) {
        VoxelBox box = changed.at(z);
        if (box.empty()) continue;
        for (int axis = 0; axis < 3; ++axis) {
            box.lo[axis] = std::max(0, box.lo[axis] - (window_[axis] - 1));
        }
        box.lo.x = box.lo.x / block_ * block_;
        box.hi.x = (box.hi.x + block_ - 1) / block_ * block_;
        noted_.add(box);
    }
}

template <class T>
void SumTables<T>::follow(const DistanceGrid& phi, int top, const Workers& workers) {
    refresh(phi, noted_, top_, workers);
    noted_.clear();
    top = std::min(top, grid_.z);
    if (top <= top_) return;
    ChangedLayers raised(grid_.z);
    raised.add({{0, 0, top_}, {(grid_.x + block_ - 1) / block_ * block_, grid_.y, top}});
    refresh(phi, raised, top, workers);
    top_ = top;
}

/// Calls visit(first element, how many) for what lies in [lo, hi) of a row: a stretch for each phase, or where that
/// takes fewer steps all from the first on. What lies beside the change is summed up to what it is already, so
/// stretches are long enough for vectors.
template <class T>
template <class Visit>
void SumTables<T>::for_each_stretch(int lo, int hi, const Visit& visit) const {
    constexpr int kNarrow = 16 / sizeof(T), kWide = 64 / sizeof(T);
    const auto steps = [](int count) { return count / kWide + (count % kWide + kNarrow - 1) / kNarrow; };
    const int first = lo / block_;
    const int count = std::max((hi - 1) / block_ + 1 - first, kNarrow);
    if (block_ > 1 && steps(stride_ - first) <= block_ * steps(count)) {
        visit(first, static_cast<std::size_t>(stride_ - first));
        return;
    }
    for (int p = 0; p < block_; ++p) {
        const int begin = std::min(p * phase_ + first, std::max(0, stride_ - count));
        visit(begin, static_cast<std::size_t>(std::min(count, stride_ - begin)));
    }
}

/// Sums along x and y of a layer of which `layer` changed.
template <class T>
void SumTables<T>::sum_layer(const DistanceGrid& phi, const VoxelBox& layer) {
    T* along_x = values_.data();
    T* along_y = values_.data() + table_;
    const int z = layer.lo.z;
    for (int y = layer.lo.y; y < layer.hi.y; ++y) {
        sum_along(along_x + row(y, z), pooled_row(phi, y, z), layer.lo.x, layer.hi.x);
    }
    const SumKernels<T>& run = kernels().sums<T>();
    const std::ptrdiff_t step = stride_, from_step = pooled_.empty() ? phi.stride() : stride_;
    // Only differences count: of a column the shorter side of the change is brought in line with the other.
    const bool behind = grid_.y - layer.lo.y <= layer.hi.y;
    const int y = behind ? layer.lo.y : layer.hi.y - 1;
    for_each_stretch(layer.lo.x, layer.hi.x, [&](int i, std::size_t length) {
        T* out = along_y + row(y, z) + i;
        const T* from = pooled_row(phi, y, z) + i;
        if (behind) {
            run.add_rows(out + step, out, from, static_cast<std::size_t>(grid_.y - y), step, from_step, length);
        } else {
            run.subtract_rows(out, out + step, from, static_cast<std::size_t>(y + 1), -step, -from_step, length);
        }
    });
}

/// Sums along z below layer `top` after phi_W changed within `box`.
template <class T>
void SumTables<T>::sum_columns(const DistanceGrid& phi, const VoxelBox& box, int top, const Workers& workers) {
    T* along_z = values_.data() + 2 * table_;
    const std::ptrdiff_t from_step = pooled_.empty() ? phi.stride() : stride_;
    workers.for_ranges(box.hi.y - box.lo.y, 4, [&](std::int64_t begin, std::int64_t end) {
        const int y = box.lo.y + static_cast<int>(begin);
        for (int z = box.lo.z; z < top; ++z) {
            T* out = along_z + row(y, z);
            const T* from = pooled_row(phi, y, z);
            for_each_stretch(box.lo.x, box.hi.x, [&](int i, std::size_t length) {
                kernels().sums<T>().add_rows(out + row(0, 1) + i, out + i, from + i,
                                             static_cast<std::size_t>(end - begin), stride_, from_step, length);
            });
        }
    });
}

/// Makes the tables right below layer `top` after phi_W changed as `changed` says.
template <class T>
void SumTables<T>::refresh(const DistanceGrid& phi, const ChangedLayers& changed, int top, const Workers& workers) {
    const int first = changed.hull().lo.z, last = std::min(changed.hull().hi.z, top);
    if (first >= last) return;
    workers.for_ranges(last - first, 2, [&](std::int64_t begin, std::int64_t end) {
        for (int z = first + static_cast<int>(begin); z < first + static_cast<int>(end); ++z) {
            if (changed.at(z).empty()) continue;
            pool(phi, changed.at(z));
            sum_layer(phi, changed.at(z));
        }
    });
    VoxelBox box = changed.hull();
    box.hi.z = last;
    sum_columns(phi, box, top, workers);
}

template class SumTables<std::uint16_t>;
template class SumTables<std::uint8_t>;

}  // namespace spectralpack
