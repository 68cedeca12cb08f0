#pragma once
/// The tray's occupancy as bits, dilated by runs, square plates and cubes whose sides are powers of two, so that "does
/// such a piece meet something here" is one look-up.
///
/// Invariant, for every layer of occupancy O (a gap class's objects, or the walls):
///   bit X of the table of a form = OR over i in the form of O(X + i), O = 0 outside the grid,
/// for X from -margin to extent + margin on each axis. Fine layers have voxels of dx / s: there X and i count fine
/// voxels, and each part p of them (voxel/split.hpp) has its own tables, bit x of which is fine voxel s x + p.

#include <cstdint>
#include <vector>

#include "core/zeroed.hpp"
#include "search/cpu/tables/bit_layout.hpp"

namespace spectralpack {

class BitTables : public BitLayout {
  public:
    BitTables() = default;
    /// All empty. Throws ResourceError when an offset would not fit 31 bits.
    explicit BitTables(const BitLayout& layout);

    /// Makes the tables of `layer` right after its occupancy changed within the voxels of dx `changed`; O(words that
    /// can differ). `parts`: of a fine layer all its parts, of a coarse layer one grid.
    void refresh(int layer, const std::vector<const BitGrid*>& parts, const VoxelBox& changed);

    /// True when all tables are the same.
    bool operator==(const BitTables& other) const;
    std::int64_t bytes() const {
        std::size_t words = words_.size();
        for (const std::vector<Word>& spare : spare_) {
            words += spare.size();
        }
        return static_cast<std::int64_t>(words * sizeof(Word));
    }

    /// The tile of positions (64 bx .. 64 bx + 63, y .. y + 7, z); displacements are added to it as
    /// offsets.
    const Word* tile(int bx, int y, int z) const { return words_.data() + word(0, bx, z) + y; }
    /// Word w of the rows of a layer of voxels, which lie one after the other.
    const Word* column(int table, int w, int z) const { return words_.data() + word(table, w, z); }
    /// visit(table, form, box) for each table of a layer and the box, counted from the margin's corner, in which it may
    /// differ once the occupancy changed within the voxels of dx `changed`.
    template <class Visit>
    void for_each_table(int layer, const VoxelBox& changed, const Visit& visit) const {
        const VoxelBox box = in_tables(changed);
        if (box.empty()) return;
        forms_of(layer).for_each([&](const Form& form) {
            for (int part = 0; part < part_count(detail_of(layer)); ++part) {
                visit(table_number(layer, part, form), form, reach(layer, form, box));
            }
        });
    }

  private:
    /// One grid of words for each part of a layer: a table, or within a box what is on the way to one.
    struct Tables {
        Word* first;  // word w of row (y, z) of part p lies at p next + z up + w column + y - origin
        std::int64_t next, up, column, origin;
        Word* at(int part, int w, int y, int z) const {
            return first + (part * next + z * up + w * column + y - origin);
        }
    };

    Tables tables_of(int layer, const Form& form) {
        return {words_.data() + table_number(layer, 0, form) * table_, forms_of(layer).count() * table_, up_, column_,
                0};
    }
    /// What is on the way to plates and cubes, for the voxels of a box; i < kSpare. It holds until there are others.
    Tables spare_tables(int i, int parts, const VoxelBox& box);
    /// Voxels of the grid, from the margin's corner; no box where there are none.
    VoxelBox in_tables(const VoxelBox& voxels) const;
    /// Where a form's table may differ when the plain one does in `changed`.
    VoxelBox reach(int layer, const Form& form, VoxelBox changed) const;
    void refresh_plain(const Tables& plain, int part, const BitGrid& occupied, const VoxelBox& changed);
    void dilate(const Tables& to, const Tables& from, int part, int other, int axis, int by, const VoxelBox& box);
    void dilate(const Tables& to, const Tables& from, int s, int axis, int by, const VoxelBox& box);
    void refresh_form(int layer, const Form& form, const VoxelBox& changed);

    ZeroedVector<Word> words_;
    std::vector<Word> none_;           // a column of zeros, beyond the end of rows
    std::vector<Word> spare_[kSpare];  // what is on the way to plates and cubes
};

}  // namespace spectralpack
