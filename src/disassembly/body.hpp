#pragma once
/// A copy where it stands: as a mesh, which decides, and as voxels, which lead the way.

#include <memory>
#include <vector>

#include "geometry/bvh.hpp"
#include "search/tray.hpp"

namespace spectralpack {

struct Body {
    std::shared_ptr<const Bvh> surface;  ///< turned and scaled, mm
    Vec3 offset;                         ///< mm by which it is moved to where it stands
    TrayObject object;                   ///< its voxels there; fixed ones never move

    Box box() const { return {surface->box().min + offset, surface->box().max + offset}; }
};

inline std::vector<Box> boxes_of(const std::vector<Body>& parts) {
    std::vector<Box> boxes;
    for (const Body& part : parts) {
        boxes.push_back(part.box());
    }
    return boxes;
}

}  // namespace spectralpack
