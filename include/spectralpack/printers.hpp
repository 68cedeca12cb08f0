#pragma once
/// Printers that are known by name: build volumes, and the clearances that are customary with them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spectralpack/options.hpp"

namespace spectralpack {

/// Millimetres. Clearances differ with material and shop: they are a start, not the maker's word.
struct Printer {
    std::string name;   ///< as on the command line
    std::string title;  ///< for people
    Vec3 size;
    double gap = 0;         ///< between two copies
    double wall = 0;        ///< to the side walls
    double floor = 0;       ///< to the floor
    std::string source;     ///< of the size
    bool verified = false;  ///< the size was compared with its source; clearances never are

    /// One clearance holds for walls and floor: the larger of the two.
    double wall_gap() const { return wall < floor ? floor : wall; }
};

std::span<const Printer> printers();

/// By name, whatever the case, among the user's own and then among printers(); null where it is not known. It points
/// into either.
const Printer* find_printer(std::string_view name, std::span<const Printer> own = {});

/// Sets tray, gap, wall gap and the printer's name: the options set_by_printer().
void apply(const Printer& printer, PackOptions& options);
std::vector<std::string> set_by_printer();

}  // namespace spectralpack
