#pragma once
/// Keep-outs as they are typed.

#include <string>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// x0,y0,z0,x1,y1,z1 in mm, or a mesh file. Throws UsageError naming --keep-out for numbers that are no box. `tray` is
/// for the message.
KeepOutSource parse_keep_out(const std::string& text, const Vec3& tray);

}  // namespace spectralpack::cli
