#pragma once
/// Several trays: orders that leave less to the last one, or none.

#include <cstdint>
#include <optional>

#include "packing/improve/improvement.hpp"

namespace spectralpack {

/// How good a packing into several trays is: less is better, lexicographically.
struct TraysScore {
    double missing = 0;  ///< worth of the copies that are not placed
    std::int64_t trays = 0;
    double last = 0;  ///< mm^3, what the last of them holds
    double top = 0;   ///< mm, of that

    auto operator<=>(const TraysScore&) const = default;
};

/// Packs all trays anew on the grid, in orders in which what ended in the last trays goes earlier, and makes each
/// packing that is better come apart. It becomes `packed` where it is better then, too. Where nothing better is found
/// for some time, the last tray becomes lower. As improve().
void improve_trays(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell,
                   TrayObserver* observer, PackedJob& packed);

}  // namespace spectralpack
