#pragma once
/// What findings say, in words.

#include <string>

#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Six significant digits, whatever the locale.
std::string short_number(double value);

/// "61 bracket": the copy's number, as on pictures and sheet, and its part's name. "copy 7 of bracket" where the
/// packing file names one beyond the part's count.
std::string copy_name(const Packing& packing, const Placement& placement);

/// "tray 2" for the index 1: people count from 1.
std::string tray_name(int tray);

/// "tray 2: " where there are several trays.
std::string tray_prefix(const Packing& packing, int tray);

}  // namespace spectralpack
