#include "packing/job/packing_job.hpp"

#include <map>
#include <utility>

namespace spectralpack {

ScaledPart JobPart::scaled() const {
    const auto in_mm = to_mm == 1 ? mesh : std::make_shared<const Mesh>(transformed(*mesh, {to_mm * Mat3{}, {}}));
    return {in_mm, gap, orientations.get(), volume};
}

Transform JobPart::transform_of(const PlacedCopy& placed) const {
    return {to_mm * (*orientations)[static_cast<std::size_t>(placed.orientation)], placed.offset};
}

PackingMeasures measures_of(const std::vector<JobPart>& parts) {
    const auto tops = std::make_shared<std::map<std::pair<int, int>, double>>();  // by part and orientation
    return {[&](int part) { return parts[static_cast<std::size_t>(part)].volume; },
            [&, tops](const PlacedCopy& placed) {
                const auto [top, fresh] = tops->try_emplace({placed.copy.part, placed.orientation}, 0);
                if (fresh) {
                    PlacedCopy at_origin = placed;
                    at_origin.offset = {};
                    const JobPart& part = parts[static_cast<std::size_t>(placed.copy.part)];
                    top->second = bounding_box(transformed(*part.mesh, part.transform_of(at_origin))).max.z;
                }
                return top->second + placed.offset.z;
            }};
}

}  // namespace spectralpack
