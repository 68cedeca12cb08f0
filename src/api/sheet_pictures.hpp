#pragma once
/// The pictures of the operator's sheet.

#include "core/parallel.hpp"
#include "formats/report/report.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/render.hpp"

namespace spectralpack {

/// Fills in layout, pictures and thumbs. Each mesh is prepared once for all of them. What is begun in a hurry has half
/// as many pixels along each side, too. Returns how many pictures are left out, which are empty.
int add_pictures(const Scene& scene, ReportContents& contents, const Workers& workers, const DrawingTime& time);

}  // namespace spectralpack
