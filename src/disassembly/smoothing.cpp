#include "disassembly/smoothing.hpp"

#include <algorithm>
#include <array>
#include <list>
#include <map>
#include <numeric>
#include <utility>

#include "disassembly/ways/moves.hpp"

namespace spectralpack {
namespace {

// Corners that are left out at once, at most: more take long, and seldom go.
constexpr std::size_t kLongestCut = 8;

using Members = Subassembly::Members;
using Path = Subassembly::Path;

/// Copies that stand together while steps are made.
struct Company {
    Subassembly standing;
    std::map<int, std::size_t> places;  ///< by name
    std::optional<std::size_t> walls;
};

/// Makes a way shorter, move by move.
class Smoothing {
  public:
    Smoothing(const Subassembly& standing, const Members& members, Path path)
        : standing_(standing), members_(members), path_(std::move(path)) {}

    Path run() {
        while (path_.size() > 1 && (go_straight_out() || take_a_short_cut())) {
        }
        return std::move(path_);
    }

  private:
    Vec3 place(std::size_t corner) const {
        return std::accumulate(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(corner), Vec3{});
    }

    /// From the first corner that one can leave straight from.
    bool go_straight_out() {
        std::array<Subassembly::Hints, BlockingGraph::kDirections> hints;  // who was in the way, likely still is
        for (std::size_t k = 0; k + 1 < path_.size(); ++k) {
            for (int d = 0; d < BlockingGraph::kDirections; ++d) {
                const Subassembly::Straight way =
                    standing_.straight_way(members_, place(k), BlockingGraph::direction(d), hints[d]);
                if (way.met) {
                    hints[d].first = way.met->other;
                    continue;
                }
                path_.resize(k);
                path_.insert(path_.end(), way.path.begin(), way.path.end());
                path_ = merged(path_);
                return true;
            }
        }
        return false;
    }

    /// Between two corners: axis by axis, in fewer moves.
    bool take_a_short_cut() {
        for (std::size_t k = 0; k + 1 < path_.size(); ++k) {
            for (std::size_t next = std::min(path_.size(), k + kLongestCut); next > k + 1; --next) {
                if (const std::optional<Path> leg = leg_between(k, next)) {
                    Path shorter(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(k));
                    shorter.insert(shorter.end(), leg->begin(), leg->end());
                    shorter.insert(shorter.end(), path_.begin() + static_cast<std::ptrdiff_t>(next), path_.end());
                    path_ = merged(shorter);
                    return true;
                }
            }
        }
        return false;
    }

    std::optional<Path> leg_between(std::size_t from, std::size_t to) const {
        const Vec3 start = place(from), way = place(to) - start;
        std::vector<int> axes;
        for (int axis = 0; axis < 3; ++axis) {
            if (way[axis] != 0) axes.push_back(axis);
        }
        if (axes.size() >= to - from) return std::nullopt;
        do {
            Path leg;
            for (const int axis : axes) {
                leg.emplace_back();
                leg.back()[axis] = way[axis];
            }
            if (standing_.free_path(members_, start, leg)) return leg;
        } while (std::ranges::next_permutation(axes).found);
        return std::nullopt;
    }

    const Subassembly& standing_;
    const Members& members_;
    Path path_;
};

}  // namespace

Path smoothed(const Subassembly& standing, const Members& members, Path path) {
    return Smoothing(standing, members, std::move(path)).run();
}

void smooth(const DisassemblyOptions& options, const std::vector<Body>& bodies, std::optional<std::size_t> walls,
            Disassembly& plan) {
    const auto winding = [](const RemovalStep& step) { return step.path.size() > 2; };
    if (std::ranges::none_of(plan.steps, winding)) return;
    std::vector<int> names(bodies.size());
    std::map<int, std::size_t> places;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        names[i] = static_cast<int>(i);
        places.emplace(names[i], i);
    }
    std::list<Company> companies;
    companies.push_back({Subassembly::closed(options, std::move(names), bodies), std::move(places), walls});
    std::vector<Company*> of(bodies.size(), &companies.front());
    auto through = plan.through_walls.begin();
    for (std::size_t k = 0; k < plan.steps.size() && !options.stop.stopped(); ++k) {
        RemovalStep& step = plan.steps[k];
        Company& company = *of[static_cast<std::size_t>(step.placements.front())];
        const bool gives_way = through != plan.through_walls.end() && std::cmp_equal(*through, k);
        if (gives_way) ++through;
        Members members;
        for (const int name : step.placements) {
            members.push_back(company.places.at(name));
        }
        std::sort(members.begin(), members.end());
        if (winding(step)) {
            company.standing.set_aside(gives_way ? company.walls : std::nullopt);
            step.path = smoothed(company.standing, members, std::move(step.path));
        }
        if (members.size() > 1) {
            companies.push_back({Subassembly(company.standing, members), {}, {}});
            for (std::size_t i = 0; i < members.size(); ++i) {
                const int name = company.standing.name(members[i]);
                companies.back().places.emplace(name, i);
                of[static_cast<std::size_t>(name)] = &companies.back();
            }
        }
        for (const std::size_t i : members) {
            company.standing.remove(i);
        }
    }
}

}  // namespace spectralpack
