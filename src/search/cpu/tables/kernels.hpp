#pragma once
/// Loops over rows of distances and bits, compiled for every instruction set and chosen at run time (Highway).

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace spectralpack {

/// Which elements of a row changed: none where end is 0.
struct RowChange {
    std::size_t begin = 0, end = 0;
};

/// What keeps sums in elements T, 16 bits or bytes, right; all arithmetic is modulo what a T holds.
template <class T>
struct SumKernels {
    /// out[i] = a[i] + b[i], i in [0, count), for `rows` rows one after the other, `step` from one of out and of a to
    /// the next, `b_step` of b: what is written to a row of out may be what the next row reads of a. Steps may be
    /// negative.
    void (*add_rows)(T* out, const T* a, const T* b, std::size_t rows, std::ptrdiff_t step, std::ptrdiff_t b_step,
                     std::size_t count);
    /// Likewise out[i] = a[i] - b[i].
    void (*subtract_rows)(T* out, const T* a, const T* b, std::size_t rows, std::ptrdiff_t step, std::ptrdiff_t b_step,
                          std::size_t count);
    /// out[i] = min(from[i] + floor, most), where that is no overflow.
    void (*raise_row)(T* out, const std::uint16_t* from, std::uint16_t floor, std::uint16_t most, std::size_t count);
    /// The least of every four neighbours, dealt out to four rows: out[k stride + i] = min(from[4 i + k + {0, 1, 2,
    /// 3}]) + floor, at most `most`, for i in [0, count). Reads up to from[4 count + 3].
    void (*deal_least_of_four)(T* out, std::size_t stride, const std::uint16_t* from, std::uint16_t floor,
                               std::uint16_t most, std::size_t count);
    /// out[i + 1] = out[i] + from[i], i from 0 up.
    void (*prefix_sums)(T* out, const T* from, std::size_t count);
    /// The same of a row dealt out to four (element 4 i + k at k stride + i), for i in [0, count), from out[0] on.
    /// Returns the sum of all: what comes next.
    T (*prefix_sums_dealt)(T* out, const T* from, std::size_t stride, std::size_t count);
};

struct Kernels {
    /// row[i] = min(row[i], from[i] + 1) for i in [0, count). The least range of what changed.
    RowChange (*lower_row)(std::uint16_t* row, const std::uint16_t* from, std::size_t count);
    /// out[i] = min(a[i], b[i]); out may be a.
    void (*min_rows)(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count);
    /// out[i] = the least of rows[k][i] - floor, the difference modulo 2^16.
    void (*min_of_four)(std::uint16_t* out, const std::uint16_t* const (&rows)[4], std::uint16_t floor,
                        std::size_t count);
    /// Greatest of row[0..count), 0 for none.
    std::uint16_t (*max_of_row)(const std::uint16_t* row, std::size_t count);
    /// out[i] &= from[i].
    void (*and_rows)(std::uint64_t* out, const std::uint64_t* from, std::size_t count);
    /// out[i] = a[i] | b[i]; out is neither.
    void (*or_rows)(std::uint64_t* out, const std::uint64_t* a, const std::uint64_t* b, std::size_t count);
    /// out[i] = a[i] | what lies `by` bits above the lowest of the pair low[i], high[i]; 0 < by < 64. out is none of
    /// them.
    void (*or_moved_down)(std::uint64_t* out, const std::uint64_t* a, const std::uint64_t* low,
                          const std::uint64_t* high, int by, std::size_t count);
    SumKernels<std::uint16_t> of_words;
    SumKernels<std::uint8_t> of_bytes;

    template <class T>
    const SumKernels<T>& sums() const {
        if constexpr (std::is_same_v<T, std::uint8_t>) {
            return of_bytes;
        } else {
            return of_words;
        }
    }
};

/// Those of the instruction set that was chosen.
const Kernels& kernels();

/// Names of the instruction sets that are compiled in and that this machine has, the best first.
std::vector<std::string> instruction_sets();

/// For tests: everything runs on this one from now on; empty: on the best. For one thread at a
/// time, while no search runs.
void use_instruction_set(const std::string& name);

}  // namespace spectralpack
