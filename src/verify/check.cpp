#include "verify/check.hpp"

#include <algorithm>
#include <tuple>

#include "verify/box_pairs.hpp"
#include "verify/copies.hpp"
#include "verify/counts.hpp"
#include "verify/figures.hpp"
#include "verify/replay.hpp"
#include "verify/walls.hpp"
#include "verify/words.hpp"

namespace spectralpack {
namespace {

/// Distances below this are rounding: touching.
constexpr double kTouching = 1e-9;  ///< mm

/// Compares the copies of one tray with each other.
class TrayPairs {
  public:
    TrayPairs(const Packing& packing, int tray, const std::vector<JudgedCopy>& copies, const Workers& workers)
        : packing_(packing), tray_(tray), copies_(copies), workers_(workers) {
        for (const JudgedCopy& copy : copies) {
            boxes_.push_back(copy.box);
            widest_gap_ = std::max(widest_gap_, copy.gap);
            all_.add(copy.box);
        }
    }

    /// `tell(done, total)` pairs; false when stopped.
    template <class Tell>
    bool run(const StopToken& stop, Tell tell) {
        // Pairs with boxes farther apart than the widest gap matter only for the least distance, so they come in
        // growing rounds until it is known.
        double from = -1, to = widest_gap_;
        const double farthest = all_.empty() ? 0 : length(all_.size());
        while (compare_all(near_pairs(boxes_, from, to), stop, tell)) {
            if (copies_.size() < 2 || least_ <= to || to >= farthest) return true;
            from = to;
            to = std::max(4 * to, 1.0);
        }
        return false;
    }

    double least() const { return least_; }
    std::int64_t tested() const { return tested_; }
    const std::vector<Finding>& findings() const { return findings_; }

  private:
    template <class Tell>
    bool compare_all(const std::vector<BoxPair>& pairs, const StopToken& stop, Tell tell) {
        // In batches: within one, every pair has the same bound, so that what is compared does not depend on the
        // number of threads. The first are small, since the least distance falls quickly.
        std::vector<Relation> relations;
        std::size_t size = 8;
        for (std::size_t begin = 0; begin < pairs.size(); begin += relations.size()) {
            relations.assign(std::min(size, pairs.size() - begin), {});
            size = std::min<std::size_t>(2 * size, 512);
            const double least = least_;
            workers_.for_each(static_cast<std::int64_t>(relations.size()), [&](std::int64_t k) {
                const auto i = static_cast<std::size_t>(k);
                const BoxPair& pair = pairs[begin + i];
                const double bound = std::max(least, gap_of(pair));
                if (stop.stopped() || pair.distance > bound) {
                    relations[i].distance = bound;
                    return;
                }
                relations[i] = compare(copy(pair.a).posed, copy(pair.b).posed, kCheckTolerance, bound);
            });
            if (stop.stopped()) return false;
            for (std::size_t i = 0; i < relations.size(); ++i) {
                const BoxPair& pair = pairs[begin + i];
                if (pair.distance <= std::max(least, gap_of(pair))) ++tested_;
                judge(pair, relations[i]);
            }
            tell(begin + relations.size(), pairs.size());
        }
        return true;
    }

    void judge(const BoxPair& pair, const Relation& relation) {
        using Kind = Relation::Kind;
        const double distance = relation.distance < kTouching ? 0 : relation.distance;
        least_ = std::min(least_, distance);
        const std::string a = name(pair.a), b = name(pair.b);
        const std::string deep = "at least " + short_number(relation.depth) + " mm deep";
        switch (relation.kind) {
            case Kind::overlap:
                return report(FindingKind::overlap, pair, relation.depth, a + " and " + b + " overlap, " + deep);
            case Kind::a_within_b:
                return report(FindingKind::nested, pair, relation.depth,
                              a + " lies inside the material of " + b + ", " + deep);
            case Kind::b_within_a:
                return report(FindingKind::nested, pair, relation.depth,
                              b + " lies inside the material of " + a + ", " + deep);
            case Kind::apart:
                break;
        }
        const double gap = gap_of(pair);
        if (distance >= gap - kCheckTolerance) return;
        report(FindingKind::gap, pair, gap - distance,
               a + " and " + b + " are " + short_number(distance) + " mm apart, " + short_number(gap - distance) +
                   " mm less than their gap of " + short_number(gap) + " mm");
    }

    void report(FindingKind kind, const BoxPair& pair, double amount, const std::string& message) {
        findings_.push_back({kind,
                             tray_,
                             {copy(pair.a).placement, copy(pair.b).placement},
                             amount,
                             tray_prefix(packing_, tray_) + message});
    }

