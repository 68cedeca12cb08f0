#include "spectralpack/plan.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "api/check_options.hpp"
#include "api/engine_factory.hpp"
#include "api/plan.hpp"
#include "disassembly/unpacking.hpp"
#include "geometry/mesh_edges.hpp"
#include "model/physical_surfaces.hpp"
#include "packing/containers/physical_walls.hpp"
#include "spectralpack/error.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

/// A grid that holds every copy, in step with the one that the packing was made on.
TraySetup grid_around(const Box& copies, double voxel, double wall_gap, Vec3& corner) {
    TraySetup setup;
    setup.voxel_size = voxel;
    for (int axis = 0; axis < 3; ++axis) {
        // A voxel to spare: standing off the grid, a copy may meet one more.
        corner[axis] = wall_gap + voxel * (std::floor((copies.min[axis] - wall_gap) / voxel) - 1);
        setup.size[axis] = voxel * (std::ceil((copies.max[axis] - corner[axis]) / voxel) + 1);
    }
    return setup;
}

/// One tray's copies as they stand.
class StandingTray {
  public:
    /// `walls`: those of the container stand, too.
    StandingTray(const TrayPacking& tray, const PartMeshes& meshes, const Container& container, bool walls,
                 double voxel, double ray_spacing, double wall_gap, const Workers& workers)
        : tray_(tray), meshes_(meshes), voxel_(voxel), workers_(workers), parts_(tray.placements.size()) {
        make_surfaces();
        Box box;
        for (const Body& part : parts_) {
            box.add(part.box());
        }
        if (walls) box.add({{}, container.size});
        setup_.grid = grid_around(box, voxel, wall_gap, setup_.corner);
        workers.for_each(static_cast<std::int64_t>(parts_.size()), [&](std::int64_t k) {
            const auto i = static_cast<std::size_t>(k);
            StandingVoxels voxels = voxelize_at(turned(i), parts_[i].box().min - setup_.corner, voxel_,
                                                closed_.at(tray_.placements[i].part), workers_);
            parts_[i].object = {std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position, 0,
                                tray_.placements[i].fixed};
        });
        if (walls) parts_.push_back(standing_walls(container, setup_.grid, setup_.corner, workers));
        setup_.ray_spacing = ray_spacing;
        setup_.on_grid = [this](int i) {
            return std::make_shared<const BitGrid>(voxelize(turned(static_cast<std::size_t>(i)), voxel_, workers_));
        };
        setup_.workers = workers;
    }

    /// The copies, then the walls.
    const std::vector<Body>& parts() const { return parts_; }
    DisassemblyOptions& setup() { return setup_; }

  private:
    const Mesh& mesh(std::size_t i) const { return *meshes_[static_cast<std::size_t>(tray_.placements[i].part)]; }
    Mesh turned(std::size_t i) const { return transformed(mesh(i), {tray_.placements[i].transform.linear, {}}); }

    /// Copies of a part in one orientation share a surface.
    void make_surfaces() {
        std::vector<std::vector<std::size_t>> alike;      // indices of copies
        std::map<int, std::vector<std::size_t>> of_part;  // indices into `alike`
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Placement& placement = tray_.placements[i];
            std::vector<std::size_t>& known = of_part[placement.part];
            std::size_t k = 0;
            while (k < known.size() &&
                   !(tray_.placements[alike[known[k]].front()].transform.linear == placement.transform.linear)) {
                ++k;
            }
            if (k == known.size()) {
                known.push_back(alike.size());
                alike.emplace_back();
            }
            alike[known[k]].push_back(i);
        }
        for (const auto& [part, turns] : of_part) {
            closed_[part] = is_closed(mesh(alike[turns.front()].front()));
        }
        workers_.for_each(static_cast<std::int64_t>(alike.size()), [&](std::int64_t k) {
            const std::vector<std::size_t>& copies = alike[static_cast<std::size_t>(k)];
            const auto surface = std::make_shared<const Bvh>(turned(copies.front()));
            for (const std::size_t i : copies) {
                parts_[i].surface = surface;
                parts_[i].offset = tray_.placements[i].transform.translation;
            }
        });
    }

    const TrayPacking& tray_;
    const PartMeshes& meshes_;
    double voxel_;
    Workers workers_;
    std::vector<Body> parts_;
    std::map<int, bool> closed_;  // whether a part's mesh encloses a solid, which takes as long as voxelising it
    DisassemblyOptions setup_;
};

/// A tray as it is to be taken apart.
struct PlanSetup {
    const DisassemblyOptions& options;
    std::vector<Body> bodies;  ///< the copies, then walls
    std::size_t copies;
    bool physical;                         ///< the walls never give way
    Unpack unpack;                         ///< top: with walls
    const std::vector<RemovalStep>* told;  ///< steps that are tried where no others are found; null: none
    Disassembler::Left left;
};

