#pragma once
/// Caps on how full a tray may become, because powder processes have them: on the density, and on the share of each
/// layer's area that is molten.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "packing/order/order.hpp"
#include "search/placement_search.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack {

struct CapOptions {
    std::optional<double> density;     ///< share of the container's volume
    std::optional<double> layer_fill;  ///< share of the container's cross-section, in each layer
    double volume = 0;                 ///< the container's, mm^3; of no interest without a cap on density
    double base = 0;                   ///< of a box: its cross-section in every layer, mm^2
    std::vector<double> sections;      ///< of a container mesh, by layer, mm^2; above there is none. Empty: a box
    double wall_gap = 0;               ///< mm; the grid starts so high
    double voxel_size = 2;             ///< also the thickness of a layer, as in measure_tray()
};

/// The part's volume (signed, mm^3), and its mesh in mm turned into orientation `orientation` of its set.
struct CapParts {
    std::function<double(int part)> volume;
    std::function<Mesh(int part, int orientation)> turned_mesh;
};

/// What stands in one tray, and what may join it. A layer is capped by the cross-section half way up of the true
/// meshes, on the grid: where a copy may stand depends on its orientation and layer alone (AllowedLayers).
class Caps {
  public:
    Caps(const CapOptions& options, CapParts parts);

    /// Why a copy of the part can have no place under the cap on density; empty where it may.
    std::string why_not(int part) const;

    /// The layers that the cap on layers leaves to each orientation of `shape`, in a grid of `layers` layers. Null
    /// without such a cap. Valid until the next call.
    const AllowedLayers* allowed(int part, const Shape& shape, int layers);

    /// True where a copy moved off the grid keeps the cap on layers too. `offset`: of the turned mesh, mm.
    bool may_stand(int part, int orientation, const Vec3& offset) const;

    /// What stands in the tray besides copies that are packed. `mesh`: where it stands, mm.
    void add_fixed(const Mesh& mesh);

    /// A copy stands there now.
    void add(int part, int orientation, const Vec3& offset);

    /// The copy that stood there is gone.
    void remove(int part, int orientation, const Vec3& offset);

    /// For a copy that found no place in the layers left to it; empty without that cap.
    std::string no_layer_left() const;

  private:
    void count(int copies, int part, int orientation, const Vec3& offset);
    void add_areas(int times, const std::vector<double>& areas);
    /// Of layer `k`, the area that may be filled, mm^2.
    double most(std::size_t k) const;
    const std::vector<double>& profile(int part, int orientation, const Vec3& corner);
    std::vector<double> sections(int part, int orientation, const Vec3& offset) const;

    CapOptions options_;
    CapParts parts_;
    double volume_ = 0;                                            // placed
    std::vector<double> area_;                                     // by layer, placed
    std::map<std::pair<int, int>, std::vector<double>> profiles_;  // by part and orientation, in layer 0
    AllowedLayers allowed_;
};

}  // namespace spectralpack
