#include "packing/improve/fewest_trays.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "core/stopwatch.hpp"

namespace spectralpack {
namespace {

// A copy's key is the logarithm of its volume times its longest side. What ended in the last tray gains so much, what
// ended in the one before a little; noise makes another order of it each time.
constexpr double kOfLast = 0.7, kOfLastButOne = 0.15, kOrderNoise = 0.1;
constexpr double kLeast = 1e-9;
constexpr int kIdle = 4;                // passes without gain: then the last tray becomes lower
constexpr std::int64_t kLowering = 40;  // orders of its copies tried to that end

class FewestTrays {
  public:
    FewestTrays(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell,
                TrayObserver* observer, PackedJob& packed)
        : packer_(packer),
          job_(packer.job()),
          options_(options),
          tell_(tell),
          observer_(observer),
          packed_(packed),
          measures_(measures_of(job_.parts)),
          random_(options.seed) {}

    void run() {
        packed_.improvement = Improved{Improves::trays};
        packed_.improvement->starts = 1;
        packed_.improvement->before = packed_.improvement->now = figure(packed_.trays);
        best_ = score(packed_.trays);
        if (job_.keeps_all) packer_.keep_shapes();
        FillOptions compared = on_grid(job_.fill);
        compared.enough = options_.enough;
        std::int64_t searches = 0;
        tell();
        for (int pass = 0, idle = 0; goes_on(); ++pass) {
            const std::vector<Copy> order = order_of_pass(pass);
            TraysResult layouts;
            packer_.pack({order, compared, options_.enough, [](const Progress&) {}}, layouts);
            searches += layouts.searches();
            if (options_.enough.stopped()) break;
            ++packed_.improvement->steps;
            note_ends(layouts);
            const TraysScore before = best_;
            if (score(layouts) < best_) finish(layouts, order);
            tell();
            idle = best_ < before ? 0 : idle + 1;
            if (idle < kIdle || !job_.keeps_all) continue;
            lower_last(static_cast<std::uint64_t>(pass));
            idle = 0;
        }
        packed_.trays.trays.front().searches += searches;
        tell();
    }

  private:
    bool goes_on() const {
        return !options_.enough.stopped() &&
               (options_.most_steps == 0 || packed_.improvement->steps < options_.most_steps);
    }

    void lower_last(std::uint64_t number) {
        const Improved so_far = *packed_.improvement;
        ImprovementOptions lower = options_;
        lower.most_steps = kLowering;
        if (options_.most_steps > 0) lower.most_steps = std::min(kLowering, options_.most_steps - so_far.steps);
        if (lower.most_steps == 0) return;
        lower.seed += number;
        const TellProgress tell = [&](const Progress& progress) {
            Improved now = so_far;
            now.steps += progress.improved->steps;
            now.seconds = watch_.seconds();
            tell_(improving(now, now.steps, options_.most_steps));
        };
        packed_.improvement.reset();
        lower_tray(packer_, lower, tell, observer_, packed_, static_cast<int>(packed_.trays.trays.size()) - 1);
        const std::int64_t steps = packed_.improvement ? packed_.improvement->steps : 0;
        packed_.improvement = so_far;
        packed_.improvement->steps += steps;
        best_ = score(packed_.trays);
    }

    TraysScore score(const TraysResult& trays) const {
        std::vector<const std::vector<PlacedCopy>*> placed;
        for (const FilledTray& tray : trays.trays) {
            placed.push_back(&tray.placed);
        }
        const PackingScore of_all = score_packing(job_.copies, placed, measures_);
        std::map<int, int> counts;  // of the last tray's copies, by part: equal sums whatever their order
        if (!placed.empty()) {
            for (const PlacedCopy& copy : *placed.back()) {
                ++counts[copy.copy.part];
            }
        }
        double last = 0;
        for (const auto& [part, count] : counts) {
            last += count * std::max(0.0, measures_.volume(part));
        }
        return {of_all.left_over, of_all.trays, last, of_all.top};
    }

