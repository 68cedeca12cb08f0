#include "voxel/enclosed.hpp"

#include <cstddef>
#include <vector>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;
constexpr int kTopBit = BitGrid::kWordBits - 1;

/// `seeds` and what they reach downwards within their runs of `free` bits (Kogge-Stone).
Word spread_down(Word seeds, Word free) {
    for (int step = 1; step < BitGrid::kWordBits; step *= 2) {
        seeds |= free & (seeds >> step);
        free &= free >> step;
    }
    return seeds;
}

class Flood {
  public:
    explicit Flood(BitGrid& solid)
        : solid_(solid),
          words_(static_cast<std::size_t>(solid.words_per_row())),
          outside_(solid.extent()),
          queued_(rows(), false),
          queue_(rows()) {}

    void run() {
        seed();
        // First in, first out, so that a row gathers from several neighbours before it spreads on.
        while (waiting_ > 0) {
            const std::size_t row = queue_[first_];
            first_ = first_ + 1 == queue_.size() ? 0 : first_ + 1;
            --waiting_;
            queued_[row] = false;
            visit_neighbours(row);
        }
        for (std::size_t row = 0; row < rows(); ++row) {
            for (std::size_t i = 0; i < words_; ++i) {
                solid(row)[i] = ~outside(row)[i];
            }
            solid(row)[words_ - 1] &= last_mask();
        }
    }

  private:
    std::size_t rows() const {
        return static_cast<std::size_t>(solid_.extent().y) * static_cast<std::size_t>(solid_.extent().z);
    }
    Word* solid(std::size_t row) { return solid_.words().data() + row * words_; }
    Word* outside(std::size_t row) { return outside_.words().data() + row * words_; }
    Word last_mask() const {
        const int used = solid_.extent().x % BitGrid::kWordBits;
        return used == 0 ? ~Word{0} : (Word{1} << used) - 1;
    }
    Word free_word(std::size_t row, std::size_t i) {
        return i + 1 == words_ ? ~solid(row)[i] & last_mask() : ~solid(row)[i];
    }

    /// Everything free on the grid's faces is reached from outside.
    void seed() {
        const int ny = solid_.extent().y, nz = solid_.extent().z;
        std::size_t row = 0;
        for (int z = 0; z < nz; ++z) {
            for (int y = 0; y < ny; ++y, ++row) {
                Word* reached = outside(row);
                if (y == 0 || z == 0 || y == ny - 1 || z == nz - 1) {
                    for (std::size_t i = 0; i < words_; ++i) {
                        reached[i] = free_word(row, i);
                    }
                } else {
                    reached[0] = free_word(row, 0) & 1;
                    const Word last = last_mask() & ~(last_mask() >> 1);
                    reached[words_ - 1] |= free_word(row, words_ - 1) & last;
                    spread(row);
                }
                push(row);
            }
        }
    }

    void push(std::size_t row) {
        if (queued_[row]) return;
        queued_[row] = true;
        const std::size_t last = first_ + waiting_++;
        queue_[last < queue_.size() ? last : last - queue_.size()] = row;
    }

    void visit_neighbours(std::size_t row) {
        const auto ny = static_cast<std::size_t>(solid_.extent().y);
        const std::size_t y = row % ny;
        if (y > 0) flow(row, row - 1);
        if (y + 1 < ny) flow(row, row + 1);
        if (row >= ny) flow(row, row - ny);
        if (row + ny < rows()) flow(row, row + ny);
    }

    /// What is outside in `from` reaches into the row beside it.
    void flow(std::size_t from, std::size_t to) {
        const Word* source = outside(from);
        Word* target = outside(to);
        Word fresh = 0;
        for (std::size_t i = 0; i < words_; ++i) {
            const Word reached = source[i] & free_word(to, i) & ~target[i];
            target[i] |= reached;
            fresh |= reached;
        }
        if (fresh == 0) return;
        spread(to);
        push(to);
    }

    /// Along x: every run of free voxels that holds an outside one becomes outside.
    void spread(std::size_t row) {
        Word* reached = outside(row);
        // Upwards: adding the seeds to the free bits carries from a seed to its run's end, and
        // flips all on the way.
        Word carry = 0;
        for (std::size_t i = 0; i < words_; ++i) {
            const Word free = free_word(row, i);
            Word sum;
            const bool over = __builtin_add_overflow(free, reached[i], &sum);
            const bool more = __builtin_add_overflow(sum, carry, &sum);
            reached[i] = (reached[i] | (sum ^ free)) & free;
            carry = over || more ? 1 : 0;
        }
        Word from_above = 0;
        for (std::size_t i = words_; i-- > 0;) {
            const Word free = free_word(row, i);
            reached[i] = spread_down(reached[i] | (free & (from_above << kTopBit)), free);
            from_above = reached[i] & 1;
        }
    }

    BitGrid& solid_;
    std::size_t words_;  // per row
    BitGrid outside_;
    std::vector<char> queued_;
    std::vector<std::size_t> queue_;  // a ring: no row waits twice
    std::size_t first_ = 0, waiting_ = 0;
};

}  // namespace

void fill_enclosed(BitGrid& grid) {
    if (!grid.extent().empty()) Flood(grid).run();
}

}  // namespace spectralpack
