#pragma once
/// Where bit tables (bit_tables.hpp) hold what: which forms there are tables of, in which order, and the words of a
/// look-up.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/checked.hpp"
#include "search/cpu/tuning.hpp"
#include "voxel/split.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

/// The voxels from 0 to 2^level - 1 along some of the axes, 0 along the others: a run, a plate, a cube.
struct Form {
    int axes = 1;  ///< bit a: along axis a; never 0
    int level = 0;

    int size(int axis) const { return axes >> axis & 1 ? 1 << level : 1; }
    int voxels() const { return size(0) * size(1) * size(2); }
    bool operator==(const Form&) const = default;
};

/// The forms that something is looked up in: runs of 2^level voxels, level <= run_levels; square plates with sides of
/// 2^level, kFirstPlate <= level <= last_plate; cubes, where there are any, likewise.
struct Forms {
    static constexpr int kFirstPlate = 2;

    int run_levels = 0, last_plate = 0;
    bool cubes = false;

    constexpr int longest() const { return 1 << std::max(run_levels, last_plate); }
    constexpr int plates() const { return last_plate - kFirstPlate + 1; }
    constexpr int count() const { return 1 + 3 * run_levels + (cubes ? 4 : 3) * plates(); }
    /// 0 .. count() - 1; of one of them.
    int index(const Form& form) const {
        if (form.level == 0) return 0;
        switch (form.axes) {
            case 1:
            case 2:
            case 4:
                return 1 + form.axes / 2 * run_levels + form.level - 1;
            case 3:
                return 1 + 3 * run_levels + form.level - kFirstPlate;
            default:
                return 1 + 3 * run_levels + (form.axes - 4) * plates() + form.level - kFirstPlate;
        }
    }
    /// Calls visit(form) for all of them, each after those that its table is made from.
    template <class Visit>
    void for_each(const Visit& visit) const {
        visit(Form{1, 0});
        for (const int axes : {1, 2, 4}) {
            for (int level = 1; level <= run_levels; ++level) {
                visit(Form{axes, level});
            }
        }
        for (const int axes : {3, 5, 6, 7}) {
            if (axes == 7 && !cubes) continue;
            for (int level = kFirstPlate; level <= last_plate; ++level) {
                visit(Form{axes, level});
            }
        }
    }
};

/// Words hold 64 voxels along x and lie in the order y, x, table, z with y fastest: eight neighbouring words are a tile
/// of 64 x 8 positions, and a look-up displaced by (dx, dy, dz) is the same eight words elsewhere, shifted. The bits
/// that it takes from beyond the end of a row mean nothing: no piece of a candidate lies there. What all tables hold of
/// a layer of voxels lies together, so that those above all objects, never written, take no memory.
class BitLayout {
  public:
    using Word = std::uint64_t;

    /// Of layers in voxels of dx, and of layers in finer ones: what is asked of those is mostly thin skins, in which
    /// large forms are rare, and they have s^3 times as many tables.
    static constexpr Forms kForms{.run_levels = 4, .last_plate = 4, .cubes = true};
    static constexpr Forms kFineForms{.run_levels = 2, .last_plate = 2, .cubes = false};
    // Of a plate or a cube that loses layers (shapes/lookups.cpp) a run as long as its side may be left.
    static_assert(kForms.run_levels >= kForms.last_plate && kFineForms.run_levels >= kFineForms.last_plate);
    static_assert(kFineForms.plates() > 0);  // cover() takes plates of the first size for granted

    BitLayout() = default;
    /// `fine_layers` in voxels of dx / detail come first, then `coarse_layers`; grid and margin are in voxels of dx.
    BitLayout(const Extent& grid, int margin, int detail, int fine_layers, int coarse_layers)
        : grid_(grid), margin_(margin), detail_(detail), fine_layers_(fine_layers), coarse_layers_(coarse_layers) {
        column_ = voxels().y;
        columns_ = ceil_div(voxels().x, 64);
        table_ = checked_product({columns_, column_});
        up_ = checked_product({table_, tables()});
    }