/// `interlocked` names the sets that hold each other, of copies alone.
Disassembly plan_disassembly(const PlanSetup& setup) {
    std::vector<Body> standing = setup.bodies;
    if (!setup.physical) standing.resize(setup.copies);
    Disassembler disassembler(setup.options, std::move(standing), setup.left, {.told = setup.told});
    disassembler.run();
    Disassembly plan;
    plan.steps = disassembler.steps();
    if (!setup.options.stop.stopped()) plan.interlocked = disassembler.stuck();
    for (std::vector<int>& set : plan.interlocked) {
        std::erase_if(set, [&](int body) { return static_cast<std::size_t>(body) >= setup.copies; });
    }
    plan.complete = disassembler.standing() == 0;
    Unpacking unpacking{.unpack = setup.unpack};
    if (!setup.physical && setup.bodies.size() > setup.copies) unpacking.walls = setup.copies;
    InterlockCounts counts;
    return unpacked(setup.options, setup.bodies, unpacking, std::move(plan), counts);
}

}  // namespace

std::vector<Disassembly> plan_packing(const Scene& scene, const PlanOptions& settings, const Control& control) {
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    const StopToken& stop = control.stop;
    const double voxel = settings.voxel.value_or(scene.packing.options.voxel / scene.packing.options.detail);
    if (!(voxel > 0) || !std::isfinite(voxel)) throw UsageError("the voxel size must be a positive number");
    const double ray_spacing = settings.ray_spacing.value_or(settings.voxel || !scene.packing.options.ray_spacing
                                                                 ? DisassemblyOptions::spacing_for(voxel)
                                                                 : *scene.packing.options.ray_spacing);
    check_ray_spacing(ray_spacing, voxel);
    const Container& container = scene.packing.container;
    const Unpack unpack = unpack_rule(settings.unpack ? settings.unpack : scene.packing.options.unpack, container);
    if (unpack == Unpack::top && !opens_at_top(container)) {
        throw UsageError(
            "the container has no flat face at its top, through which --unpack top could take anything out");
    }
    const Workers workers(settings.threads);
    std::int64_t total = 0;
    for (const TrayPacking& tray : scene.packing.trays) {
        for (const Placement& placement : tray.placements) {
            total += placement.fixed ? 0 : unpack == Unpack::top ? 2 : 1;  // planned, then put in order
        }
    }
    std::vector<Disassembly> plans;
    std::int64_t done = 0;
    for (const TrayPacking& tray : scene.packing.trays) {
        if (tray.placements.empty()) {
            plans.push_back({!stop.stopped(), {}, {}});
            continue;
        }
        const auto engine = make_engine(resolve_engine(EngineKind::automatic), 0, workers);
        StandingTray standing(tray, scene.meshes, container, container.physical || unpack == Unpack::top, voxel,
                              ray_spacing, scene.packing.options.wall_gap, workers);
        standing.setup().search = engine.get();
        standing.setup().stop = stop;
        const auto left = [&](int, int) {
            ++done;
            const double work = static_cast<double>(done) / static_cast<double>(total);
            listener.on_progress({Phase::disassemble, done, total, 0, work});
        };
        const std::vector<RemovalStep>* told = tray.disassembly ? &tray.disassembly->steps : nullptr;
        plans.push_back(plan_disassembly(
            {standing.setup(), standing.parts(), tray.placements.size(), container.physical, unpack, told, left}));
    }
    return plans;
}

std::string plans_json(const Scene& scene, const std::vector<Disassembly>& plans) {
    const auto name = [&](std::size_t tray, int i) {
        const Placement& placement = scene.packing.trays[tray].placements[static_cast<std::size_t>(i)];
        return "{\"placement\": " + std::to_string(i) + ", \"part\": " + std::to_string(placement.part) +
               ", \"copy\": " + std::to_string(placement.copy) + "}";
    };
    std::string text = "{\"trays\": [";
    for (std::size_t tray = 0; tray < plans.size(); ++tray) {
        text += tray > 0 ? ", " : "";
        text += std::string("{\"complete\": ") + (plans[tray].complete ? "true" : "false") +
                ", \"steps\": " + std::to_string(plans[tray].steps.size()) + ", \"interlocked\": [";
        for (std::size_t set = 0; set < plans[tray].interlocked.size(); ++set) {
            text += set > 0 ? ", [" : "[";
            for (std::size_t k = 0; k < plans[tray].interlocked[set].size(); ++k) {
                text += (k > 0 ? ", " : "") + name(tray, plans[tray].interlocked[set][k]);
            }
            text += "]";
        }
        text += "]}";
    }
    return text + "]}";
}

}  // namespace spectralpack
