#include "verify/replay.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "verify/sweep.hpp"
#include "verify/words.hpp"

namespace spectralpack {
namespace {

/// Steps between two reports of progress.
constexpr std::size_t kBatch = 32;
/// Copies named in one list.
constexpr std::size_t kMostNames = 12;

bool overlap_along(const Box& a, const Box& b, int axis) {
    return a.max[axis] - b.min[axis] > kCheckTolerance && b.max[axis] - a.min[axis] > kCheckTolerance;
}

/// The boxes overlap deeper than the tolerance.
bool overlap(const Box& a, const Box& b) {
    return overlap_along(a, b, 0) && overlap_along(a, b, 1) && overlap_along(a, b, 2);
}

Box moved(const Box& box, const Vec3& offset) { return {box.min + offset, box.max + offset}; }

/// Whether `a` overlaps `b` deeper than the tolerance somewhere on its way.
bool overlap_on_the_way(const Box& a, const Box& b, const Vec3& move) {
    double begin = 0, end = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double enter = b.min[axis] - a.max[axis] + kCheckTolerance;
        const double leave = b.max[axis] - a.min[axis] - kCheckTolerance;
        const double speed = move[axis];
        if (speed == 0) {
            if (!(enter < 0 && leave > 0)) return false;
            continue;
        }
        begin = std::max(begin, std::min(enter / speed, leave / speed));
        end = std::min(end, std::max(enter / speed, leave / speed));
    }
    return begin < end;
}

/// What one step moves past what.
struct Stage {
    std::size_t step = 0;
    std::vector<const JudgedCopy*> leaving, left;
    bool walls = false;  ///< are in the way, too
};

/// What went wrong in a step.
struct Verdict {
    double depth = 0, travelled = 0;
    const JudgedCopy* leaving = nullptr;
    const JudgedCopy* obstacle = nullptr;  ///< none: nothing was met
    const JudgedCopy* inside = nullptr;    ///< a copy that does not end outside
    double sticking = 0;                   ///< mm that it would have to go on
    std::int64_t sweeps = 0;
};

class PlanReplay {
  public:
    PlanReplay(const Packing& packing, int tray, const std::vector<JudgedCopy>& copies,
               const std::vector<JudgedCopy>& walls)
        : packing_(packing),
          tray_(tray),
          walls_(walls),
          placements_(packing.trays[static_cast<std::size_t>(tray)].placements),
          plan_(*packing.trays[static_cast<std::size_t>(tray)].disassembly),
          copy_of_(placements_.size()),
          subassembly_(placements_.size(), kInTray),
          own_step_(placements_.size()) {
        for (const JudgedCopy& copy : copies) {
            copy_of_[static_cast<std::size_t>(copy.placement)] = &copy;
        }
    }

    Replay run(const Workers& workers, const StopToken& stop,
               const std::function<void(std::size_t, std::size_t)>& tell) {
        const std::size_t count = plan_.steps.size();
        replay_.report.steps = static_cast<std::int64_t>(count);
        replay_.report.unpack = plan_.unpack;
        replay_.report.through_walls = std::ssize(plan_.through_walls);
        for (std::size_t begin = 0; begin < count; begin += kBatch) {
            std::vector<Stage> stages;
            for (std::size_t step = begin; step < std::min(begin + kBatch, count); ++step) {
                if (auto stage = set_stage(step)) stages.push_back(*std::move(stage));
            }
            std::vector<Verdict> verdicts(stages.size());
            workers.for_each(static_cast<std::int64_t>(stages.size()), [&](std::int64_t k) {
                const auto i = static_cast<std::size_t>(k);
                if (!stop.stopped()) verdicts[i] = judge(stages[i]);
            });
            replay_.stopped = stop.stopped();
            if (replay_.stopped) break;
            for (std::size_t i = 0; i < stages.size(); ++i) {
                report(stages[i], verdicts[i]);
            }
            tell(std::min(begin + kBatch, count), count);
        }
        if (!replay_.stopped) {
            judge_coverage();
            sum_up();
        }
        return std::move(replay_);
    }

