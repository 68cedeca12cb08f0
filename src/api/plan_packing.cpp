#include "api/plan_packing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "api/check_options.hpp"
#include "api/engine_factory.hpp"
#include "api/plan.hpp"
#include "disassembly/unpacking.hpp"
#include "geometry/mesh_edges.hpp"
#include "model/physical_surfaces.hpp"
#include "packing/containers/physical_walls.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/plan.hpp"
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
    /// `walls`: those of the container stand, too. Fixed copies that stood there before may move.
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
                                tray_.placements[i].fixed && !tray_.placements[i].before};
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

/// The same tray, in which nothing moves that stood there before.
std::vector<Body> without_moving_what_stood_before(const TrayPacking& tray, std::vector<Body> bodies) {
    for (std::size_t i = 0; i < tray.placements.size(); ++i) {
        bodies[i].object.fixed = tray.placements[i].fixed;
    }
    return bodies;
}

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

bool has_copies_from_before(const TrayPacking& tray) {
    return std::ranges::any_of(tray.placements, [](const Placement& placement) { return placement.before; });
}

/// Plans trays of one packing.
class PackingPlanner {
  public:
    /// Throws UsageError for settings that make no sense.
    PackingPlanner(const Packing& packing, const PartMeshes& meshes, const PlanOptions& settings)
        : packing_(packing), meshes_(meshes), workers_(settings.threads) {
        const PackOptions& options = packing.options;
        voxel_ = settings.voxel.value_or(voxel_size(options) / options.detail);
        if (!(voxel_ > 0) || !std::isfinite(voxel_)) throw UsageError("the voxel size must be a positive number");
        ray_spacing_ = settings.ray_spacing.value_or(
            settings.voxel || !options.ray_spacing ? DisassemblyOptions::spacing_for(voxel_) : *options.ray_spacing);
        check_ray_spacing(ray_spacing_, voxel_);
        unpack_ = unpack_rule(settings.unpack ? settings.unpack : options.unpack, packing.container);
        if (unpack_ == Unpack::top && !opens_at_top(packing.container)) {
            throw UsageError(
                "the container has no flat face at its top, through which --unpack top could take anything out");
        }
    }

    /// How often planning tells of a copy that is out.
    std::int64_t questions(const TrayPacking& tray) const {
        const auto moving = std::ranges::count_if(
            tray.placements, [](const Placement& placement) { return !placement.fixed || placement.before; });
        return unpack_ == Unpack::top ? 2 * moving : moving;  // planned, then put in order
    }

    /// `all`: also what stood there before.
    Disassembly plan(const TrayPacking& tray, bool all, const Disassembler::Left& left, const StopToken& stop) const {
        const Container& container = packing_.container;
        const auto engine = make_engine(resolve_engine(EngineKind::automatic), 0, workers_);
        StandingTray standing(tray, meshes_, container, container.physical || unpack_ == Unpack::top, voxel_,
                              ray_spacing_, packing_.options.wall_gap, workers_);
        standing.setup().search = engine.get();
        standing.setup().stop = stop;
        const std::vector<RemovalStep>* told = tray.disassembly ? &tray.disassembly->steps : nullptr;
        return plan_disassembly({standing.setup(),
                                 all ? standing.parts() : without_moving_what_stood_before(tray, standing.parts()),
                                 tray.placements.size(), container.physical, unpack_, told, left});
    }

  private:
    const Packing& packing_;
    const PartMeshes& meshes_;
    Workers workers_;
    double voxel_ = 0, ray_spacing_ = 0;
    Unpack unpack_ = Unpack::any;
};

/// Tells of each copy that is out, of `total` in all trays.
Disassembler::Left telling(Listener& listener, std::int64_t total) {
    const auto done = std::make_shared<std::int64_t>(0);  // copies of the function count together
    return [&listener, total, done](int, int) {
        *done = std::min(*done + 1, total);
        listener.on_progress(
            {Phase::disassemble, *done, total, 0, static_cast<double>(*done) / static_cast<double>(total)});
    };
}

}  // namespace

std::vector<Disassembly> plan_packing(const Scene& scene, const PlanOptions& settings, const Control& control) {
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    const PackingPlanner planner(scene.packing, scene.meshes, settings);
    std::int64_t total = 0;
    for (const TrayPacking& tray : scene.packing.trays) {
        total += planner.questions(tray);
    }
    std::vector<Disassembly> plans;
    const Disassembler::Left left = telling(listener, total);
    for (const TrayPacking& tray : scene.packing.trays) {
        if (tray.placements.empty()) {
            plans.push_back({!control.stop.stopped(), {}, {}});
            continue;
        }
        Disassembly plan = planner.plan(tray, true, left, control.stop);
        // What stood there before stays where not all come out, and is in the way of the others.
        if (!plan.complete && has_copies_from_before(tray)) plan = planner.plan(tray, false, left, control.stop);
        plans.push_back(std::move(plan));
    }
    return plans;
}

void plan_what_stood_before(Packing& packing, const PartMeshes& meshes, int threads, const Control& control) {
    PlanOptions settings;
    settings.threads = threads;
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    for (TrayPacking& tray : packing.trays) {
        if (!tray.disassembly || !tray.disassembly->complete || !has_copies_from_before(tray)) continue;
        const PackingPlanner planner(packing, meshes, settings);
        Disassembly plan = planner.plan(tray, true, telling(listener, planner.questions(tray)), control.stop);
        if (plan.complete) tray.disassembly = std::move(plan);
    }
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
