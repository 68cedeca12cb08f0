#pragma once
/// A job as packing sees it: parts, copies in the order to try, and how trays are filled. Nothing of it changes while
/// strategies pack it, once or many times.

#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "packing/job/trays.hpp"
#include "packing/order/packing_score.hpp"

namespace spectralpack {

struct JobPart {
    std::shared_ptr<const Mesh> mesh;                       ///< in the file's own coordinates; null where unusable
    double to_mm = 1;                                       ///< from those to millimetres
    double gap = 0;                                         ///< mm; one of the tray's gap classes
    std::shared_ptr<const std::vector<Mat3>> orientations;  ///< its set; null where unusable
    double volume = 0;                                      ///< signed, of one scaled copy, mm^3
    double box_volume = 0;                                  ///< of the scaled mesh's box in file orientation, mm^3
    int count = 0;                                          ///< copies, or the share of them
    double value = 1;                                       ///< what a copy is worth

    /// Its mesh in millimetres, not turned.
    ScaledPart scaled() const;
    /// From the file's own coordinates to where the copy stands.
    Transform transform_of(const PlacedCopy& placed) const;
};

struct PackingJob {
    std::vector<JobPart> parts;
    std::vector<Copy> copies;  ///< in the order to try, without what cannot fit
    std::vector<int> ranks;    ///< by part: urgency_ranks()
    FillOptions fill;          ///< how trays are filled
    TraysLimit limit;
    bool choose_heights = false;  ///< height counts at the top in trays that hold all that is left: HeightChoice
    /// One tray is filled with as many copies as fit, in shares (pack_in_shares()), whatever `copies` says of numbers.
    bool in_shares = false;
    Vec3 room;                 ///< for the copies' boxes, mm: as make_shape() has it
    std::int64_t keep = 0;     ///< bytes of voxels that may be held from one tray to the next
    std::int64_t answers = 0;  ///< bytes that answers about links may take while a packing is improved
    int ahead = 1;             ///< parts whose voxels are made at a time
    int held = 1;              ///< parts whose voxels are held at once
    bool keeps_all = false;    ///< there is room for the voxels of all parts at once
    /// Placements that a second engine has answered alike so far; null: none looks at them.
    std::function<std::int64_t()> verified;
};

/// Sides of a base, in voxels.
struct BaseSize {
    int x = 0, y = 0;

    auto operator<=>(const BaseSize&) const = default;
};

/// What a strategy makes of a job.
struct PackedJob {
    TraysResult trays;             ///< where several packings were made, the one kept, with the searches of all
    int orders = 1;                ///< packed in, of which the best was kept
    std::vector<Copy> copies;      ///< the job's, in the order packed in last; empty: in the job's
    std::optional<BaseSize> base;  ///< of the tray, where it was searched for
    std::optional<Improved> improvement;
};

/// What packings of the job in different orders are compared by: volumes and heights of the true meshes, mm. Refers to
/// `parts`; not for several threads at once.
PackingMeasures measures_of(const std::vector<JobPart>& parts);

}  // namespace spectralpack
