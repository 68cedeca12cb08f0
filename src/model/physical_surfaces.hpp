#pragma once
/// What a physical container puts in the way of what leaves it. It is open at the top: its floor and its sides stand up
/// to the top of its box (a container mesh's surface but for what of it lies in that plane), and so do its keep-outs.

#include <vector>

#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Closed, facing outwards where its mesh does, which has to be loaded.
Mesh surface_of(const KeepOut& keep_out);

/// Surfaces whose facets face the room that copies move in: the container's, not closed, then each keep-out's, closed.
/// Meshes have to be loaded.
std::vector<Mesh> physical_surfaces(const Container& container);

/// True where something of the container lies in the plane of the top of its box: else nothing can ever leave it.
bool opens_at_top(const Container& container);

}  // namespace spectralpack
