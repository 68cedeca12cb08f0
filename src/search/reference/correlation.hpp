#pragma once
/// Correlations of voxel grids in the spectral domain (equations 2 and 4; section 3.1).

#include <bit>
#include <cmath>
#include <complex>

#include "search/reference/transform.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// `index` modulo `length`, in [0, length).
inline int wrapped(int index, int length) { return ((index % length) + length) % length; }

/// Calls visit(x) for every set bit of a row, by ascending x.
template <class Visit>
void for_each_bit(const BitGrid::Word* row, int words, const Visit& visit) {
    for (int i = 0; i < words; ++i) {
        for (BitGrid::Word word = row[i]; word != 0; word &= word - 1) {
            visit(i * BitGrid::kWordBits + std::countr_zero(word));
        }
    }
}

/// 2-norm of s, the indicator function of `bits`.
inline double norm_of_bits(const BitGrid& bits) { return std::sqrt(static_cast<double>(bits.count())); }

/// FFT(s) of `bits` with their voxel 0 at `at`, modulo the plan's grid. A grid shorter than `bits`
/// holds sums, which is what a circular correlation means.
template <class Real>
void put_spectrum(FourierBuffer<Real>& buffer, const FourierPlan<Real>& plan, const BitGrid& bits,
                  const VoxelIndex& at) {
    buffer.clear();
    const Extent& grid = plan.grid();
    const Extent& e = bits.extent();
    for (int z = 0; z < e.z; ++z) {
        for (int y = 0; y < e.y; ++y) {
            Real* row = buffer.row(wrapped(y + at.y, grid.y), wrapped(z + at.z, grid.z));
            for_each_bit(bits.row(y, z), bits.words_per_row(), [&](int x) { row[wrapped(x + at.x, grid.x)] += 1; });
        }
    }
    plan.forward(buffer);
}

/// sum += conj(a) * omega, spectrum by spectrum: the correlation's, before the inverse transform.
/// By hand, as std::complex's product looks for infinities.
template <class Real>
void add_correlation(FourierBuffer<Real>& sum, const FourierBuffer<Real>& a, const FourierBuffer<Real>& omega) {
    std::complex<Real>* s = sum.spectrum();
    const std::complex<Real>*p = a.spectrum(), *q = omega.spectrum();
    for (std::int64_t i = 0; i < sum.spectrum_size(); ++i) {
        const Real re = p[i].real() * q[i].real() + p[i].imag() * q[i].imag();
        const Real im = p[i].real() * q[i].imag() - p[i].imag() * q[i].real();
        s[i] = {s[i].real() + re, s[i].imag() + im};
    }
}

}  // namespace spectralpack
