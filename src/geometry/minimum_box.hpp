#pragma once
/// The box of least volume, in any orientation, about a mesh.

#include "spectralpack/mesh.hpp"

namespace spectralpack {

/// The rotation F after which the mesh's axis-aligned box is its minimum-volume box, as nearly as this finds it.
/// O'Rourke (1985): a least box has two adjacent sides flush with edges of the convex hull. Looked at are all boxes
/// with one axis along the normal of a facet, or across two edges where there are few, and, seen along that axis, a
/// side on an edge of the outline. From the best one each axis in turn is taken as the direction to look along until
/// nothing improves. Hulls of over 400 vertices are thinned to the extreme vertices in 602 directions first.
/// Of the 24 frames of the same box, the one nearest the identity (greatest trace). The identity itself, exactly,
/// where the mesh's own box is not larger by a ten-thousandth, and for meshes that span no volume.
Mat3 minimum_box_frame(const Mesh& mesh);

}  // namespace spectralpack
