#include "api/packing_job.hpp"

#include <algorithm>
#include <cmath>

#include "api/check_options.hpp"
#include "api/keep_outs.hpp"
#include "packing/containers/walls.hpp"

namespace spectralpack {
namespace {

FillOptions fill_setup(const JobSource& source, Listener& listener, const Workers& workers) {
    const auto& [loaded, plan, container, options] = source;
    const double wall = 2 * options.wall_gap;
    FillOptions setup;
    setup.container = container;
    setup.container.size = tray_size(options);
    setup.tray.size = setup.container.size - Vec3{wall, wall, wall};
    setup.tray.blocked = blocked_voxels(container, plan.grid, voxel_size(options), options.wall_gap, workers);
    setup.tray.blocked_is_physical = container.physical;
    require_free(setup.tray.blocked, container, options);
    setup.tray.voxel_size = voxel_size(options);
    setup.tray.detail = options.detail;
    setup.tray.gap_classes = plan.gap_classes;
    setup.wall_gap = options.wall_gap;
    setup.model = {plan.height_penalty,
                   height_reference(options) == HeightReference::top ? HeightAt::top : HeightAt::bottom};
    setup.refine = options.refine;
    setup.max_density = options.max_density;
    setup.max_layer_fill = options.max_layer_fill;
    setup.interlock = options.interlock;
    setup.links = options.links;
    setup.take_out = options.take_out;
    setup.unpack = unpack_rule(options.unpack, container);
    setup.ray_spacing = options.ray_spacing;
    const auto telling = [&listener](Phase phase) {
        return [&listener, phase](int left, int all) {
            listener.on_progress({phase, all - left, all, 0, static_cast<double>(all - left) / all});
        };
    };
    setup.left = telling(Phase::disassemble);
    setup.to_put_back = telling(Phase::reinsert);
    if (is_open(options)) {
        setup.tray.ceiling = Ceiling::open;
        setup.tray.reference_layers =
            std::max(1, static_cast<int>(std::ceil(setup.tray.size.z / voxel_size(options) - 1e-9)));
        setup.tray.size.z = plan.grid.z * voxel_size(options);
        setup.container.size.z = Box::kInfinity;
        setup.most_layers = plan.most_layers;
    }
    for (const FixedPlacement& fixed : loaded.fixed) {
        const auto part = static_cast<std::size_t>(fixed.placement.part);
        setup.fixed.push_back({fixed.tray, loaded.meshes[part], fixed.placement.transform, loaded.parts[part].gap});
    }
    return setup;
}

std::vector<JobPart> job_parts(const LoadedJob& loaded, const Plan& plan) {
    std::vector<JobPart> parts;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const PackedPart& part = loaded.parts[i];
        parts.push_back({loaded.meshes[i], part.to_mm(), part.gap, plan.orientations[i], part.volume,
                         loaded.box_volume[i], part.count, part.value});
    }
    return parts;
}

}  // namespace

PackingJob packing_job(const JobSource& source, Listener& listener, const Workers& workers) {
    const auto& [loaded, plan, container, options] = source;
    PackingJob job;
    job.parts = job_parts(loaded, plan);
    job.copies = plan.items;
    job.ranks = plan.ranks;
    job.fill = fill_setup(source, listener, workers);
    job.limit = {options.trays, options.try_per_tray};
    job.choose_heights = !height_reference(options);
    job.in_shares = options.fill;
    job.room = plan.room;
    job.keep = plan.keep;
    job.answers = plan.answers;
    job.ahead = plan.ahead;
    job.held = plan.held();
    job.keeps_all = plan.keeps_all;
    return job;
}

}  // namespace spectralpack
