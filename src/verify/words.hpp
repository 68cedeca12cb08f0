#pragma once
/// What findings say, in words.

#include <string>

#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Six significant digits, whatever the locale.
std::string short_number(double value);

/// "bracket #3": the part's name and the copy's number, as in the packing file.
std::string copy_name(const Packing& packing, const Placement& placement);

/// "tray 2" for the index 1: people count from 1.
std::string tray_name(int tray);

/// "tray 2: " where there are several trays.
std::string tray_prefix(const Packing& packing, int tray);

}  // namespace spectralpack
