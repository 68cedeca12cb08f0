#pragma once
/// Several trays, one after the other (appendix A.3, Algorithm 5).

#include <functional>
#include <optional>
#include <vector>

#include "packing/job/tray_filler.hpp"

namespace spectralpack {

struct TraysLimit {
    int trays = 1;         ///< at most; 0: as many as it takes
    int try_per_tray = 0;  ///< a tray is full once so many parts found no place in it; 0: once all were tried
};

struct TraysResult {
    std::vector<FilledTray> trays;
    std::vector<Copy> left_over;  ///< found no place in the last tray either; what else is not placed was not tried
                                  ///< to the end, or is interlocked
    /// There are copies left, and a tray to which nothing had been added stayed empty of them. That tray is not among
    /// `trays`.
    bool stuck = false;
    std::optional<double> least_gap;  ///< measured by refinement, mm

    std::int64_t searches() const;
    std::int64_t placed() const;
};

/// Called after each copy with its tray and how many of that tray's copies are done.
using TrayCopyDone = std::function<void(const FilledTray& tray, std::size_t copies_done)>;

/// Fills one tray after the other with `copies`, which come in the order to try; what found no place in one tray is
/// tried in the next. Ends when all are placed, the limit is reached or, where several trays are allowed, a tray
/// without fixed copies stays empty. `result` is filled as it goes, so that it holds what was done when an exception
/// leaves this function.
void fill_trays(const std::vector<Copy>& copies, const TraysLimit& limit, TrayFiller& filler,
                const TrayCopyDone& copy_done, TraysResult& result);

/// Tells of a packing that is done: tray by tray, each copy where it stands. `told`: so many trays have been told of
/// before; those that are not among the result's are empty now.
void tell_of(const TraysResult& result, int told, TrayObserver& observer);

}  // namespace spectralpack
