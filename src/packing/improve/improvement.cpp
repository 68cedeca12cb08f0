#include "packing/improve/improvement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/random.hpp"
#include "core/stopwatch.hpp"
#include "packing/improve/fewest_trays.hpp"
#include "packing/improve/tray_improver.hpp"
#include "packing/job/least_box.hpp"
#include "packing/tray/compaction.hpp"
#include "packing/tray/decisions_fit.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kMostFound = 5;  // layouts that wait for that: where the best interlocks, the next has its turn
constexpr std::int64_t kSettled = 25;  // steps without a better layout: then the best is made to come apart
constexpr double kFair = 2;            // with Goal::fair, copies with boxes at most so many times as large are passed

constexpr std::int64_t kOnBase = 20;  // steps without a better layout: then it goes on on another base

// Bases beside the best so far, in voxels of its sides. Once they gained nothing: such whose sides are drawn from e^-s
// to e^s times those of the best.
constexpr double kFarther = 0.4;
constexpr BaseSize kBeside[] = {{-1, 0},  {0, -1}, {1, -1}, {-1, 1}, {1, 0},  {0, 1},  {-2, 1}, {1, -2},
                                {-1, -1}, {2, -1}, {-1, 2}, {-2, 0}, {0, -2}, {-3, 2}, {2, -3}};

/// Less is better, lexicographically.
struct TrayScore {
    double missing = 0;  ///< worth of the copies that are not placed
    double size = 0;     ///< mm of height; where the base was searched for, mm^3 of the packing's box

    auto operator<=>(const TrayScore&) const = default;
};

std::function<double(int)> worth_of(Goal goal, const std::vector<JobPart>& parts) {
    return [goal, &parts](int part) {
        const JobPart& of = parts[static_cast<std::size_t>(part)];
        if (goal == Goal::copies) return 1.0;
        if (goal == Goal::value) return of.value;
        return std::max(0.0, of.volume);
    };
}

class Improving {
  public:
    Improving(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell, TrayObserver* observer,
              PackedJob& packed)
        : packer_(packer),
          job_(packer.job()),
          options_(options),
          tell_(tell),
          observer_(observer),
          packed_(packed),
          measures_(measures_of(job_.parts)),
          worth_(worth_of(options.goal, job_.parts)) {}

    /// The only tray: of all copies.
    void run() { run(packed_.trays.trays.front(), {0, job_.copies, false, 0, {}, {}}); }

    /// One of several, of the copies in it.
    void run(int number) {
        of_job_ = false;
        FilledTray& tray = packed_.trays.trays[static_cast<std::size_t>(number)];
        run(tray, {number, order_of(tray.placed), false, 0, {}, {}});
    }

  private:
    void run(FilledTray& tray, TrayCopies wanted) {
        const bool holds_all = tray.placed.size() == wanted.copies.size();
        if (wanted.copies.empty()) return;
        if (holds_all) wanted.height_at = HeightAt::top;
        const Improves in_all = packed_.base ? Improves::box : Improves::height;
        packed_.improvement = Improved{holds_all ? in_all : improves_of(options_.goal)};
        best_ = score(tray, wanted.copies);
        packed_.improvement->before = packed_.improvement->now = figure(tray, best_);
        packer_.keep_shapes();
        FillOptions fill = job_.fill;
        fill.enough = options_.stop;  // what was found is finished, however long it takes
        // What cannot leave a low layout makes it higher wherever else it is put; in a full tray it may find room.
        fill.repair = !holds_all;
        go_on_from_journal(wanted, tray);
        if (packed_.base) return improve_on_bases(fill, wanted, tray);
        packer_.with_filler({fill, options_.stop},
                            [&](TrayFiller& filler) { improve(filler, wanted, tray, std::nullopt); });
    }

    static Improves improves_of(Goal goal) {
        return goal == Goal::copies ? Improves::copies : goal == Goal::value ? Improves::value : Improves::density;
    }

    TrayScore score(const FilledTray& tray, const std::vector<Copy>& wanted) const {
        const PackingScore of_all = score_packing(wanted, {&tray.placed}, {worth_, measures_.top});
        return {of_all.left_over, packed_.base ? box_volume(job_, tray.placed) : of_all.top};
    }

    /// What the user is told of it.
    double figure(const FilledTray& tray, const TrayScore& score) const {
        const Improves what = packed_.improvement->what;
        if (what == Improves::height || what == Improves::box) return score.size;
        if (what == Improves::copies) return static_cast<double>(tray.placed.size());
        double sum = 0;
        for (const PlacedCopy& placed : tray.placed) {
            sum += worth_(placed.copy.part);
        }
        return what == Improves::density ? sum / volume_of(job_.fill.container) : sum;
    }

