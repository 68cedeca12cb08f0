#pragma once
/// How a tray is packed where that is left open (--height-at auto): with height at the top where it holds all copies,
/// on no more of the base than that takes.

#include "packing/job/packing_job.hpp"
#include "packing/job/trays.hpp"

namespace spectralpack {

/// Whether so many copies can be expected to fit, by what full trays hold.
bool expects_to_fit(const Crowd& crowd);

/// For `job` filled as `fill` says; refers to both.
HeightChoice choose_heights(const PackingJob& job, const FillOptions& fill);

/// Fills a new tray: with height at the top where all copies can be expected to fit, else as the filler's model says.
/// What turns out otherwise is filled the other way, too; the better packing stays (score_packing()), the first of
/// equals. One with height at the top that holds all and leaves much of the base free is packed anew on parts of the
/// base; the smallest stays on which it comes no higher. `tray` is the packing that is kept, also when an exception
/// leaves this function, with the searches of all.
void fill_by_choice(const HeightChoice& choice, TrayCopies wanted, TrayFiller& filler, const TrayCopyDone& copy_done,
                    FilledTray& tray);

}  // namespace spectralpack
