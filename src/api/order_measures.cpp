#include "api/order_measures.hpp"

#include <map>
#include <memory>
#include <utility>

#include "api/record.hpp"

namespace spectralpack {

PackingMeasures order_measures(const LoadedJob& loaded, const Plan& plan) {
    const auto tops = std::make_shared<std::map<std::pair<int, int>, double>>();  // by part and orientation
    return {[&](int part) { return loaded.parts[static_cast<std::size_t>(part)].volume; },
            [&, tops](const PlacedItem& placed) {
                const auto [top, fresh] = tops->try_emplace({placed.item.part, placed.orientation}, 0);
                if (fresh) {
                    PlacedItem at_origin = placed;
                    at_origin.offset = {};
                    const Mesh& mesh = *loaded.meshes[static_cast<std::size_t>(placed.item.part)];
                    top->second = bounding_box(transformed(mesh, transform_of(loaded, plan, at_origin))).max.z;
                }
                return top->second + placed.offset.z;
            }};
}

}  // namespace spectralpack