    /// On the best base so far, then on others, each time a start from the best order so far.
    void improve_on_bases(FillOptions fill, TrayCopies wanted, FilledTray& tray) {
        const BaseSize most{voxels(job_.fill.tray.size.x), voxels(job_.fill.tray.size.y)};
        BaseSize best = *packed_.base, base = best;
        for (std::size_t next = 0; goes_on(0); ++next, ++starts_before_) {
            packer_.with_filler({on_base(fill, base), options_.stop},
                                [&](TrayFiller& filler) { improve(filler, wanted, tray, base); });
            if (*packed_.base != best) {
                best = *packed_.base;
                next = 0;
            }
            if (tray.placed.size() == wanted.copies.size()) wanted.copies = order_of(tray.placed);
            base = next < std::size(kBeside) ? BaseSize{best.x + kBeside[next].x, best.y + kBeside[next].y}
                                             : farther_base(best);
            base = {std::clamp(base.x, 1, most.x), std::clamp(base.y, 1, most.y)};
        }
    }

    BaseSize farther_base(const BaseSize& from) const {
        RandomStream random(numbered_seed(options_.seed, starts_before_));
        const auto drawn = [&](int side) {
            return static_cast<int>(std::lround(side * std::exp(kFarther * (2 * random.unit() - 1))));
        };
        const int x = drawn(from.x);
        return {x, drawn(from.y)};
    }

    int voxels(double length) const { return static_cast<int>(std::lround(length / job_.fill.tray.voxel_size)); }

    bool goes_on(std::int64_t steps) const {
        return !options_.enough.stopped() &&
               (options_.most_steps == 0 || steps_on_others_ + steps < options_.most_steps);
    }

    /// `base`: on which that is; it ends there once it finds nothing better. None: in the job's own tray.
    void improve(TrayFiller& filler, const TrayCopies& wanted, FilledTray& tray, const std::optional<BaseSize>& base) {
        filler.keep_answers(job_.answers);
        StartedTray started = filler.start(wanted);
        std::map<int, std::shared_ptr<const Shape>> shapes;
        const auto shape_of = [&](int part) -> const Shape& {
            std::shared_ptr<const Shape>& shape = shapes[part];
            if (!shape) shape = packer_.lasting_shape(part);
            return *shape;
        };
        const std::uint64_t seed = numbered_seed(options_.seed, base ? starts_before_ : 0);
        TrayImproverOptions improver_options{wanted.copies, job_.ranks, {}, {}, {}, seed, job_.fill.refine};
        improver_options.measures = {worth_, measures_.top, job_.fill.tray.voxel_size, job_.fill.wall_gap};
        const bool fair = packed_.improvement->what == Improves::density && options_.goal == Goal::fair;
        improver_options.may_pass = [&, fair](const Copy& a, const Copy& b) {
            const auto box = [&](const Copy& copy) {
                return job_.parts[static_cast<std::size_t>(copy.part)].box_volume;
            };
            return !fair || box(b) <= kFair * box(a);
        };
        improver_options.size_of = [&](const std::vector<PlacedCopy>& placed) {
            return base ? box_volume(job_, placed) : top_of(placed, started.surfaces());
        };
        TrayImprover improver(started, filler.refining(wanted), shape_of, improver_options, packer_.workers(),
                              {options_.enough, options_.stop});
        if (!base && starts_before_ > 0) improver.begin_start(starts_before_);
        std::vector<ImprovedLayout> found;  // and not taken apart so far, each better than those before
        std::int64_t found_at = 0;
        const auto settle = [&] {
            bool better = false;
            for (; !found.empty() && !better; found.pop_back()) {
                better = finish(filler, wanted, found.back(), base, tray);
            }
            found.clear();
            if (!better) improver.set_best_size(best_.size);  // what comes next is compared with what there is
        };
        const auto note = [&](std::optional<ImprovedLayout> layout) {
            if (!layout) return;
            found.push_back(*std::move(layout));
            if (found.size() > kMostFound) found.erase(found.begin());
            found_at = improver.steps();
        };
        tell(improver);
        while (goes_on(improver.steps())) {
            note(improver.step());
            tell(improver);
            if (base && improver.steps() - found_at >= kOnBase) break;
            if (!found.empty() && improver.steps() - found_at >= kSettled) {
                settle();
                tell(improver);
            }
        }
        note(improver.compare());
        settle();
        tray.searches += improver.searches();
        tell(improver);
        steps_on_others_ += improver.steps();
    }

