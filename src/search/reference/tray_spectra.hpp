#pragma once
/// What a search needs of the tray in the spectral domain (Algorithm 1, the lines before its loop).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "search/reference/transform.hpp"
#include "search/tray.hpp"

namespace spectralpack {

/// A transformed grid and the 2-norm of its values.
template <class Real>
struct TraySpectrum {
    FourierBuffer<Real> buffer;
    double norm = 0;
};

/// Equation (2)'s s_Omega, apart by what it is tested with (gap class and part of the fine voxels), and equation (3)'s
/// phi.
template <class Real>
class TraySpectra {
  public:
    /// Makes everything anew unless it is of this very tray and version. Other plans need a fresh
    /// object. Calls workers.check() between transforms; where that throws, the next call begins anew.
    void update(const Tray& tray, const FourierPlan<Real>& plan, const Workers& workers);

    std::size_t classes() const { return objects_.size() / parts_; }
    std::size_t parts() const { return parts_; }
    /// A part of the objects of a gap class; null: there is nothing.
    const TraySpectrum<Real>* objects(std::size_t gap_class, std::size_t part) const {
        const auto& spectrum = objects_[gap_class * parts_ + part];
        return spectrum ? &*spectrum : nullptr;
    }
    /// Container mask and keep-out; null: all is free.
    const TraySpectrum<Real>* walls() const { return walls_ ? &*walls_ : nullptr; }
    const TraySpectrum<Real>& phi_spectrum() const { return *phi_spectrum_; }
    const Grid<std::int32_t>& phi() const { return phi_; }

    std::int64_t bytes(const Extent& grid) const;

  private:
    std::uint64_t instance_ = 0, version_ = 0;  ///< 0 is no tray's instance
    Grid<std::int32_t> phi_;
    std::optional<TraySpectrum<Real>> phi_spectrum_, walls_;
    std::size_t parts_ = 1;
    std::vector<std::optional<TraySpectrum<Real>>> objects_;  ///< by gap class and part
};

extern template class TraySpectra<float>;
extern template class TraySpectra<double>;

}  // namespace spectralpack
