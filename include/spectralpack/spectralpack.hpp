#pragma once
/// spectralpack: dense, collision-free packing of generic 3D objects. The whole public face, without the
/// tools beside it (spectralpack/tools).
///
///     spectralpack::Job job;
///     job.parts = spectralpack::expand_inputs({"parts/", "bracket.stl:12"}, "").parts;
///     const auto result = spectralpack::pack(job);
///     spectralpack::write_output({result.packing, result.meshes}, "build.3mf", 0);

#include "spectralpack/change.hpp"
#include "spectralpack/check.hpp"
#include "spectralpack/files.hpp"
#include "spectralpack/journal.hpp"
#include "spectralpack/names.hpp"
#include "spectralpack/option_table.hpp"
#include "spectralpack/pack.hpp"
#include "spectralpack/plan.hpp"
#include "spectralpack/printers.hpp"
#include "spectralpack/render.hpp"
#include "spectralpack/typed_text.hpp"