    /// Makes the layout come apart. It becomes the tray where that is better than what there is; then true.
    bool finish(TrayFiller& filler, const TrayCopies& wanted, const ImprovedLayout& layout,
                const std::optional<BaseSize>& base, FilledTray& tray) {
        if (options_.stop.stopped()) return false;
        const Improves what = packed_.improvement->what;
        if ((what == Improves::height || what == Improves::box) && layout.size >= best_.size) return false;
        FilledTray finished;
        filler.finish(wanted, layout.placed, job_.fill.refine, finished);
        const bool comes_apart = !finished.plan || finished.plan->complete;
        const TrayScore reached = score(finished, wanted.copies);
        const std::int64_t searches = tray.searches + finished.searches;
        const bool better = comes_apart && reached < best_ && !options_.stop.stopped();
        if (better) {
            packed_.base = base;
            take(wanted, std::move(finished), reached, tray);
        }
        tray.searches = searches;
        keep(tray);
        return better;
    }

    void take(const TrayCopies& wanted, FilledTray better, const TrayScore& reached, FilledTray& tray) {
        tray = std::move(better);
        best_ = reached;
        packed_.improvement->now = figure(tray, best_);
        if (of_job_) packed_.trays.left_over = without(wanted.copies, copies_in(tray.placed));
        if (!observer_) return;
        tell_anew(*observer_, wanted.number, tray.placed);
        observer_->tray_finished();
    }

    void keep(const FilledTray& tray) const {
        const Improved& improved = *packed_.improvement;
        const BaseSize base = packed_.base.value_or(BaseSize{});
        if (packer_.decisions() && of_job_) {
            packer_.decisions()->keep(ImprovedTray{improved.steps, improved.starts, seconds(), base.x, base.y, tray});
        }
    }

    /// Steps are repeated where their number counts; else the best that a run before had found stands, and the next
    /// start begins.
    void go_on_from_journal(const TrayCopies& wanted, FilledTray& tray) {
        if (!packer_.decisions() || !of_job_) return;
        packer_.decisions()->begin_filling();
        std::optional<ImprovedTray> known = packer_.decisions()->recall_improved();
        if (!known || options_.most_steps > 0) return;
        require_fit(known->tray, wanted.copies, [&](int part) {
            const auto& set = job_.parts[static_cast<std::size_t>(part)].orientations;
            return set ? set->size() : 0;
        });
        if (known->tray.plan) require_fit(*known->tray.plan, known->tray.placed.size(), job_.fill.fixed.size());
        seconds_before_ = known->seconds;
        steps_before_ = known->steps;
        starts_before_ = known->starts;
        const TrayScore reached = score(known->tray, wanted.copies);
        if (!(reached < best_)) return;
        if (packed_.base) packed_.base = BaseSize{known->x, known->y};
        take(wanted, std::move(known->tray), reached, tray);
    }

    double seconds() const { return seconds_before_ + watch_.seconds(); }

    void tell(const TrayImprover& improver) const {
        const std::int64_t steps = steps_on_others_ + improver.steps();
        packed_.improvement->steps = steps_before_ + steps;
        packed_.improvement->starts = packed_.base ? starts_before_ + 1 : improver.starts();
        packed_.improvement->seconds = seconds();
        tell_(improving(*packed_.improvement, steps, options_.most_steps));
    }

    Stopwatch watch_;
    double seconds_before_ = 0;  // spent by a run that this one goes on from; so are steps
    std::int64_t steps_before_ = 0;
    int starts_before_ = 0;             // on other bases, too
    std::int64_t steps_on_others_ = 0;  // on bases before this one
    bool of_job_ = true;                // the tray is to hold all of the job, and the journal hears of it
    TraysPacker& packer_;
    const PackingJob& job_;
    const ImprovementOptions& options_;
    const TellProgress& tell_;
    TrayObserver* observer_;
    PackedJob& packed_;
    PackingMeasures measures_;
    std::function<double(int)> worth_;
    TrayScore best_;
};

}  // namespace

Progress improving(const Improved& improved, std::int64_t steps, std::int64_t most_steps) {
    const double work = most_steps > 0 ? static_cast<double>(steps) / static_cast<double>(most_steps) : 0;
    Progress progress{Phase::improve, steps, most_steps, std::nullopt, work};
    progress.improved = improved;
    return progress;
}

void improve(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell, TrayObserver* observer,
             PackedJob& packed) {
    if (packed.trays.trays.empty() || options.enough.stopped()) return;
    if (packed.trays.trays.size() > 1) return improve_trays(packer, options, tell, observer, packed);
    Improving(packer, options, tell, observer, packed).run();
}

void lower_tray(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell,
                TrayObserver* observer, PackedJob& packed, int number) {
    Improving(packer, options, tell, observer, packed).run(number);
}

}  // namespace spectralpack
