#include "api/check_options.hpp"
#include "api/check_together.hpp"
#include "api/fixed_copies.hpp"
#include "api/grid_choice.hpp"
#include "api/keep_outs.hpp"
#include "api/load.hpp"
#include "api/load_container.hpp"
#include "api/plan.hpp"
#include "core/stopped.hpp"
#include "formats/json_text.hpp"
#include "packing/containers/walls.hpp"
#include "spectralpack/pack.hpp"

namespace spectralpack {

namespace {

Estimate estimate_of(const Job& job, const Control& control) {
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    PackOptions options = job.options;
    check_options(options);
    check_together(job);
    const Workers workers = Workers(options.threads).stopping_with(control.stop);
    const Container container = container_of(job, listener, control.stop);
    warn_of_keep_outs(container, listener);
    options.tray = container.size;
    const LoadedJob loaded = load_parts(job, workers, listener);
    require_sound(loaded, container, options, workers, listener, control.stop);
    workers.check();
    const Plan plan = choose_grid(loaded, container, job.own_printers, workers, options);
    require_free(blocked_voxels(container, plan.grid, voxel_size(options), options.wall_gap, workers), container,
                 options);
    Estimate estimate;
    estimate.grid = plan.grid;
    estimate.voxel = voxel_size(options);
    estimate.container = tray_size(options);
    estimate.orientations = static_cast<int>(plan.most_orientations);
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const bool packed = loaded.meshes[i] && plan.too_large[i].empty();
        const int copies = copies_to_pack(loaded, i);
        (packed ? estimate.copies : estimate.left_over) += copies;
        estimate.parts += packed && copies > 0 ? 1 : 0;
    }
    estimate.searches = static_cast<std::int64_t>(plan.items.size());
    estimate.memory = plan.memory;
    estimate.memory_limit = plan.memory_limit;
    estimate.box_ratio = plan.box_ratio;
    estimate.volume_ratio = plan.volume_ratio;
    estimate.height_penalty = plan.height_penalty;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        if (!plan.too_large[i].empty()) {
            estimate.too_large.push_back(loaded.parts[i].name + ": " + plan.too_large[i]);
        }
    }
    estimate.unusable = loaded.unusable;
    return estimate;
}

}  // namespace

Estimate estimate(const Job& job, const Control& control) {
    try {
        return estimate_of(job, control);
    } catch (const Stopped&) {
        Estimate nothing;
        nothing.stopped = control.stop.reason();
        return nothing;
    }
}

std::string estimate_json(const Estimate& estimate, std::optional<double> seconds) {
    const auto numbers = [](double x, double y, double z) {
        return "[" + json_number(x) + ", " + json_number(y) + ", " + json_number(z) + "]";
    };
    std::string too_large, unusable;
    for (const std::string& part : estimate.too_large) {
        too_large += (too_large.empty() ? "" : ", ") + json_string(part);
    }
    for (const InputError& error : estimate.unusable) {
        unusable += std::string(unusable.empty() ? "" : ", ") + "{\"file\": " + json_string(error.file()) +
                    ", \"place\": " + json_string(error.place()) + ", \"cause\": " + json_string(error.cause()) + "}";
    }
    return "{\"copies\": " + std::to_string(estimate.copies) + ", \"parts\": " + std::to_string(estimate.parts) +
           ", \"left_over\": " + std::to_string(estimate.left_over) +
           ", \"container\": " + numbers(estimate.container.x, estimate.container.y, estimate.container.z) +
           ", \"grid\": " + numbers(estimate.grid.x, estimate.grid.y, estimate.grid.z) +
           ", \"orientations\": " + std::to_string(estimate.orientations) +
           ", \"volume_ratio\": " + json_number(estimate.volume_ratio) +
           ", \"box_ratio\": " + json_number(estimate.box_ratio) +
           ", \"seconds\": " + (seconds ? json_number(*seconds) : "null") +
           ", \"memory\": " + std::to_string(estimate.memory) +
           ", \"memory_limit\": " + std::to_string(estimate.memory_limit) + ", \"too_large\": [" + too_large +
           "], \"unusable\": [" + unusable + "]}";
}

}  // namespace spectralpack
