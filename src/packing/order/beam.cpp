#include "packing/order/beam.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "core/stopped.hpp"

namespace spectralpack {
namespace {

/// What stands where, whichever of a part's copies it is.
using Stand = std::tuple<int, int, int, int, int>;  // part, orientation, position

/// Cost of the copies placed, by their voxels.
struct MeanCost {
    double primary = 0, secondary = 0;
    double voxels = 0;

    bool operator<(const MeanCost& other) const {
        const double mine = primary * other.voxels, others = other.primary * voxels;
        if (mine != others) return mine < others;
        return secondary * other.voxels < other.secondary * voxels;
    }
};

MeanCost with(MeanCost mean, const CostModel& model, const Cost& cost, std::int64_t voxels) {
    const auto size = static_cast<double>(voxels);
    mean.primary += model.height_at == HeightAt::top ? cost.primary * size : cost.primary;
    mean.secondary += static_cast<double>(cost.secondary);
    mean.voxels += size;
    return mean;
}

enum class Fate : char { waiting, placed, left_over };

struct State {
    Tray tray;
    std::unique_ptr<PlacementSearch> engine;
    std::vector<Fate> fates;  // by copy
    std::vector<PlacedCopy> placed;
    std::vector<Stand> stands;  // sorted
    MeanCost cost;

    bool waits_for(std::size_t copy) const { return fates[copy] == Fate::waiting; }
};

/// A copy that a state may place next.
struct Step {
    std::size_t state = 0;  // whose
    std::size_t copy = 0;
    BestPlacement best;
    MeanCost cost;              // after it
    std::vector<Stand> stands;  // the same
};

class Beam {
  public:
    Beam(const BeamOptions& options, const TrayContext& context, const std::vector<Copy>& copies, GreedyResult& result)
        : options_(options), context_(context), copies_(copies), result_(result), released_(copies.size(), false) {}

    void run(Tray& tray, const CopyDone& copy_done) {
        State first{tray, options_.make_engine(), std::vector<Fate>(copies_.size(), Fate::waiting), {}, {}, {}};
        states_.push_back(std::move(first));
        while (!states_.empty() && !stopped_) {
            std::vector<Step> steps;
            for (std::size_t i = 0; i < states_.size() && !stopped_; ++i) {
                if (!look_ahead(i, steps)) finish(states_[i]);
            }
            if (stopped_) break;
            take(best_of(std::move(steps)));
            release();
            if (!states_.empty()) copy_done(done());
        }
        for (State& state : states_) {
            finish(state);  // cut off
        }
        tray = std::move(best_->tray);
        result_.placed = std::move(best_->placed);
        for (std::size_t i = 0; i < copies_.size(); ++i) {
            if (best_->fates[i] == Fate::left_over) result_.left_over.push_back(copies_[i]);
            if (best_->fates[i] == Fate::waiting) result_.untried.push_back(copies_[i]);
        }
    }

  private:
    /// Adds what state i may do next; false where nothing finds a place.
    bool look_ahead(std::size_t i, std::vector<Step>& steps) {
        State& state = states_[i];
        const int branch = std::min(kBeamBranch, options_.width);
        std::set<int> seen;  // parts
        std::optional<int> rank;
        int found = 0;
        for (std::size_t k = 0; k < copies_.size() && found < branch; ++k) {
            const Copy& copy = copies_[k];
            if (!state.waits_for(k) || seen.contains(copy.part)) continue;
            const int of_item = options_.ranks[static_cast<std::size_t>(copy.part)];
            if (rank && of_item != *rank) break;
            const Shape* made = shape_of(k);
            if (!made) return true;
            const Shape& shape = *made;
            const SearchResult answer = find_place(state.tray, *state.engine, context_, copy, shape);
            stopped_ = answer.stopped;
            if (stopped_) return true;
            ++result_.searches;
            if (!answer.best) {
                leave_over(state, copy.part);
                continue;
            }
            rank = of_item;
            seen.insert(copy.part);
            ++found;
            const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(answer.best->index)];
            const VoxelIndex& at = answer.best->position;
            Step step{i, k, *answer.best, with(state.cost, context_.model, answer.best->cost, oriented.solid->count()),
                      state.stands};
            const Stand stand{copy.part, oriented.orientation, at.x, at.y, at.z};
            step.stands.insert(std::upper_bound(step.stands.begin(), step.stands.end(), stand), stand);
            steps.push_back(std::move(step));
        }
        return found > 0;
    }