  private:
    /// Who leaves whom; none where the step cannot be made at all, which is reported.
    std::optional<Stage> set_stage(std::size_t index) {
        const RemovalStep& step = plan_.steps[index];
        if (step.placements.empty()) return impossible(index, "moves nothing");
        for (const int placement : step.placements) {
            const auto i = static_cast<std::size_t>(placement);
            if (placement < 0 || i >= placements_.size()) return impossible(index, "moves a copy that is not there");
            if (stays(i)) return impossible(index, "moves " + name(i) + ", which is fixed");
            if (own_step_[i]) {
                return impossible(index, "takes out " + name(i) + ", which step " + std::to_string(*own_step_[i] + 1) +
                                             " has taken out already");
            }
            if (subassembly_[i] != subassembly_[static_cast<std::size_t>(step.placements[0])]) {
                return impossible(index, "moves copies as one that no longer stand together");
            }
        }
        for (const Vec3& move : step.path) {
            if (!std::isfinite(length(move))) return impossible(index, "moves by what is not a finite number");
        }
        const int subassembly = subassembly_[static_cast<std::size_t>(step.placements[0])];
        const int fresh = static_cast<int>(index) + 1;
        for (const int placement : step.placements) {
            const auto i = static_cast<std::size_t>(placement);
            subassembly_[i] = fresh;
            if (step.placements.size() == 1) own_step_[i] = index;
        }
        Stage stage{index, {}, {}, subassembly == kInTray && between_walls(index)};
        for (std::size_t i = 0; i < placements_.size(); ++i) {
            if (!copy_of_[i]) continue;
            if (subassembly_[i] == fresh) stage.leaving.push_back(copy_of_[i]);
            if (subassembly_[i] == subassembly) stage.left.push_back(copy_of_[i]);
        }
        if (stage.walls) {
            for (const JudgedCopy& wall : walls_) {
                stage.left.push_back(&wall);
            }
        }
        return stage;
    }

    /// What stood there before a build was topped up may leave like the others.
    bool stays(std::size_t i) const { return placements_[i].fixed && !placements_[i].before; }

    bool between_walls(std::size_t step) const {
        if (walls_.empty() || packing_.container.physical) return !walls_.empty();
        return plan_.unpack == Unpack::top &&
               !std::binary_search(plan_.through_walls.begin(), plan_.through_walls.end(), static_cast<int>(step));
    }

    Verdict judge(const Stage& stage) const {
        Verdict verdict;
        Vec3 offset;
        double travelled = 0;
        for (const Vec3& move : plan_.steps[stage.step].path) {
            for (const JudgedCopy* leaving : stage.leaving) {
                const Box box = moved(leaving->box, offset);
                PosedSolid posed = leaving->posed;
                posed.pose.translation = posed.pose.translation + offset;
                for (const JudgedCopy* other : stage.left) {
                    if (!overlap_on_the_way(box, other->box, move)) continue;
                    ++verdict.sweeps;
                    const SweepResult met = sweep(posed, other->posed, move, kCheckTolerance);
                    if (met.depth <= verdict.depth) continue;
                    verdict.depth = met.depth;
                    verdict.travelled = travelled + met.travelled;
                    verdict.leaving = leaving;
                    verdict.obstacle = other;
                }
            }
            offset = offset + move;
            travelled += length(move);
        }
        Box rest;
        for (const JudgedCopy* other : stage.left) {
            rest.add(other->box);
        }
        for (const JudgedCopy* leaving : stage.leaving) {
            const Box end = moved(leaving->box, offset);
            if (rest.empty() || !overlap(end, rest)) continue;
            double least = Box::kInfinity;
            for (int axis = 0; axis < 3; ++axis) {
                least = std::min({least, end.max[axis] - rest.min[axis], rest.max[axis] - end.min[axis]});
            }
            if (least <= verdict.sticking) continue;
            verdict.sticking = least;
            verdict.inside = leaving;
        }
        return verdict;
    }

    void report(const Stage& stage, const Verdict& verdict) {
        replay_.report.sweeps += verdict.sweeps;
        if (verdict.obstacle) {
            std::vector<int> who{verdict.leaving->placement};
            if (!is_wall(verdict.obstacle)) who.push_back(verdict.obstacle->placement);
            find(stage.step, std::move(who), verdict.depth,
                 name(verdict.leaving) + " runs into " + name(verdict.obstacle) + ", at least " +
                     short_number(verdict.depth) + " mm deep, after " + short_number(verdict.travelled) +
                     " mm of its way");
        }
        if (verdict.inside) {
            find(stage.step, {verdict.inside->placement}, verdict.sticking,
                 name(verdict.inside) + " ends inside the bounding box of what is left" +
                     (!stage.walls ? ", " : " and of the container, ") + short_number(verdict.sticking) +
                     " mm from outside");
        }
    }

