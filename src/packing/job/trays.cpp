#include "packing/job/trays.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "packing/job/tray_choice.hpp"

namespace spectralpack {
std::int64_t TraysResult::searches() const {
    std::int64_t sum = 0;
    for (const FilledTray& tray : trays) {
        sum += tray.searches;
    }
    return sum;
}

std::int64_t TraysResult::placed() const {
    std::size_t sum = 0;
    for (const FilledTray& tray : trays) {
        sum += tray.placed.size();
    }
    return static_cast<std::int64_t>(sum);
}

std::optional<double> TraysResult::least_gap() const {
    std::optional<double> least;
    for (const FilledTray& tray : trays) {
        if (tray.least_gap && *tray.least_gap < least.value_or(Box::kInfinity)) least = tray.least_gap;
    }
    return least;
}

void fill_trays(const std::vector<Copy>& copies, const TraysLimit& limit, TrayFiller& filler,
                const HeightChoice* choice, const TrayCopyDone& copy_done, TraysResult& result,
                const std::function<void()>& next_tray) {
    const StopToken& stop = filler.enough();
    const bool several = limit.trays != 1;
    std::vector<Copy> remaining = copies;
    bool stopped = false;
    do {
        const auto index = result.trays.size();
        if (next_tray && index > 0) {
            result.left_over.clear();  // it is tried again
            next_tray();
        }
        const bool next = limit.trays == 0 || static_cast<int>(index) + 1 < limit.trays;
        const TrayCopies wanted{static_cast<int>(index), remaining, next, next ? limit.try_per_tray : 0, {}};
        FilledTray& tray = result.trays.emplace_back();
        try {
            if (choice) {
                fill_by_choice(*choice, wanted, filler, copy_done, tray);
            } else {
                filler.fill(
                    wanted, [&](std::size_t done) { copy_done(tray, done); }, tray);
            }
        } catch (...) {
            result.left_over = tray.left_over;
            throw;
        }
        const std::set<Copy> placed = copies_in(tray.placed);
        remaining = without(remaining, placed);
        stopped = stop.stopped();
        // What a next tray would have been tried for has not been tried to the end.
        result.left_over = stopped && next ? std::vector<Copy>{} : without(tray.left_over, placed);
        const bool empty = tray.placed.empty() && index >= static_cast<std::size_t>(filler.trays_with_fixed());
        if (several && empty && !remaining.empty() && (!stopped || index > 0)) {
            result.trays.pop_back();
            result.stuck = !stopped;
        }
    } while ((!remaining.empty() || static_cast<int>(result.trays.size()) < filler.trays_with_fixed()) && !stopped &&
             !result.stuck && (limit.trays == 0 || static_cast<int>(result.trays.size()) < limit.trays));
    if (!stopped && !result.stuck) result.left_over = remaining;  // with what is interlocked
}

void finish_trays(const TraysResult& layouts, const std::vector<Copy>& copies, const TraysLimit& limit,
                  TrayFiller& filler, TraysResult& result) {
    std::map<Copy, std::size_t> trays;  // in whose layout a copy is
    for (std::size_t t = 0; t < layouts.trays.size(); ++t) {
        for (const PlacedCopy& placed : layouts.trays[t].placed) {
            trays[placed.copy] = t;
        }
    }
    std::set<Copy> done;
    for (std::size_t t = 0; t < layouts.trays.size(); ++t) {
        const bool last = t + 1 == layouts.trays.size();
        TrayCopies wanted{static_cast<int>(t), {}, !last, 0, layouts.trays[t].height_at, {}};
        for (const Copy& copy : copies) {
            const auto known = trays.find(copy);
            const bool here = known == trays.end() ? last : known->second <= t;
            if (here && !done.contains(copy)) wanted.copies.push_back(copy);
        }
        FilledTray& tray = result.trays.emplace_back();
        filler.finish(wanted, layouts.trays[t].placed, false, tray);
        done.merge(copies_in(tray.placed));
    }
    const std::vector<Copy> rest = without(copies, done);
    const bool more = limit.trays == 0 || static_cast<int>(result.trays.size()) < limit.trays;
    result.left_over = rest;
    if (rest.empty() || !more || filler.enough().stopped()) return;
    fill_trays(
        rest, limit, filler, nullptr, [](const FilledTray&, std::size_t) {}, result);
}

void tell_of(const TraysResult& result, int told, TrayObserver& observer) {
    const int trays = static_cast<int>(result.trays.size());
    for (int number = 0; number < std::max(trays, told); ++number) {
        tell_anew(observer, number,
                  number < trays ? result.trays[static_cast<std::size_t>(number)].placed : std::vector<PlacedCopy>{});
        observer.tray_finished();
    }
}

}  // namespace spectralpack