    /// Null where it was stopped while its voxels were made.
    const Shape* shape_of(std::size_t copy) {
        try {
            return &context_.shapes.at(copy);
        } catch (const Stopped&) {
            stopped_ = true;
            return nullptr;
        }
    }

    void leave_over(State& state, int part) const {
        for (std::size_t k = 0; k < copies_.size(); ++k) {
            if (state.waits_for(k) && copies_[k].part == part) state.fates[k] = Fate::left_over;
        }
    }

    std::vector<Step> best_of(std::vector<Step> steps) const {
        std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.cost < b.cost; });
        std::set<std::vector<Stand>> known;
        std::vector<Step> best;
        for (Step& step : steps) {
            if (static_cast<int>(best.size()) == options_.width) break;
            if (known.insert(step.stands).second) best.push_back(std::move(step));
        }
        return best;
    }

    /// The states after these steps, best first. A state's last step is taken in its own tray.
    void take(std::vector<Step> steps) {
        std::vector<int> to_come(states_.size(), 0);
        for (const Step& step : steps) {
            ++to_come[step.state];
        }
        std::vector<std::unique_ptr<PlacementSearch>> idle;
        for (std::size_t i = 0; i < states_.size(); ++i) {
            if (to_come[i] == 0 && states_[i].engine) idle.push_back(std::move(states_[i].engine));
        }
        std::vector<State> next;
        for (Step& step : steps) {
            State& from = states_[step.state];
            if (--to_come[step.state] == 0) {
                next.push_back(std::move(from));
            } else {
                std::unique_ptr<PlacementSearch> engine;
                if (idle.empty()) {
                    engine = options_.make_engine();
                } else {
                    engine = std::move(idle.back());
                    idle.pop_back();
                }
                next.push_back({from.tray, std::move(engine), from.fates, from.placed, {}, {}});
            }
            place(next.back(), std::move(step));
        }
        states_ = std::move(next);
    }

    void place(State& state, Step step) {
        const Copy& copy = copies_[step.copy];
        const Shape& shape = context_.shapes.at(step.copy);
        Settled settled = context_.settle(copy, shape, step.best);
        const ObjectId object = state.tray.add(std::move(settled.object));
        const int orientation = shape.orientations[static_cast<std::size_t>(step.best.index)].orientation;
        state.placed.push_back({copy, orientation, step.best.position, settled.offset, object, step.best.cost});
        state.fates[step.copy] = Fate::placed;
        state.stands = std::move(step.stands);
        state.cost = step.cost;
    }

    /// Keeps the state if none was better.
    void finish(State& state) {
        const PackingScore score = score_packing(copies_, {&state.placed}, options_.measures);
        if (best_ && !(score < score_)) return;
        score_ = score;
        best_.emplace(std::move(state));
        best_->engine.reset();
    }

    /// Gives back the voxels of copies that no state waits for.
    void release() {
        for (std::size_t k = 0; k < copies_.size(); ++k) {
            if (released_[k]) continue;
            released_[k] =
                std::none_of(states_.begin(), states_.end(), [k](const State& state) { return state.waits_for(k); });
            if (released_[k]) context_.shapes.release(k, false);
        }
    }

    /// Copies that the best state is done with.
    std::size_t done() const {
        const std::vector<Fate>& fates = states_.front().fates;
        return copies_.size() - static_cast<std::size_t>(std::count(fates.begin(), fates.end(), Fate::waiting));
    }

    const BeamOptions& options_;
    const TrayContext& context_;
    const std::vector<Copy>& copies_;
    GreedyResult& result_;
    std::vector<State> states_;
    std::optional<State> best_;  // of those that are done
    PackingScore score_;         // its
    std::vector<bool> released_;
    bool stopped_ = false;
};

}  // namespace

void pack_in_beam(Tray& tray, const BeamOptions& options, const TrayContext& context, const std::vector<Copy>& copies,
                  const CopyDone& copy_done, GreedyResult& result) {
    Beam(options, context, copies, result).run(tray, copy_done);
    if (!context.observer) return;
    for (const PlacedCopy& placed : result.placed) {
        context.observer->copy_placed(placed);
    }
}

}  // namespace spectralpack
