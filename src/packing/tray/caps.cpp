#include "packing/tray/caps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "packing/tray/measure.hpp"

namespace spectralpack {
namespace {

constexpr double kRounding = 1e-9;  // of the cap
constexpr double kNear = 1e-6;      // mm

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g %%", 100 * share);
    return text;
}

}  // namespace

Caps::Caps(const CapOptions& options, CapParts parts) : options_(options), parts_(std::move(parts)) {}

double Caps::most(std::size_t k) const {
    const std::vector<double>& sections = options_.sections;
    const double section = sections.empty() ? options_.base : k < sections.size() ? sections[k] : 0;
    return *options_.layer_fill * section * (1 + kRounding);
}

std::string Caps::why_not(int part) const {
    if (!options_.density) return "";
    const double density = (volume_ + parts_.volume(part)) / options_.volume;
    if (density <= *options_.density * (1 + kRounding)) return "";
    return "the tray would be " + percent(density) + " full, beyond the cap of " + percent(*options_.density);
}

std::vector<double> Caps::sections(int part, int orientation, const Vec3& offset) const {
    return section_areas(transformed(parts_.turned_mesh(part, orientation), {Mat3{}, offset}), options_.voxel_size);
}

const std::vector<double>& Caps::profile(int part, int orientation, const Vec3& corner) {
    const auto [entry, fresh] = profiles_.try_emplace({part, orientation});
    if (fresh) {
        // A plane that meets a flat side may fall to either side of it, as rounding will have it in other layers.
        const double z = options_.wall_gap - corner.z;
        entry->second = sections(part, orientation, {0, 0, z + kNear});
        const std::vector<double> lower = sections(part, orientation, {0, 0, z - kNear});
        for (std::size_t k = 0; k < lower.size(); ++k) {
            entry->second[k] = std::max(entry->second[k], lower[k]);
        }
    }
    return entry->second;
}

const AllowedLayers* Caps::allowed(int part, const Shape& shape, int layers) {
    if (!options_.layer_fill) return nullptr;
    allowed_.by_index.clear();
    for (const OrientedShape& oriented : shape.orientations) {
        const std::vector<double>& areas = profile(part, oriented.orientation, oriented.corner);
        std::vector<bool>& open = allowed_.by_index.emplace_back(static_cast<std::size_t>(layers), true);
        for (std::size_t z = 0; z < open.size(); ++z) {
            for (std::size_t k = 0; k < areas.size() && open[z]; ++k) {
                const double there = z + k < area_.size() ? area_[z + k] : 0;
                open[z] = there + areas[k] <= most(z + k);
            }
        }
    }
    return &allowed_;
}

bool Caps::may_stand(int part, int orientation, const Vec3& offset) const {
    if (!options_.layer_fill) return true;
    const std::vector<double> areas = sections(part, orientation, offset);
    for (std::size_t k = 0; k < areas.size(); ++k) {
        if ((k < area_.size() ? area_[k] : 0) + areas[k] > most(k)) return false;
    }
    return true;
}

void Caps::add(int part, int orientation, const Vec3& offset) { count(1, part, orientation, offset); }

void Caps::remove(int part, int orientation, const Vec3& offset) { count(-1, part, orientation, offset); }

void Caps::count(int copies, int part, int orientation, const Vec3& offset) {
    volume_ += copies * parts_.volume(part);
    if (options_.layer_fill) add_areas(copies, sections(part, orientation, offset));
}

void Caps::add_fixed(const Mesh& mesh) {
    volume_ += signed_volume(mesh);
    if (options_.layer_fill) add_areas(1, section_areas(mesh, options_.voxel_size));
}

void Caps::add_areas(int times, const std::vector<double>& areas) {
    if (area_.size() < areas.size()) area_.resize(areas.size(), 0);
    for (std::size_t k = 0; k < areas.size(); ++k) {
        area_[k] += times * areas[k];
    }
}

std::string Caps::no_layer_left() const {
    if (!options_.layer_fill) return "";
    return "no place is free that keeps every layer below the cap of " + percent(*options_.layer_fill);
}

}  // namespace spectralpack
