#pragma once
/// Printers that are known by name: build volumes, and the clearances that are customary with them.

#include <span>
#include <string>
#include <string_view>

#include "spectralpack/options.hpp"

namespace spectralpack {

/// Millimetres. Clearances differ with material and shop: they are a start, not the maker's word.
struct Printer {
    std::string_view name;   ///< as on the command line
    std::string_view title;  ///< for people
    Vec3 size;
    double gap = 0;           ///< between two copies
    double wall = 0;          ///< to the side walls
    double floor = 0;         ///< to the floor
    std::string_view source;  ///< of the size
    bool verified = false;    ///< the size was compared with its source; clearances never are

    /// One clearance holds for walls and floor: the larger of the two.
    double wall_gap() const { return wall < floor ? floor : wall; }
};

std::span<const Printer> printers();

/// By name, whatever the case; null where it is not known.
const Printer* find_printer(std::string_view name);

/// Sets tray, gap, wall gap and the printer's name.
void apply(const Printer& printer, PackOptions& options);

}  // namespace spectralpack
