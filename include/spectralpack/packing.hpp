#pragma once
/// A packing: what the packing file holds (docs/format.md). Values without behaviour. Millimetres, seconds, bytes;
/// the container's lower corner is the origin.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/disassembly.hpp"
#include "spectralpack/geometry.hpp"
#include "spectralpack/improvement.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/orientations.hpp"

namespace spectralpack {

/// A mesh that is not packed: a container or a keep-out.
struct StandingMesh {
    std::string file;     ///< usable from the working directory; relative to the packing file once that is written
    Transform transform;  ///< from the file's own coordinates to the container's; holds the unit
    std::shared_ptr<const Mesh> surface = nullptr;  ///< in the container's coordinates; null where not loaded
};

/// Room that stays empty: a box, or a mesh and its box.
struct KeepOut {
    Box box;
    std::optional<StandingMesh> mesh = {};
};

/// What of a container mesh is filled: its solid, or what it holds inside.
enum class ContainerIs { solid, vessel };

/// A box, or a closed mesh within one. The wall gap holds for keep-outs as for walls.
struct Container {
    Vec3 size;  ///< with open height, z is the height reached
    /// Of a vessel, `surface` is that of what it holds (geometry/vessel.hpp), while the vessel itself is a keep-out.
    std::optional<StandingMesh> mesh = {};
    std::vector<KeepOut> keep_out = {};
    bool physical = false;                ///< walls and keep-outs are really there: nothing leaves through them
    bool open_height = false;             ///< no wall above
    ContainerIs is = ContainerIs::solid;  ///< of a mesh
};

/// What densities are of: of a mesh container, the mesh's; keep-outs are not taken off.
inline double volume_of(const Container& container) {
    if (container.mesh && container.mesh->surface) return signed_volume(*container.mesh->surface);
    return container.size.x * container.size.y * container.size.z;
}

/// One input mesh with a count and its constraints, as the packing file records it. A copy is one instance of it.
struct PackedPart {
    int id = 0;                         ///< position in Packing::parts
    std::string name;                   ///< for people; part number in a 3MF
    std::string mesh;                   ///< path of the mesh file; relative to the packing file once that is written
    std::optional<std::string> object;  ///< 3MF: id of the object in the file
    std::optional<Transform> item_transform;  ///< 3MF: the build item's, in the file's unit
    int count = 1;
    std::vector<int> numbers = {};  ///< by copy, where they are kept from a build that was topped up (CopyNumbers)
    int share = 0;  ///< of a packing filled in shares: the count asked for, while `count` is what came of it; else 0
    double scale = 1;
    double unit = 1;                ///< millimetres per unit of the mesh file
    double gap = 0;                 ///< mm
    PartOrientations orientations;  ///< those it may take
    double priority = 0;            ///< as in Part; likewise the next three
    std::string due = {};
    std::string order = {};
    double value = 1;
    double volume = 0;                 ///< signed volume of one scaled copy, mm^3
    std::vector<std::string> repairs;  ///< what was mended on loading, in words

