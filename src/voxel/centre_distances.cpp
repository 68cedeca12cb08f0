#include "voxel/centre_distances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace spectralpack {
namespace {

using Square = std::int16_t;  ///< of a distance in voxels

constexpr double kSlack = 1e-5;                             // voxels: far more than cubes and rounding are off by
constexpr int kMostCap = 127;                               // 2 * 127^2 is a Square
constexpr std::int64_t kMostBytes = std::int64_t{1} << 27;  // of the planes that a thread holds

/// Distances from here on are all the same: too far.
int cap_for(double reach) { return static_cast<int>(std::ceil(reach + std::numbers::sqrt3 + kSlack)) + 1; }

/// Planes of the squared distances to what is set in the same plane, those of the layers within the cap at a time.
class Planes {
  public:
    Planes(const BitGrid& set, int cap)
        : set_(set),
          cap_(cap),
          row_(static_cast<std::size_t>(set.extent().x)),
          rows_(static_cast<std::size_t>(set.extent().y)),
          held_(static_cast<std::size_t>(std::min(2 * cap + 1, set.extent().z))),
          squares_(held_ * rows_ * row_),
          any_(held_ * rows_),
          along_(rows_ * row_),
          along_any_(rows_) {}

    /// Takes the place of the layer 2 * cap + 1 before it.
    void make(int z) {
        for (std::size_t y = 0; y < rows_; ++y) {
            along_any_[y] = measure_row(set_.row(static_cast<int>(y), z), &along_[y * row_]);
        }
        for (std::size_t y = 0; y < rows_; ++y) {
            Square* const to = squares(static_cast<int>(y), z);
            std::fill_n(to, row_, static_cast<Square>(cap_ * cap_));
            bool any = false;
            for_each_within(static_cast<int>(y), static_cast<int>(rows_), [&](int other, Square square) {
                const auto from = static_cast<std::size_t>(other);
                if (!along_any_[from]) return;
                any = true;
                lower_to(to, &along_[from * row_], square);
            });
            any_[slot(static_cast<int>(y), z)] = any;
        }
    }

    /// The squared distances of a row, at most those in `to`.
    void measure(int y, int z, std::vector<Square>& to) {
        for_each_within(z, set_.extent().z, [&](int other, Square square) {
            if (any_[slot(y, other)]) lower_to(to.data(), squares(y, other), square);
        });
    }

  private:
    std::size_t slot(int y, int z) const {
        return static_cast<std::size_t>(z) % held_ * rows_ + static_cast<std::size_t>(y);
    }
    Square* squares(int y, int z) { return &squares_[slot(y, z) * row_]; }

    /// Calls visit(j, (j - i)^2) for the j in [0, count) within the cap.
    template <class Visit>
    void for_each_within(int i, int count, Visit visit) const {
        for (int j = std::max(0, i - cap_); j <= std::min(count - 1, i + cap_); ++j) {
            visit(j, static_cast<Square>((j - i) * (j - i)));
        }
    }

    void lower_to(Square* to, const Square* from, Square more) const {
        for (std::size_t x = 0; x < row_; ++x) {
            to[x] = std::min(to[x], static_cast<Square>(from[x] + more));
        }
    }

    /// The squared distances along the row. False: nothing is set in it, and they are not written.
    bool measure_row(const BitGrid::Word* bits, Square* to) const {
        if (std::all_of(bits, bits + set_.words_per_row(), [](BitGrid::Word word) { return word == 0; })) return false;
        const auto is_set = [&](std::size_t x) {
            return (bits[x / BitGrid::kWordBits] >> (x % BitGrid::kWordBits) & 1) != 0;
        };
        int distance = cap_;
        for (std::size_t x = 0; x < row_; ++x) {
            distance = is_set(x) ? 0 : std::min(cap_, distance + 1);
            to[x] = static_cast<Square>(distance);
        }
        distance = cap_;
        for (std::size_t x = row_; x-- > 0;) {
            distance = std::min<int>(to[x], std::min(cap_, distance + 1));
            to[x] = static_cast<Square>(distance * distance);
        }
        return true;
    }

    const BitGrid& set_;
    int cap_;
    std::size_t row_, rows_, held_;
    std::vector<Square> squares_;  // of the planes held
    std::vector<char> any_;        // by plane and row: whether some are below the cap
    std::vector<Square> along_;    // of the plane being made: along x alone
    std::vector<char> along_any_;
};

}  // namespace

bool centres_can_tell(const Extent& extent, double reach) {
    if (!(reach < kMostCap)) return false;
    const int cap = cap_for(reach);
    const std::int64_t planes = std::min(2 * cap + 1, extent.z);
    return cap <= kMostCap && planes * extent.x * extent.y <= kMostBytes / static_cast<std::int64_t>(sizeof(Square));
}

ToldByCentres told_by_centres(const BitGrid& entered, double reach, const Workers& workers) {
    const Extent& n = entered.extent();
    const int cap = cap_for(reach);
    const double inside = std::max(0.0, reach - kSlack), outside = reach + std::numbers::sqrt3 + kSlack;
    // Of squares, which are whole numbers: near below the first, far from the second on.
    const auto near_below = static_cast<Square>(std::ceil(inside * inside));
    const auto far_from = static_cast<Square>(std::ceil(outside * outside));
    ToldByCentres told{BitGrid(n), BitGrid(n)};
    workers.for_ranges(n.z, 4 * cap, [&](std::int64_t first, std::int64_t last) {
        const int begin = static_cast<int>(first), end = static_cast<int>(last);
        Planes planes(entered, cap);
        std::vector<Square> row(static_cast<std::size_t>(n.x));
        int made = std::max(0, begin - cap);
        for (int z = begin; z < end; ++z) {
            for (; made <= std::min(n.z - 1, z + cap); ++made) {
                workers.check();
                planes.make(made);
            }
            for (int y = 0; y < n.y; ++y) {
                workers.check();
                std::ranges::fill(row, static_cast<Square>(cap * cap));
                planes.measure(y, z, row);
                BitGrid::Word* const near = told.near.row(y, z);
                BitGrid::Word* const far = told.far.row(y, z);
                for (int x = 0; x < n.x; ++x) {
                    const Square square = row[static_cast<std::size_t>(x)];
                    const int bit = x % BitGrid::kWordBits;
                    near[x / BitGrid::kWordBits] |= BitGrid::Word{square < near_below} << bit;
                    far[x / BitGrid::kWordBits] |= BitGrid::Word{square >= far_from} << bit;
                }
            }
        }
    });
    return told;
}

}  // namespace spectralpack