    int margin() const { return margin_; }
    int detail() const { return detail_; }
    int fine_layers() const { return fine_layers_; }
    int layers() const { return fine_layers_ + coarse_layers_; }
    /// Voxels of a layer to one of dx, along an axis.
    int detail_of(int layer) const { return layer < fine_layers_ ? detail_ : 1; }
    /// That a layer has tables of, if its voxels are `detail` to one of dx.
    static constexpr const Forms& forms_for(int detail) { return detail > 1 ? kFineForms : kForms; }
    const Forms& forms_of(int layer) const { return forms_for(detail_of(layer)); }
    /// Of each table, margin included.
    Extent voxels() const { return {grid_.x + 2 * margin_, grid_.y + 2 * margin_, grid_.z + 2 * margin_}; }

    int tables() const { return first_table(layers()); }
    /// Of a layer: those of all its parts one after the other, before those of the next layer.
    int first_table(int layer) const {
        const int fine = std::min(layer, fine_layers_), coarse = std::max(0, layer - fine_layers_);
        return fine * part_count(detail_) * forms_for(detail_).count() + coarse * kForms.count();
    }

    /// Words to the neighbouring tile along x.
    std::ptrdiff_t next() const { return column_; }
    /// Words to the tile above.
    std::ptrdiff_t up() const { return up_; }
    /// Of a look-up for so many tiles one above the other the lowest need only be in the table; what the others hold
    /// beyond it means nothing.
    static constexpr int kTileLayers = 4;
    /// All there are. Tiles at the end read on beyond it.
    std::int64_t words() const { return checked_product({up_, voxels().z + kTileLayers - 1}) + column_ + 64; }

    /// At most, for what is on the way to plates and cubes, which are made a slab at a time.
    std::int64_t spare_words() const {
        const int layers = std::min(tuning::kSlab + kForms.longest() / 2, voxels().z);
        return kSpare * checked_product({table_, layers, part_count(fine_layers_ > 0 ? detail_ : 1)});
    }

    struct Place {
        std::int32_t offset = 0;  ///< from a tile's first word
        int shift = 0;
    };
    /// A voxel of one of the tables, counted from the corner of its margin.
    struct Spot {
        int table = 0;
        VoxelIndex at;
    };
    /// Of pieces of one form by their corners' displacements d from a position, in the layer's own voxels, not before
    /// the margin on any axis.
    class SpotsOf {
      public:
        /// `form`: one of forms_of(layer).
        SpotsOf(const BitLayout& layout, int layer, const Form& form)
            : first_(layout.table_number(layer, 0, form)),
              next_(layout.forms_of(layer).count()),
              margin_(layout.margin_),
              s_(layout.detail_of(layer)) {}
        Spot operator()(const VoxelIndex& d) const {
            const VoxelIndex margin{margin_, margin_, margin_};
            // Planning is made of these, and division takes long.
            if (s_ == 1) return {first_, d + margin};
            if (s_ == 2) {
                const VoxelIndex coarse{d.x >> 1, d.y >> 1, d.z >> 1};
                return {first_ + next_ * ((d.z & 1) << 2 | (d.y & 1) << 1 | (d.x & 1)), coarse + margin};
            }
            const VoxelIndex coarse{floor_div(d.x, s_), floor_div(d.y, s_), floor_div(d.z, s_)};
            const int part = ((d.z - s_ * coarse.z) * s_ + d.y - s_ * coarse.y) * s_ + d.x - s_ * coarse.x;
            return {first_ + next_ * part, coarse + margin};
        }

      private:
        int first_, next_;  // tables: of part 0, and from a part to the next
        int margin_, s_;
    };
    /// Where it lies from a tile.
    Place place(const Spot& spot) const {
        const auto x = static_cast<unsigned>(spot.at.x);
        const std::int64_t offset = word(spot.table, static_cast<int>(x / 64), spot.at.z) + spot.at.y;
        return {static_cast<std::int32_t>(offset), static_cast<int>(x % 64)};
    }

  protected:
    static constexpr int kSpare = 2;

    int table_number(int layer, int part, const Form& form) const {
        const Forms& forms = forms_of(layer);
        return first_table(layer) + part * forms.count() + forms.index(form);
    }
    /// The first of word w of the rows of a layer of voxels, which lie one after the other.
    std::int64_t word(int table, int w, int z) const { return z * up_ + table * table_ + w * column_; }

    Extent grid_;
    int margin_ = 0, detail_ = 1, fine_layers_ = 0, coarse_layers_ = 0;
    int columns_ = 0;          // words along x
    std::int64_t column_ = 0;  // words along y
    std::int64_t table_ = 0;   // words of a layer of one table
    std::int64_t up_ = 0;      // of all tables
};

}  // namespace spectralpack
