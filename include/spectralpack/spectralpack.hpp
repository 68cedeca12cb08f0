#pragma once
/// spectralpack: dense, collision-free packing of generic 3D objects. The whole public face.
///
///     spectralpack::Job job;
///     job.parts = spectralpack::expand_inputs({"parts/", "bracket.stl:12"}, "").parts;
///     spectralpack::Listener quiet;
///     const auto result = spectralpack::pack(job, quiet, {});
///     spectralpack::write_output({result.packing, result.meshes}, "build.3mf", 0);

#include "spectralpack/check.hpp"
#include "spectralpack/generate.hpp"
#include "spectralpack/inputs.hpp"
#include "spectralpack/inspect.hpp"
#include "spectralpack/pack.hpp"
#include "spectralpack/packings.hpp"
#include "spectralpack/plan_packing.hpp"
#include "spectralpack/prepare.hpp"
#include "spectralpack/printers.hpp"
#include "spectralpack/render.hpp"