    double figure(const TraysResult& trays) const {
        const TraysScore reached = score(trays);
        return static_cast<double>(reached.trays) - 1 + reached.last / volume_of(job_.fill.container);
    }

    /// Copies of the last trays are to go earlier.
    void note_ends(const TraysResult& trays) {
        const std::size_t count = trays.trays.size();
        for (std::size_t t = count < 2 ? 0 : count - 2; t < count; ++t) {
            for (const PlacedCopy& placed : trays.trays[t].placed) {
                boosts_[placed.copy] += t + 1 == count ? kOfLast : kOfLastButOne;
            }
        }
        for (const Copy& copy : trays.left_over) {
            boosts_[copy] += kOfLast;
        }
    }

    /// The first by the keys alone: nothing is known to have ended late.
    std::vector<Copy> order_of_pass(int pass) {
        struct Keyed {
            Copy copy;
            int rank;
            double key;
        };
        std::vector<Keyed> keyed;
        for (const Copy& copy : job_.copies) {
            const auto part = static_cast<std::size_t>(copy.part);
            double key = key_of(copy.part);
            if (pass > 0) {
                const auto boost = boosts_.find(copy);
                key += (boost == boosts_.end() ? 0 : boost->second) + kOrderNoise * (2 * random_.unit() - 1);
            }
            keyed.push_back({copy, job_.ranks[part], key});
        }
        std::ranges::stable_sort(
            keyed, [](const Keyed& a, const Keyed& b) { return a.rank != b.rank ? a.rank < b.rank : a.key > b.key; });
        std::vector<Copy> order;
        for (const Keyed& one : keyed) {
            order.push_back(one.copy);
        }
        return order;
    }

    double key_of(int part) {
        const auto [known, fresh] = keys_.try_emplace(part, 0);
        if (fresh) {
            const JobPart& of = job_.parts[static_cast<std::size_t>(part)];
            const Vec3 size = bounding_box(*of.mesh).size();
            const double longest = of.to_mm * std::max({size.x, size.y, size.z});
            known->second = std::log(std::max(kLeast, of.volume * longest));
        }
        return known->second;
    }

    void finish(const TraysResult& layouts, const std::vector<Copy>& order) {
        FillOptions fill = job_.fill;
        fill.enough = options_.stop;  // what was found is finished, however long it takes
        TraysResult finished;
        packer_.with_filler({fill, options_.stop},
                            [&](TrayFiller& filler) { finish_trays(layouts, order, job_.limit, filler, finished); });
        const bool apart = std::ranges::all_of(
            finished.trays, [](const FilledTray& tray) { return !tray.plan || tray.plan->complete; });
        const TraysScore reached = score(finished);
        if (options_.stop.stopped() || !apart || !(reached < best_)) return;
        const std::size_t told = packed_.trays.trays.size();
        finished.trays.front().searches += packed_.trays.searches();
        packed_.trays = std::move(finished);
        best_ = reached;
        packed_.improvement->now = figure(packed_.trays);
        if (observer_) tell_of(packed_.trays, static_cast<int>(told), *observer_);
    }

    void tell() const {
        packed_.improvement->seconds = watch_.seconds();
        tell_(improving(*packed_.improvement, packed_.improvement->steps, options_.most_steps));
    }

    Stopwatch watch_;
    TraysPacker& packer_;
    const PackingJob& job_;
    const ImprovementOptions& options_;
    const TellProgress& tell_;
    TrayObserver* observer_;
    PackedJob& packed_;
    PackingMeasures measures_;
    RandomStream random_;
    std::map<int, double> keys_;     // by part
    std::map<Copy, double> boosts_;  // of those that ended late
    TraysScore best_;
};

}  // namespace

void improve_trays(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell,
                   TrayObserver* observer, PackedJob& packed) {
    FewestTrays(packer, options, tell, observer, packed).run();
}

}  // namespace spectralpack