    void judge_coverage() {
        PlanReport& report = replay_.report;
        for (std::size_t i = 0; i < placements_.size(); ++i) {
            if (own_step_[i]) continue;
            if (!placements_[i].fixed) report.without_step.push_back(static_cast<int>(i));
            if (placements_[i].before) report.staying.push_back(static_cast<int>(i));
        }
        report.complete = plan_.complete && report.without_step.empty();
        if (plan_.complete && !report.complete) {
            replay_.findings.push_back({FindingKind::plan, tray_, report.without_step, 0,
                                        tray_prefix(packing_, tray_) +
                                            "the plan says it is complete, but has no step for " +
                                            names(report.without_step)});
        }
    }

    void sum_up() {
        PlanReport& report = replay_.report;
        report.message = tray_prefix(packing_, tray_) + "plan: " + std::to_string(report.steps) +
                         (report.steps == 1 ? " step replayed, " : " steps replayed, ") +
                         (report.ok() ? "ok" : std::to_string(report.failed_steps.size()) + " failed");
        if (report.through_walls > 0) {
            report.message += "; " + std::to_string(report.through_walls) + " of them sideways through the walls";
        }
        if (!report.staying.empty()) {
            report.message += "; " + std::to_string(report.staying.size()) + " that stood there before stay";
        }
        if (report.complete) return;
        report.message += "; INCOMPLETE";
        if (!report.without_step.empty()) report.message += ": no way out for " + names(report.without_step);
    }

    std::string names(const std::vector<int>& placements) const {
        std::string names;
        for (std::size_t i = 0; i < std::min(placements.size(), kMostNames); ++i) {
            names += (i > 0 ? ", " : "") + name(static_cast<std::size_t>(placements[i]));
        }
        const std::size_t more = placements.size() - std::min(placements.size(), kMostNames);
        return more > 0 ? names + " and " + std::to_string(more) + " more" : names;
    }

    std::optional<Stage> impossible(std::size_t step, const std::string& what) {
        find(step, {}, 0, what);
        return std::nullopt;
    }

    void find(std::size_t step, std::vector<int> placements, double amount, const std::string& what) {
        if (replay_.report.failed_steps.empty() || replay_.report.failed_steps.back() != static_cast<int>(step)) {
            replay_.report.failed_steps.push_back(static_cast<int>(step));
        }
        replay_.findings.push_back({FindingKind::plan, tray_, std::move(placements), amount,
                                    tray_prefix(packing_, tray_) + "plan, step " + std::to_string(step + 1) + " of " +
                                        std::to_string(plan_.steps.size()) + ": " + what});
    }

    std::string name(std::size_t placement) const { return copy_name(packing_, placements_[placement]); }
    std::string name(const JudgedCopy* copy) const {
        return is_wall(copy) ? "the container" : name(static_cast<std::size_t>(copy->placement));
    }
    static bool is_wall(const JudgedCopy* copy) { return copy->placement < 0; }

    static constexpr int kInTray = 0;

    const Packing& packing_;
    const int tray_;
    const std::vector<JudgedCopy>& walls_;
    const std::vector<Placement>& placements_;
    const Disassembly& plan_;
    std::vector<const JudgedCopy*> copy_of_;            ///< by placement; null: not there
    std::vector<int> subassembly_;                      ///< by placement: kInTray, else 1 + the step it left in
    std::vector<std::optional<std::size_t>> own_step_;  ///< by placement: the step that took it out by itself
    Replay replay_;
};

}  // namespace

Replay replay_plan(const Packing& packing, int tray, const std::vector<JudgedCopy>& copies,
                   const std::vector<JudgedCopy>& walls, const Workers& workers, const StopToken& stop,
                   const std::function<void(std::size_t, std::size_t)>& tell) {
    return PlanReplay(packing, tray, copies, walls).run(workers, stop, tell);
}

}  // namespace spectralpack
