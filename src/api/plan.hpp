#pragma once
/// What a run will do and take, settled before it starts.

#include <memory>
#include <span>
#include <vector>

#include "api/load.hpp"
#include "packing/order/order.hpp"

namespace spectralpack {

/// A job's decisions that follow from its options and parts.
struct Plan {
    std::vector<std::shared_ptr<const std::vector<Mat3>>> orientations;  ///< by part: its set; null where unusable
    std::size_t most_orientations = 0;                                   ///< of a part
    std::vector<std::size_t> roots;   ///< by part: of its orientations, those that none before them turns into
    std::vector<double> gap_classes;  ///< distinct gaps of usable parts, ascending
    double height_penalty = 0;        ///< p
    std::vector<Copy> items;          ///< in the order to try, without what cannot fit
    bool copies = false;              ///< some part has more than one
    std::vector<int> ranks;           ///< by part: urgency_ranks()
    std::vector<std::vector<Vec3>> turned_sizes;  ///< by part: its mesh's in some of its orientations, spread over them
    std::vector<std::string> too_large;           ///< by part: why it fits in no orientation; empty where it fits
    EngineKind engine = EngineKind::cpu;          ///< resolved
    bool reads_all = false;                       ///< voxels of all orientations are asked for
    Vec3 room;                                    ///< for the copies' boxes, mm
    Extent grid;                                  ///< with open height, as high as it starts
    bool walls = false;                           ///< of the container stand where ways out are looked for
    int most_layers = 0;                          ///< open height: as high as memory lets it grow
    std::int64_t memory = 0;              ///< bytes the run takes, meshes included, without what more was allowed
    std::int64_t memory_of_surfaces = 0;  ///< its share for the copies' trees of triangles, whatever the voxel size
    std::int64_t memory_of_copies = 0;    ///< its share for what grows with their number
    std::int64_t memory_limit = 0;
    std::int64_t cache = 0;                 ///< bytes left for caches
    std::int64_t keep = 0;                  ///< bytes of voxels that may be held from one tray to the next
    std::int64_t answers = 0;               ///< bytes of answers about links that improving may keep
    int ahead = 1;                          ///< parts whose voxels are made at a time
    int held() const { return 2 * ahead; }  ///< parts whose voxels are held at once: new ones, and some that wait
    bool keeps_all = false;                 ///< there is memory for the voxels of all parts at once
    double box_ratio = 0, volume_ratio = 0;
    bool overflows = false;  ///< one tray that will hardly hold all
    double placed = 1;       ///< share of the copies that the container has room for, at most
};

/// `options.tray` is the container's size; `own_printers` are named where a part would fit into one. Throws as
/// check_options and orientation_set do.
Plan make_plan(const LoadedJob& loaded, const Container& container, const PackOptions& options,
               std::span<const Printer> own_printers, const Workers& workers);

/// Warns of what so many orientations take, where they are far more than the usual ones.
void warn_of_orientations(const Plan& plan, const PackOptions& options, Listener& listener);

}  // namespace spectralpack
