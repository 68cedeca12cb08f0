#pragma once
/// Several trays, one after the other (appendix A.3, Algorithm 5).

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "packing/job/tray_filler.hpp"
#include "packing/order/packing_score.hpp"

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
    std::int64_t searches() const;
    std::int64_t placed() const;
    std::optional<double> least_gap() const;  ///< of all trays, mm; none where none was measured
};

/// What the copies of a tray take, beside the tray's room. Sizes are inside the wall gap, volumes in mm^3.
struct Crowd {
    double room = 0;      ///< free of walls and keep-outs
    double boxes = 0;     ///< of the copies and what stands fixed, each longer by its gap along every axis
    double material = 0;  ///< theirs
    /// Of a tray whose copies may be packed on a part of its base (TrayCopies::within); none of others.
    std::optional<Vec3> size;
};

/// Where height counts in each tray, decided as it is filled.
struct HeightChoice {
    std::function<Crowd(const TrayCopies&)> crowd;
    /// Whether all copies can be expected to fit. It says how a tray is packed first, not how it ends.
    std::function<bool(const Crowd&)> expects_to_fit;
    PackingMeasures measures;  ///< mm
};

/// Called after each copy with its tray and how many of that tray's copies are done.
using TrayCopyDone = std::function<void(const FilledTray& tray, std::size_t copies_done)>;

/// Fills one tray after the other with `copies`, which come in the order to try; what found no place in one tray is
/// tried in the next. Ends when all are placed, the limit is reached or, where several trays are allowed, a tray
/// without fixed copies stays empty. `result` is filled as it goes, so that it holds what was done when an exception
/// leaves this function.
/// `choice` (null: height counts where the filler's model says) fills a tray as fill_by_choice() does. `next_tray` is
/// called before each tray but the first.
void fill_trays(const std::vector<Copy>& copies, const TraysLimit& limit, TrayFiller& filler,
                const HeightChoice* choice, const TrayCopyDone& copy_done, TraysResult& result,
                const std::function<void()>& next_tray = {});

/// Makes a packing of the layouts that trays have on the grid: TrayFiller::finish() for each. What cannot be taken out
/// of one, and for the last what found no place, is tried in the next; where it is the last, in as many more as `limit`
/// allows. `copies`: all of the job's, in the order packed in. `result` as in fill_trays().
void finish_trays(const TraysResult& layouts, const std::vector<Copy>& copies, const TraysLimit& limit,
                  TrayFiller& filler, TraysResult& result);

/// Tells of a packing that is done: tray by tray, each copy where it stands. `told`: so many trays have been told of
/// before; those that are not among the result's are empty now.
void tell_of(const TraysResult& result, int told, TrayObserver& observer);

}  // namespace spectralpack
