#include "disassembly/smoothing.hpp"

#include <algorithm>
#include <array>
#include <list>
#include <map>
#include <utility>

#include "disassembly/ways/moves.hpp"

namespace spectralpack {
namespace {

using Members = Subassembly::Members;
using Path = Subassembly::Path;

/// Copies that stand together while steps are made.
struct Company {
    Subassembly standing;
    std::map<int, std::size_t> places;  ///< by name
    std::optional<std::size_t> walls;
};

}  // namespace

Path smoothed(const Subassembly& standing, const Members& members, Path path) {
    const auto free = [&](const Vec3& from, const Vec3& move) { return standing.free_move(members, from, move); };
    return shortened(std::move(path), free);
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
