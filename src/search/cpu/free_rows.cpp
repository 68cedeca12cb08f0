#include "search/cpu/free_rows.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;

/// 64 bits of a table from bit `at` on, which may lie outside of it.
Word bits_at(const Word* table, int words, int at) {
    const int w = at >> 6, bit = at & 63;
    if (w < -1 || w >= words) return 0;
    // The word after the last and the one before the first are zeros.
    return bit == 0 ? table[w] : table[w] >> bit | table[w + 1] << (64 - bit);
}

/// A stride that visits 0 .. n - 1 in jumps of about the golden section, so that any first part is spread over all.
std::size_t spreading_stride(std::size_t n) {
    auto stride = static_cast<std::size_t>(0.618 * static_cast<double>(n)) | 1;
    while (std::gcd(stride, n) != 1) {
        ++stride;
    }
    return stride;
}

}  // namespace

FreeRows::FreeRows(const Tray& tray, std::shared_ptr<DilatedRows> rows, const FreeQuery& query, const BitGrid& solid)
    : tray_(tray), rows_(std::move(rows)) {
    for (int axis = 0; axis < 3; ++axis) {
        origin_[axis] = -(solid.extent()[axis] - 1) - query.padding;
        extent_[axis] = tray.extent()[axis] + solid.extent()[axis] - 1 + 2 * query.padding;
    }
    looks_ = looks_for(solid);
    if (!query.without) return;
    around_ = intersection(tray.object(*query.without).box(), whole(tray.extent()));
    if (around_.empty()) return;
    around_.lo.x = 0;
    around_.hi.x = tray.extent().x;
    without_it_ = tray.omega_move(around_, query.without);
    own_.resize(static_cast<std::size_t>(without_it_.extent().y) * static_cast<std::size_t>(without_it_.extent().z));
}

const Word* FreeRows::row(int y, int z) {
    const VoxelBox& box = around_;
    if (box.empty() || y < box.lo.y || y >= box.hi.y || z < box.lo.z || z >= box.hi.z) return rows_->row(tray_, y, z);
    std::vector<Word>& tables = own_[static_cast<std::size_t>(z - box.lo.z) * static_cast<std::size_t>(without_it_.extent().y) +
                                     static_cast<std::size_t>(y - box.lo.y)];
    if (tables.empty()) {
        tables.assign(rows_->row_words(), 0);
        rows_->dilate(without_it_.row(y - box.lo.y, z - box.lo.z), tables.data());
    }
    return tables.data();
}

std::vector<FreeRows::Look> FreeRows::looks_for(const BitGrid& voxels) const {
    constexpr int kLongest = 2 << (DilatedRows::kLevels - 1);
    std::vector<Look> looks;
    for (const Run& run : runs_along(voxels, 0).runs) {
        for (int done = 0; done < run.length; done += kLongest) {
            const int length = std::min(kLongest, run.length - done);
            const int level = std::min(static_cast<int>(std::bit_width(static_cast<unsigned>(length))), DilatedRows::kLevels) - 1;
            const int begin = origin_.x + run.start.x + done + DilatedRows::kShift;
            looks.push_back({origin_.y + run.start.y, origin_.z + run.start.z, level, begin, begin + length - (1 << level)});
        }
    }
    const std::size_t stride = spreading_stride(looks.size());
    std::vector<Look> spread;
    spread.reserve(looks.size());
    for (std::size_t i = 0, at = 0; i < looks.size(); ++i, at = (at + stride) % looks.size()) {
        spread.push_back(looks[at]);
    }
    return spread;
}

FreeRows::Told FreeRows::tell(int y, int z, int word, std::uint64_t wanted) {
    const Extent& grid = rows_->extent();
    const int words = rows_->words();
    const Word* nothing = rows_->empty_row();
    const int x = 64 * word;
    Word blocked = x + 64 > extent_.x ? ~((Word{1} << (extent_.x - x)) - 1) : 0;
    for (const Look& look : looks_) {
        const int at_y = y + look.y, at_z = z + look.z;
        if (at_y < 0 || at_y >= grid.y || at_z < 0 || at_z >= grid.z) continue;
        const Word* tables = row(at_y, at_z);
        if (tables == nothing) continue;
        const Word* table = tables + look.level * (words + 2) + 1;
        blocked |= bits_at(table, words, x + look.begin);
        if (look.end != look.begin) blocked |= bits_at(table, words, x + look.end);
        if ((wanted & ~blocked) == 0) return {blocked, 0};
    }
    return {~Word{0}, ~blocked};
}

void FreeRows::words(int y, int z, int first, int count, std::uint64_t* free) {
    for (int i = 0; i < count; ++i) {
        free[i] = tell(y, z, first + i, ~Word{0}).free;
    }
}

}  // namespace spectralpack