    const JudgedCopy& copy(std::int32_t i) const { return copies_[static_cast<std::size_t>(i)]; }
    double gap_of(const BoxPair& pair) const { return std::max(copy(pair.a).gap, copy(pair.b).gap); }
    std::string name(std::int32_t i) const {
        const auto& placements = packing_.trays[static_cast<std::size_t>(tray_)].placements;
        return copy_name(packing_, placements[static_cast<std::size_t>(copy(i).placement)]);
    }

    const Packing& packing_;
    const int tray_;
    const std::vector<JudgedCopy>& copies_;
    const Workers& workers_;
    std::vector<Box> boxes_;
    Box all_;
    double widest_gap_ = 0;
    double least_ = Box::kInfinity;  ///< distance found so far
    std::int64_t tested_ = 0;
    std::vector<Finding> findings_;
};

void append(std::vector<Finding>& all, const std::vector<Finding>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// Share of a tray's work that comparing its copies is taken to be where a plan is replayed, too.
constexpr double kComparing = 0.5;

}  // namespace

bool CheckReport::plans_complete() const {
    return std::all_of(plans.begin(), plans.end(),
                       [](const auto& plan) { return plan && plan->complete && plan->ok(); });
}

CheckReport check_packing(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                          const Workers& workers, Listener& listener, const StopToken& stop) {
    CheckReport report;
    append(report.findings, count_findings(packing));
    const auto copies = prepare_copies(packing, meshes, workers, listener, stop);
    report.stopped = !copies;
    std::vector<TrayMeasure> measures;
    const auto trays = copies ? static_cast<int>(packing.trays.size()) : 0;
    std::optional<Walls> walls;
    if (copies) {
        append(report.findings, copies->findings);
        Box all;
        for (const std::vector<JudgedCopy>& tray : copies->by_tray) {
            for (const JudgedCopy& copy : tray) {
                all.add(copy.box);
            }
        }
        walls.emplace(packing, all);
    }
    for (int tray = 0; tray < trays && !report.stopped; ++tray) {
        const std::vector<JudgedCopy>& here = copies->by_tray[static_cast<std::size_t>(tray)];
        const bool has_plan = packing.trays[static_cast<std::size_t>(tray)].disassembly.has_value();
        const double comparing = has_plan ? kComparing : 1;
        const auto tell = [&](std::size_t done, std::size_t total, double from, double share) {
            const double part = from + share * static_cast<double>(done) / static_cast<double>(total);
            listener.on_progress({Phase::check, static_cast<std::int64_t>(done), static_cast<std::int64_t>(total), 0,
                                  kPreparing + (1 - kPreparing) * (tray + part) / trays});
        };
        TrayPairs pairs(packing, tray, here, workers);
        report.stopped =
            !pairs.run(stop, [&](std::size_t done, std::size_t total) { tell(done, total, 0, comparing); });
        append(report.findings, pairs.findings());
        append(report.findings, walls->judge(tray, here, workers, stop));
        report.plans.emplace_back();
        if (has_plan && !report.stopped) {
            const Replay replay =
                replay_plan(packing, tray, here, walls->standing(), workers, stop,
                            [&](std::size_t done, std::size_t total) { tell(done, total, comparing, 1 - comparing); });
            report.stopped = replay.stopped;
            report.plans.back() = replay.report;
            append(report.findings, replay.findings);
        }
        report.pairs_tested += pairs.tested();
        if (here.size() > 1) {
            report.min_gap = std::min(report.min_gap.value_or(Box::kInfinity), pairs.least());
        }
        TrayMeasure measure;
        for (const JudgedCopy& copy : here) {
            measure.volume += copy.volume;
            measure.box.add(copy.box);
        }
        measures.push_back(measure);
        report.density.push_back(measured_density(packing, measure));
    }
    if (!report.stopped) append(report.findings, figure_findings(packing, measures, report.min_gap));
    // Those of plans keep the order of their steps.
    std::stable_sort(report.findings.begin(), report.findings.end(), [](const Finding& a, const Finding& b) {
        const bool plan_a = a.kind == FindingKind::plan, plan_b = b.kind == FindingKind::plan;
        if (a.tray != b.tray || plan_a != plan_b) return std::tie(a.tray, plan_a) < std::tie(b.tray, plan_b);
        return !plan_a && std::tie(a.placements, a.kind) < std::tie(b.placements, b.kind);
    });
    return report;
}

}  // namespace spectralpack
