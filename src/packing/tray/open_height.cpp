#include "packing/tray/open_height.hpp"

#include <algorithm>
#include <vector>

namespace spectralpack {
namespace {

int most_layers(const Shape& shape) {
    int most = 0;
    for (const OrientedShape& oriented : shape.orientations) {
        most = std::max(most, oriented.solid.extent().z);
    }
    return most;
}

/// Layers by which A+g, in voxels of dx / detail, overhangs A below.
int overhang_below(const Shape& shape, int detail) {
    int most = 0;
    for (const OrientedShape& oriented : shape.orientations) {
        for (const auto& wide : oriented.widened) {
            most = std::max(most, ceil_div(-wide.offset.z, detail));
        }
    }
    return most;
}

}  // namespace

bool holds_in_any_grid(const Tray& tray, const Shape& shape, const CostModel& model, const BestPlacement& best) {
    const int layers = tray.extent().z;
    if (model.height_at == HeightAt::top) {
        const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(best.index)];
        return best.position.z + oriented.solid.extent().z < layers;
    }
    const int unseen = std::max(0, layers - most_layers(shape) + 1);
    return best.cost.primary < height_penalty_at(model, unseen, tray.reference_layers());
}

int layers_on_top(const Tray& tray, const Shape& shape) {
    int top = 0;
    for (ObjectId id = 0; id < tray.object_count(); ++id) {
        if (const TrayObject* object = tray.find(id)) {
            top = std::max(top, object->position.z + object->solid->extent().z);
        }
    }
    return top + overhang_below(shape, tray.detail()) + most_layers(shape) + 1;
}

Tray grown(const Tray& tray, int layers) {
    TraySetup setup = tray.setup();
    setup.size.z = layers * setup.voxel_size;
    setup.reference_layers = tray.reference_layers();
    Tray taller(std::move(setup));
    for (ObjectId id = 0; id < tray.object_count(); ++id) {
        if (tray.find(id)) {
            taller.add(tray.object(id));
        } else {
            taller.add_gone(tray.object(id));
        }
    }
    return taller;
}

}  // namespace spectralpack
