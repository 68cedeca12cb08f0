#pragma once
/// How far a correlation computed by Fourier transforms can be from the integer that it is.

#include "spectralpack/grid.hpp"

namespace spectralpack {

/// Upper bound on |computed - exact| at every cell for the sum over g of corr(a_g, b_g), computed
/// as one inverse transform of the sum over g of conj(F a_g) F b_g on `grid`, of 7-smooth lengths.
///   norms: sum over g of ||a_g|| ||b_g|| (2-norms)
///   terms: how many g
///   unit_roundoff: 2^-53 in double precision, 2^-24 in single
/// Below 0.5, rounding gives the exact integer.
///
/// Derivation, with M cells, u the unit roundoff, F the transform without scaling:
///
/// 1. A transform of lengths made of 2, 3, 5 and 7 is a product of butterfly stages whose radices r
///    multiply to M. A butterfly summed directly in complex arithmetic, twiddle factors included,
///    errs in each output by at most c u times the sum of its inputs' moduli, and in the 2-norm by
///    at most c u relative to it, with c = sqrt(2 r) (r + 1) + 4: 10, 14, 23, 34 for the four
///    radices, below 16 log2 r = 16, 25, 37, 44. FFTW's larger butterflies are made of these with
///    fewer operations. Packing reals into complex numbers counts as one more stage of radix 2.
///    To first order stages add up: e = 16 u (log2 M + 1). (After Gentleman and Sande 1966, and
///    Higham, Accuracy and Stability of Numerical Algorithms, theorem 24.2.)
/// 2. Forward: ||computed F a - F a|| <= e sqrt(M) ||a||.
/// 3. A product errs by at most 3 u, relatively; summing adds another u for each term.
/// 4. Inverse: each spectral value p_k reaches each cell along one path, by a weight of modulus 1.
///    So the stages err at a cell by at most e (1/M) sum |p_k|; scaling by 1/M adds 2 u.
/// 5. By Cauchy-Schwarz and Parseval (1/M) sum |conj(F a) F b| <= ||a|| ||b||, and step 2's errors
///    reach a cell likewise. Together, to first order: (3 e + (5 + terms) u) norms. The fourth e,
///    at least 16 u, pays for the 5 u and for higher orders.
double correlation_error_bound(const Extent& grid, double norms, int terms, double unit_roundoff);

}  // namespace spectralpack
