#include "search/reference/tray_spectra.hpp"

#include <cmath>

#include "search/reference/correlation.hpp"
#include "voxel/distance_field.hpp"

namespace spectralpack {
namespace {

template <class Real>
TraySpectrum<Real> spectrum_of(const BitGrid& bits, const FourierPlan<Real>& plan) {
    TraySpectrum<Real> spectrum{FourierBuffer<Real>(plan.grid()), norm_of_bits(bits)};
    put_spectrum(spectrum.buffer, plan, bits, {});
    return spectrum;
}

template <class Real>
TraySpectrum<Real> spectrum_of(const Grid<std::int32_t>& phi, const FourierPlan<Real>& plan) {
    TraySpectrum<Real> spectrum{FourierBuffer<Real>(plan.grid()), 0};
    const Extent& n = phi.extent();
    double squares = 0;
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            Real* row = spectrum.buffer.row(y, z);
            for (int x = 0; x < n.x; ++x) {
                const double distance = phi.at(x, y, z);
                row[x] = static_cast<Real>(distance);
                squares += distance * distance;
            }
        }
    }
    spectrum.norm = std::sqrt(squares);
    plan.forward(spectrum.buffer);
    return spectrum;
}

}  // namespace

template <class Real>
void TraySpectra<Real>::update(const Tray& tray, const FourierPlan<Real>& plan, const Workers& workers) {
    if (instance_ == tray.instance() && version_ == tray.version()) return;
    *this = {};  // frees first, so that the peak is one set of spectra
    if (!tray.blocked().none()) walls_ = spectrum_of(tray.blocked(), plan);
    const int parts = part_count(tray.detail());
    parts_ = static_cast<std::size_t>(parts);
    for (int c = 0; c < tray.gap_classes(); ++c) {
        for (int part = 0; part < parts; ++part) {
            const BitGrid& occupied = tray.occupied_part(c, part);
            workers.check();
            objects_.emplace_back();
            if (!occupied.none()) objects_.back() = spectrum_of(occupied, plan);
        }
    }
    workers.check();
    phi_ = manhattan_distance(tray.omega_place(), tray.setup().ceiling);  // Equation (3)
    workers.check();
    phi_spectrum_ = spectrum_of(phi_, plan);
    instance_ = tray.instance();
    version_ = tray.version();
}

template <class Real>
std::int64_t TraySpectra<Real>::bytes(const Extent& grid) const {
    std::int64_t buffers = (phi_spectrum_ ? 1 : 0) + (walls_ ? 1 : 0);
    for (const auto& spectrum : objects_) {
        buffers += spectrum ? 1 : 0;
    }
    return buffers * FourierBuffer<Real>::bytes(grid) +
           static_cast<std::int64_t>(phi_.values().size() * sizeof(std::int32_t));
}

template class TraySpectra<float>;
template class TraySpectra<double>;

}  // namespace spectralpack
