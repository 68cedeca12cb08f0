#include "search/cpu/tables/bit_tables.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "search/cpu/tables/kernels.hpp"

namespace spectralpack {
namespace {

/// 64 bits of a row from bit `first` on, 0 outside the row.
BitTables::Word row_bits(const BitTables::Word* row, int words, int first) {
    const int w = first >= 0 ? first / 64 : -((63 - first) / 64);
    const int shift = first - 64 * w;
    const auto at = [&](int i) { return i >= 0 && i < words ? row[i] : BitTables::Word{0}; };
    return shift == 0 ? at(w) : at(w) >> shift | at(w + 1) << (64 - shift);
}

}  // namespace

BitTables::BitTables(const BitLayout& layout) : BitLayout(layout) {
    if (words() > std::numeric_limits<std::int32_t>::max()) {
        throw ResourceError("the tray is too large for this engine");
    }
    words_ = ZeroedVector<Word>(static_cast<std::size_t>(words()));
    none_.assign(static_cast<std::size_t>(column_), 0);
}

bool BitTables::operator==(const BitTables& other) const {
    return tables() == other.tables() && words_ == other.words_;
}

BitTables::Tables BitTables::spare_tables(int i, int parts, const VoxelBox& box) {
    const int first = box.lo.x / 64;
    const std::int64_t column = box.hi.y - box.lo.y, up = column * (ceil_div(box.hi.x, 64) - first),
                       next = up * (box.hi.z - box.lo.z);
    std::vector<Word>& words = spare_[i];
    words.resize(std::max(words.size(), static_cast<std::size_t>(parts * next)));
    return {words.data(), next, up, column, box.lo.z * up + first * column + box.lo.y};
}

VoxelBox BitTables::in_tables(const VoxelBox& voxels) const {
    const VoxelBox box = intersection(voxels, whole(grid_));
    if (box.empty()) return {};
    const VoxelIndex margin{margin_, margin_, margin_};
    return {box.lo + margin, box.hi + margin};
}

VoxelBox BitTables::reach(int layer, const Form& form, VoxelBox changed) const {
    for (int axis = 0; axis < 3; ++axis) {
        changed.lo[axis] = std::max(0, changed.lo[axis] - ceil_div(form.size(axis) - 1, detail_of(layer)));
    }
    return changed;
}

/// `changed` in table coordinates.
void BitTables::refresh_plain(const Tables& plain, int part, const BitGrid& occupied, const VoxelBox& changed) {
    for (int z = changed.lo.z; z < changed.hi.z; ++z) {
        for (int y = changed.lo.y; y < changed.hi.y; ++y) {
            const Word* row = occupied.row(y - margin_, z - margin_);
            for (int w = changed.lo.x / 64; w <= (changed.hi.x - 1) / 64; ++w) {
                *plain.at(part, w, y, z) = row_bits(row, occupied.words_per_row(), 64 * w - margin_);
            }
        }
    }
}

/// Part `part` of to = that of from OR part `other` of from moved down by `by` voxels of dx along the axis, for the
/// words of the box (margin included).
void BitTables::dilate(const Tables& to, const Tables& from, int part, int other, int axis, int by,
                       const VoxelBox& box) {
    const int rows = voxels().y, layers = voxels().z;
    const auto& [lo, hi] = box;
    const auto count = static_cast<std::size_t>(std::max(0, hi.y - lo.y));
    // What lies beyond the table's end is empty.
    const auto both = axis != 1 ? count : static_cast<std::size_t>(std::max(0, std::min(hi.y, rows - by) - lo.y));
    for (int z = lo.z; z < hi.z; ++z) {
        for (int w = lo.x / 64; w <= (hi.x - 1) / 64; ++w) {
            Word* out = to.at(part, w, lo.y, z);
            const Word* a = from.at(part, w, lo.y, z);
            if (axis == 0 && by > 0) {
                const Word* after = w + 1 < columns_ ? from.at(other, w + 1, lo.y, z) : none_.data() + lo.y;
                kernels().or_moved_down(out, a, from.at(other, w, lo.y, z), after, by, count);
                continue;
            }
            const std::size_t reached = axis == 2 && z + by >= layers ? 0 : both;
            if (reached > 0) {
                kernels().or_rows(out, a, from.at(other, w, axis == 1 ? lo.y + by : lo.y, axis == 2 ? z + by : z),
                                  reached);
            }
            std::copy(a + reached, a + count, out + reached);
        }
    }
}

/// to = from OR `from` moved down by `by` voxels of the layer (s to a voxel of dx) along the axis, for the voxels of
/// the box.
void BitTables::dilate(const Tables& to, const Tables& from, int s, int axis, int by, const VoxelBox& box) {
    const int stride = axis == 0 ? 1 : axis == 1 ? s : s * s;  // from a part to the next along the axis
    for (int part = 0; part < part_count(s); ++part) {
        const int along = part / stride % s;
        const int other = part + ((along + by) % s - along) * stride;
        dilate(to, from, part, other, axis, (along + by) / s, box);
    }
}

/// The table of a form from those of smaller ones, where it may differ: `changed` in table coordinates.
void BitTables::refresh_form(int layer, const Form& form, const VoxelBox& changed) {
    struct Step {
        int axis, by;
    };
    const int s = detail_of(layer);
    const int half = 1 << (form.level - 1);
    Form from = form;
    std::vector<Step> steps;
    if (form.level > Forms::kFirstPlate || std::has_single_bit(static_cast<unsigned>(form.axes))) {
        --from.level;
        for (int axis = 0; axis < 3; ++axis) {
            if (form.axes >> axis & 1) steps.push_back({axis, half});
        }
    } else {
        // The least plates from runs, the least cubes from plates, doubled along one axis more.
        const int last = form.axes == 3 ? 1 : 2;
        from.axes = form.axes & ~(1 << last);
        for (int by = 1; by <= half; by *= 2) {
            steps.push_back({last, by});
        }
    }
    const VoxelIndex end{voxels().x, voxels().y, voxels().z};
    VoxelBox box = reach(layer, form, changed);
    // Words are written whole.
    box.lo.x = box.lo.x / 64 * 64;
    box.hi.x = std::min((box.hi.x + 63) / 64 * 64, end.x);
    // A few layers at a time, so that what is on the way stays in the caches.
    for (VoxelBox slab = box; slab.lo.z < box.hi.z; slab.lo.z = slab.hi.z) {
        slab.hi.z = std::min(slab.lo.z + tuning::kSlab, box.hi.z);
        Tables now = tables_of(layer, from);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            Tables to = tables_of(layer, form);
            VoxelBox part = slab;
            if (i + 1 < steps.size()) {
                // What the steps that follow look at.
                for (std::size_t k = i + 1; k < steps.size(); ++k) {
                    const int axis = steps[k].axis;
                    part.hi[axis] = std::min(part.hi[axis] + ceil_div(steps[k].by, s), end[axis]);
                }
                to = spare_tables(static_cast<int>(i % kSpare), part_count(s), part);
            }
            dilate(to, now, s, steps[i].axis, steps[i].by, part);
            now = to;
        }
    }
}

void BitTables::refresh(int layer, const std::vector<const BitGrid*>& parts, const VoxelBox& changed) {
    const VoxelBox box = in_tables(changed);
    if (box.empty()) return;
    const Tables plain = tables_of(layer, {});
    for (int part = 0; part < part_count(detail_of(layer)); ++part) {
        refresh_plain(plain, part, *parts[static_cast<std::size_t>(part)], box);
    }
    forms_of(layer).for_each([&](const Form& form) {
        if (form.level > 0) refresh_form(layer, form, box);
    });
}

}  // namespace spectralpack
