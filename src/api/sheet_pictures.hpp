#pragma once
/// The pictures of the operator's sheet.

#include "core/parallel.hpp"
#include "formats/report/report.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Fills in layout, pictures and thumbs. Each mesh is prepared once for all of them. `hurry`: as paint() has it, and
/// what is begun then has half as many pixels along each side.
void add_pictures(const Scene& scene, ReportContents& contents, const Workers& workers, const StopToken& hurry);

}  // namespace spectralpack
