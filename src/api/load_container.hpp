#pragma once
/// Containers and keep-outs from mesh files.

#include <optional>

#include "spectralpack/events.hpp"
#include "spectralpack/job.hpp"
#include "spectralpack/pack.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// The one mesh in the file; `default_unit`: mm per unit where neither file nor source says. Throws InputError, with
/// the place that the source was named at, where the file is unusable or holds several objects. Here and below, Stopped
/// is thrown once `stop` is requested.
StandingMesh load_standing_mesh(const MeshSource& source, double default_unit, const StopToken& stop = {});

/// With meshes in place. `tray`: the size of a box. A container mesh without a transform is moved to the origin. Tells
/// the listener what of a mesh is filled. Throws InputError for a mesh that is not closed, saying where it is open,
/// that reaches below the origin, or that is to be a vessel and holds nothing; and for keep-outs that are not closed.
Container load_container(const ContainerSource& source, const Vec3& tray, double default_unit, Listener& listener,
                         const StopToken& stop);

/// The job's container. Throws as load_container does, and where nothing could leave it that has to.
Container container_of(const Job& job, Listener& listener, const StopToken& stop);

/// As load_container, for a container that a packing file describes.
void load_surfaces(Container& container);

}  // namespace spectralpack
