#include "search/reference/transform.hpp"
#include "core/checked.hpp"

#include <fftw3.h>

#include <algorithm>
#include <mutex>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// FFTW's planner is the one part of it that is not safe to call from two threads.
std::mutex& planner() {
    static std::mutex mutex;
    return mutex;
}

/// The two precisions under one name.
template <class Real>
struct Fftw;

// FFTW's functions by names of ours.
// NOLINTBEGIN(readability-identifier-naming)
template <>
struct Fftw<double> {
    using Complex = fftw_complex;
    using Plan = fftw_plan;
    static constexpr auto allocate = fftw_alloc_real;
    static constexpr auto free = fftw_free;
    static constexpr auto plan_forward = fftw_plan_dft_r2c_3d;
    static constexpr auto plan_inverse = fftw_plan_dft_c2r_3d;
    static constexpr auto forward = fftw_execute_dft_r2c;
    static constexpr auto inverse = fftw_execute_dft_c2r;
    static constexpr auto destroy = fftw_destroy_plan;
};

template <>
struct Fftw<float> {
    using Complex = fftwf_complex;
    using Plan = fftwf_plan;
    static constexpr auto allocate = fftwf_alloc_real;
    static constexpr auto free = fftwf_free;
    static constexpr auto plan_forward = fftwf_plan_dft_r2c_3d;
    static constexpr auto plan_inverse = fftwf_plan_dft_c2r_3d;
    static constexpr auto forward = fftwf_execute_dft_r2c;
    static constexpr auto inverse = fftwf_execute_dft_c2r;
    static constexpr auto destroy = fftwf_destroy_plan;
};
// NOLINTEND(readability-identifier-naming)

template <class Real>
typename Fftw<Real>::Complex* fftw_spectrum(FourierBuffer<Real>& buffer) {
    return reinterpret_cast<typename Fftw<Real>::Complex*>(buffer.spectrum());
}

}  // namespace

int next_smooth(int least) {
    for (int n = std::max(1, least);; ++n) {
        int rest = n;
        for (const int prime : {2, 3, 5, 7}) {
            while (rest % prime == 0) {
                rest /= prime;
            }
        }
        if (rest == 1) return n;
    }
}

Extent transform_extent(const Extent& tray, const VoxelIndex& more) {
    // Of few cells a multiple of 4 would make much more.
    const auto across = [](int least) { return least < 16 ? next_smooth(least) : 4 * next_smooth((least + 3) / 4); };
    return {2 * next_smooth((tray.x + more.x + 1) / 2), across(tray.y + more.y), across(tray.z + more.z)};
}

template <class Real>
FourierBuffer<Real>::FourierBuffer(const Extent& grid)
    : row_length_(grid.x / 2 + 1),
      extent_y_(grid.y),
      spectrum_size_(checked_product({row_length_, grid.y, grid.z})),
      reals_(Fftw<Real>::allocate(static_cast<std::size_t>(checked_product({2, spectrum_size_})))) {
    if (!reals_) throw ResourceError("there is no memory for a transform of the tray");
    clear();
}

template <class Real>
void FourierBuffer<Real>::clear() {
    std::fill_n(reals_.get(), 2 * spectrum_size_, Real{0});
}

template <class Real>
std::int64_t FourierBuffer<Real>::bytes(const Extent& grid) {
    return checked_product({2 * static_cast<std::int64_t>(sizeof(Real)), grid.x / 2 + 1, grid.y, grid.z});
}

template <class Real>
void FourierBuffer<Real>::Free::operator()(Real* reals) const {
    Fftw<Real>::free(reals);
}

template <class Real>
struct FourierPlan<Real>::Plans {
    typename Fftw<Real>::Plan forward = nullptr, inverse = nullptr;

    Plans() = default;
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;
    ~Plans() {
        const std::lock_guard lock(planner());
        if (forward) Fftw<Real>::destroy(forward);
        if (inverse) Fftw<Real>::destroy(inverse);
    }
};

template <class Real>
FourierPlan<Real>::FourierPlan(const Extent& grid, bool measure) : grid_(grid), plans_(std::make_unique<Plans>()) {
    FourierBuffer<Real> buffer(grid);  // measuring overwrites it
    const unsigned flags = measure ? FFTW_MEASURE : FFTW_ESTIMATE;
    Real* values = buffer.row(0, 0);
    const std::lock_guard lock(planner());
    plans_->forward = Fftw<Real>::plan_forward(grid.z, grid.y, grid.x, values, fftw_spectrum(buffer), flags);
    plans_->inverse = Fftw<Real>::plan_inverse(grid.z, grid.y, grid.x, fftw_spectrum(buffer), values, flags);
    if (!plans_->forward || !plans_->inverse) {
        throw ResourceError("FFTW has no plan for a transform of this tray");
    }
}

template <class Real>
FourierPlan<Real>::~FourierPlan() = default;
template <class Real>
FourierPlan<Real>::FourierPlan(FourierPlan&&) noexcept = default;
template <class Real>
FourierPlan<Real>& FourierPlan<Real>::operator=(FourierPlan&&) noexcept = default;

template <class Real>
void FourierPlan<Real>::forward(FourierBuffer<Real>& buffer) const {
    Fftw<Real>::forward(plans_->forward, buffer.row(0, 0), fftw_spectrum(buffer));
}

template <class Real>
void FourierPlan<Real>::inverse(FourierBuffer<Real>& buffer) const {
    Fftw<Real>::inverse(plans_->inverse, fftw_spectrum(buffer), buffer.row(0, 0));
}

template class FourierBuffer<float>;
template class FourierBuffer<double>;
template class FourierPlan<float>;
template class FourierPlan<double>;

}  // namespace spectralpack
