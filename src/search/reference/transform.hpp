#pragma once
/// Real three-dimensional Fourier transforms in place. FFTW is seen in transform.cpp only.

#include <complex>
#include <cstdint>
#include <memory>

#include "spectralpack/grid.hpp"

namespace spectralpack {

/// The least n >= `least` whose prime factors are 2, 3, 5 and 7: FFTW transforms such lengths fast,
/// and correlation_error_bound() holds for them.
int next_smooth(int least);

/// Extent of a transform of `tray` with at least `more` empty cells beyond it along each axis: smooth lengths; even
/// along x, because transforms of real values take half as long again where rows are odd; from 16 on multiples of 4
/// along y and z, where 128 takes two thirds of the time of 125.
Extent transform_extent(const Extent& tray, const VoxelIndex& more);

/// Room for one transform of a grid: either its values (x fastest, each row padded to 2 (nx/2 + 1)
/// reals) or the half of its spectrum that tells the rest (nx/2 + 1 complex numbers a row). Zero
/// when made.
template <class Real>
class FourierBuffer {
  public:
    explicit FourierBuffer(const Extent& grid);

    Real* row(int y, int z) { return reals_.get() + 2 * row_length_ * (static_cast<std::int64_t>(z) * extent_y_ + y); }
    std::complex<Real>* spectrum() { return reinterpret_cast<std::complex<Real>*>(reals_.get()); }
    const std::complex<Real>* spectrum() const { return reinterpret_cast<const std::complex<Real>*>(reals_.get()); }
    std::int64_t spectrum_size() const { return spectrum_size_; }
    void clear();

    static std::int64_t bytes(const Extent& grid);

  private:
    struct Free {
        void operator()(Real* reals) const;
    };
    std::int64_t row_length_;  // complex numbers
    std::int64_t extent_y_;
    std::int64_t spectrum_size_;
    std::unique_ptr<Real[], Free> reals_;
};

/// The plans for one grid. Transforms of different buffers may run at the same time.
template <class Real>
class FourierPlan {
  public:
    /// `measure`: let FFTW time its ways first (seconds), else it guesses.
    /// Throws ResourceError when there is no memory.
    FourierPlan(const Extent& grid, bool measure);
    ~FourierPlan();
    FourierPlan(FourierPlan&&) noexcept;
    FourierPlan& operator=(FourierPlan&&) noexcept;

    const Extent& grid() const { return grid_; }
    void forward(FourierBuffer<Real>& buffer) const;  ///< values to spectrum
    void inverse(FourierBuffer<Real>& buffer) const;  ///< spectrum to values times grid().count()

  private:
    struct Plans;
    Extent grid_;
    std::unique_ptr<Plans> plans_;
};

extern template class FourierBuffer<float>;
extern template class FourierBuffer<double>;
extern template class FourierPlan<float>;
extern template class FourierPlan<double>;

}  // namespace spectralpack
