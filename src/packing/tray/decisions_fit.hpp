#pragma once
/// Whether recalled decisions can be this run's, so that nothing reads beyond what there is. Checksums tell damage, not
/// who wrote a journal. Each throws InternalError where one cannot.

#include <cstddef>
#include <functional>
#include <vector>

#include "packing/tray/decisions.hpp"
#include "search/shape.hpp"
#include "search/tray.hpp"

namespace spectralpack {

/// `most_layers` as TrayLimits has it.
void require_fit(const FoundPlace& found, const Tray& tray, const Shape& shape, int most_layers);
void require_fit_of_layers(int layers, const Tray& tray, int most_layers);

/// `orientations` tells how many a part has; it is asked about parts of `copies` alone.
void require_fit(const GreedyResult& result, const std::vector<Copy>& copies,
                 const std::function<std::size_t(int part)>& orientations);

/// Of a plan for so many copies, and of the tray's fixed ones.
void require_fit(const Disassembly& plan, std::size_t copies, std::size_t fixed);

/// Indices among so many, ascending.
void require_fit(const std::vector<int>& out, std::size_t copies);

}  // namespace spectralpack