    /// From the mesh as loaded to millimetres.
    double to_mm() const { return unit * scale; }
};

struct Placement {
    int part = 0;         ///< index into Packing::parts
    int copy = 0;         ///< 0 .. count - 1 of that part
    int orientation = 0;  ///< index in the orientation set
    bool fixed = false;   ///< was not placed by this run, and did not move in it
    Transform transform;  ///< from the mesh file's own coordinates to the container's; holds unit and scale
    /// Of a fixed one: it stood in a build that was topped up, so it comes out like those placed. Others stay for good.
    bool before = false;
};

/// Cross-section area per horizontal layer, mm^2, from the floor up.
struct Layers {
    double thickness = 0;
    std::vector<double> area;
};

struct TrayPacking {
    std::vector<Placement> placements;  ///< in the order they were placed
    double density = 0;                 ///< signed volumes / container volume
    double density_bounding_box = 0;
    Box bounding_box;                          ///< of the placed meshes; empty without placements
    double height = 0;                         ///< top of the bounding box
    std::optional<HeightReference> height_at;  ///< where height counted; none: nothing was packed into it
    Layers layers;
    std::optional<Disassembly> disassembly;  ///< none: interlocking was not looked at
};

/// Copies that stood there before the build was topped up, and that the plan leaves where they are.
inline std::vector<int> staying(const TrayPacking& tray) {
    std::vector<int> staying;
    if (!tray.disassembly) return staying;
    std::vector<bool> leaves(tray.placements.size(), false);
    for (const RemovalStep& step : tray.disassembly->steps) {
        if (step.placements.size() == 1) leaves.at(static_cast<std::size_t>(step.placements.front())) = true;
    }
    for (std::size_t i = 0; i < tray.placements.size(); ++i) {
        if (tray.placements[i].before && !leaves[i]) staying.push_back(static_cast<int>(i));
    }
    return staying;
}

/// Why a copy is left over.
enum class UnplacedReason {
    no_place,      ///< the trays have no free place that it fits into
    too_large,     ///< it is larger than the tray
    cannot_leave,  ///< it was caught in other copies, and there was no place that it comes out of
    bad_file,      ///< its mesh cannot be used
    not_tried,     ///< the run ended before
    cap,           ///< --max-density or --max-layer-fill was reached
};

/// The one wording for people: terminal, page and sheet.
inline const char* in_words(UnplacedReason reason) {
    switch (reason) {
        case UnplacedReason::no_place:
            return "no free place left";
        case UnplacedReason::too_large:
            return "larger than the tray";
        case UnplacedReason::cannot_leave:
            return "cannot leave";
        case UnplacedReason::bad_file:
            return "file cannot be used";
        case UnplacedReason::not_tried:
            return "not tried";
        case UnplacedReason::cap:
            return "cap reached";
    }
    return "";
}

struct Unplaced {
    int part = 0;
    int copy = 0;
    UnplacedReason reason = UnplacedReason::no_place;
    std::string detail;
};

struct PhaseSeconds {
    double total = 0, load = 0, voxelize = 0, search = 0, refine = 0, disassemble = 0, reinsert = 0;
};

struct Metrics {
    std::int64_t copies = 0;
    std::int64_t placed = 0;
    double density = 0;             ///< over all trays
    std::optional<double> min_gap;  ///< measured, mm; none where it was not measured
    PhaseSeconds seconds;
    std::optional<InterlockCounts> interlock;  ///< over all trays; none where interlocking was not looked at
    std::int64_t searches = 0;                 ///< copies searched for, skipped copies not counted
    std::int64_t verified = 0;                 ///< placements answered alike by the verifying engine
    int orders = 1;                            ///< packed in, of which the best was kept
    std::optional<Improved> improvement;       ///< none where none was asked for
    std::int64_t peak_memory = 0;
    std::string engine;
    int threads = 0;
};

/// A file of defaults, and the options that were taken from it.
struct SettingsSource {
    std::string file;
    std::string profile = {};  ///< of the file; empty: what holds without one
    std::vector<std::string> options = {};

    bool operator==(const SettingsSource&) const = default;
};

struct Packing {
    std::string program;     ///< "spectralpack 0.2.0"
    std::string input_hash;  ///< of meshes, counts and options: equal inputs, equal placements
    Container container;
    PackOptions options;
    std::vector<SettingsSource> defaults;  ///< where options came from that neither command line nor job file said
    std::vector<PackedPart> parts;
    std::vector<TrayPacking> trays;
    std::vector<Unplaced> unplaced;
    Metrics metrics;
};

/// What the plans of all trays come to.
struct PlansOverview {
    bool planned = true;   ///< every tray has a plan
    bool complete = true;  ///< that takes out all copies
    std::size_t steps = 0;
    std::size_t through_walls = 0;  ///< of the steps (Disassembly::through_walls)
    std::size_t staying = 0;        ///< copies that stood there before and that no step takes out
};

inline PlansOverview plans_of(const Packing& packing) {
    PlansOverview plans;
    for (const TrayPacking& tray : packing.trays) {
        plans.planned = plans.planned && tray.disassembly;
        plans.complete = plans.complete && tray.disassembly && tray.disassembly->complete;
        plans.steps += tray.disassembly ? tray.disassembly->steps.size() : 0;
        plans.through_walls += tray.disassembly ? tray.disassembly->through_walls.size() : 0;
        plans.staying += staying(tray).size();
    }
    return plans;
}

/// Copies are numbered 1, 2, 3 ... through the whole build in the order of the part list, the copies of a part one
/// after the other. Those left over keep theirs. In a build that was topped up, copies that stood there before keep the
/// numbers they had, and new ones go on after the highest. Files, pictures, plans and sheets say this number.
class CopyNumbers {
  public:
    explicit CopyNumbers(const std::vector<PackedPart>& parts) {
        int next = 1;
        for (const PackedPart& part : parts) {
            parts_.push_back({next, part.numbers});
            if (part.numbers.empty()) next += part.count;
            for (const int number : part.numbers) {
                next = std::max(next, number + 1);
            }
        }
    }

    int of(int part, int copy) const {
        const Numbers& numbers = parts_.at(static_cast<std::size_t>(part));
        const auto i = static_cast<std::size_t>(copy);
        return i < numbers.kept.size() ? numbers.kept[i] : numbers.first + copy;
    }
    int of(const Placement& placement) const { return of(placement.part, placement.copy); }

  private:
    struct Numbers {
        int first = 1;
        std::vector<int> kept;
    };
    std::vector<Numbers> parts_;
};

/// Meshes of a packing's parts by part index, in the mesh file's own coordinates. Null for unusable parts.
using PartMeshes = std::vector<std::shared_ptr<const Mesh>>;

/// A packing with the meshes it places.
struct Scene {
    Packing packing;
    PartMeshes meshes;  ///< by part; null for parts without placements
};

}  // namespace spectralpack
