#include "packing/tray/decisions_fit.hpp"

#include <algorithm>
#include <set>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

void require_that(bool fits) {
    if (!fits)
        throw InternalError("the journal does not fit this run, though it is of the same job; --no-resume begins anew");
}

bool is_index(int i, std::size_t size) { return i >= 0 && static_cast<std::size_t>(i) < size; }

}  // namespace

void require_fit_of_layers(int layers, const Tray& tray, int most_layers) {
    const bool open = tray.setup().ceiling != Ceiling::closed;
    require_that(open ? layers >= 0 && (most_layers <= 0 || layers <= most_layers) : layers == tray.extent().z);
}

void require_fit(const FoundPlace& found, const Tray& tray, const Shape& shape, int most_layers) {
    require_fit_of_layers(found.layers, tray, most_layers);
    if (!found.best) return;
    require_that(is_index(found.best->index, shape.orientations.size()));
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(found.best->index)];
    Extent candidates = tray.candidates(oriented.reach);
    if (tray.setup().ceiling != Ceiling::closed) candidates.z = std::max(candidates.z, found.layers);
    const VoxelIndex& q = found.best->position;
    require_that(q.x >= 0 && q.y >= 0 && q.z >= 0 && q.x < candidates.x && q.y < candidates.y && q.z < candidates.z);
}

void require_fit(const GreedyResult& result, const std::vector<Copy>& copies,
                 const std::function<std::size_t(int part)>& orientations) {
    std::set<int> parts;
    for (const Copy& copy : copies) {
        parts.insert(copy.part);
    }
    const auto is_of_these = [&](const Copy& copy) { return parts.contains(copy.part) && copy.number >= 0; };
    require_that(std::ranges::all_of(result.left_over, is_of_these) &&
                 std::ranges::all_of(result.untried, is_of_these));
    for (const PlacedCopy& placed : result.placed) {
        require_that(is_of_these(placed.copy) && is_index(placed.orientation, orientations(placed.copy.part)));
    }
}

void require_fit(const Disassembly& plan, std::size_t copies, std::size_t fixed) {
    for (const RemovalStep& step : plan.steps) {
        require_that(std::ranges::all_of(step.placements, [&](int i) { return is_index(i, copies); }));
    }
    for (const std::vector<int>& set : plan.interlocked) {
        require_that(std::ranges::all_of(set, [&](int i) { return is_index(i, copies + fixed); }));
    }
    require_that(std::ranges::all_of(plan.through_walls, [&](int i) { return is_index(i, plan.steps.size()); }));
}

void require_fit(const std::vector<int>& out, std::size_t copies) {
    require_that(std::ranges::is_sorted(out) && std::ranges::adjacent_find(out) == out.end() &&
                 std::ranges::all_of(out, [&](int i) { return is_index(i, copies); }));
}

}  // namespace spectralpack
