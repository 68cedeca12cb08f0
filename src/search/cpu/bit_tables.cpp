#include "search/cpu/bit_tables.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "search/cpu/kernels.hpp"

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
}

bool BitTables::operator==(const BitTables& other) const {
    if (tables() != other.tables() || words_.size() != other.words_.size()) return false;
    for (int z = 0; z < voxels().z; ++z) {  // spare tables are what they are
        const Word* here = column(0, 0, z);
        if (!std::equal(here, here + tables() * table_, other.column(0, 0, z))) return false;
    }
    return true;
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
void BitTables::refresh_plain(Word* plain, const BitGrid& occupied, const VoxelBox& changed) {
    for (int z = changed.lo.z; z < changed.hi.z; ++z) {
        for (int y = changed.lo.y; y < changed.hi.y; ++y) {
            const Word* row = occupied.row(y - margin_, z - margin_);
            for (int w = changed.lo.x / 64; w <= (changed.hi.x - 1) / 64; ++w) {
                plain[word(0, w, z) + y] = row_bits(row, occupied.words_per_row(), 64 * w - margin_);
            }
        }
    }
}

/// to = from OR `moved` moved down by `by` voxels of dx along the axis, for the words of lo <= X < hi (margin
/// included).
void BitTables::dilate(Word* to, const Word* from, const Word* moved, int axis, int by, const VoxelIndex& lo,
                       const VoxelIndex& hi) {
    const int rows = voxels().y, layers = voxels().z;
    const auto count = static_cast<std::size_t>(std::max(0, hi.y - lo.y));
    // What lies beyond the table's end is empty.
    const auto both = axis != 1 ? count : static_cast<std::size_t>(std::max(0, std::min(hi.y, rows - by) - lo.y));
    const std::int64_t up = axis == 0 ? 0 : axis == 1 ? by : by * up_;
    for (int z = lo.z; z < hi.z; ++z) {
        for (int w = lo.x / 64; w <= (hi.x - 1) / 64; ++w) {
            const std::int64_t at = word(0, w, z) + lo.y;
            if (axis == 0 && by > 0) {
                or_moved_down(to + at, from + at, moved + at, moved + at + column_, by, count);
                continue;
            }
            const std::size_t reached = axis == 2 && z + by >= layers ? 0 : both;
            if (reached > 0) or_rows(to + at, from + at, moved + at + up, reached);
            std::copy(from + at + reached, from + at + count, to + at + reached);
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
        dilate(to.of(part), from.of(part), from.of(other), axis, (along + by) / s, box.lo, box.hi);
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
    VoxelBox box = reach(layer, form, changed);
    // Words are written whole.
    box.lo.x = box.lo.x / 64 * 64;
    box.hi.x = std::min((box.hi.x + 63) / 64 * 64, grid_.x + 2 * margin_);
    Tables now = tables_of(layer, from);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        Tables to = tables_of(layer, form);
        VoxelBox part = box;
        if (i + 1 < steps.size()) {
            to = spare_tables(static_cast<int>(i % 2));
            // What the steps that follow look at.
            for (std::size_t k = i + 1; k < steps.size(); ++k) {
                const int axis = steps[k].axis;
                part.hi[axis] = std::min(part.hi[axis] + ceil_div(steps[k].by, s), grid_[axis] + 2 * margin_);
            }
        }
        dilate(to, now, s, steps[i].axis, steps[i].by, part);
        now = to;
    }
}

void BitTables::refresh(int layer, const std::vector<const BitGrid*>& parts, const VoxelBox& changed) {
    const VoxelBox box = in_tables(changed);
    if (box.empty()) return;
    const Tables plain = tables_of(layer, {});
    for (int part = 0; part < part_count(detail_of(layer)); ++part) {
        refresh_plain(plain.of(part), *parts[static_cast<std::size_t>(part)], box);
    }
    forms_of(layer).for_each([&](const Form& form) {
        if (form.level > 0) refresh_form(layer, form, box);
    });
}

}  // namespace spectralpack
