#include "packing/job/order_search.hpp"

#include <exception>
#include <new>
#include <set>
#include <utility>

#include "core/random.hpp"
#include "packing/interlocking/unlinked_search.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// The best of several packings of the same copies.
class Best {
  public:
    Best(const std::vector<Copy>& copies, const PackingMeasures& measures) : copies_(copies), measures_(measures) {}

    /// `order`: what `trays` were packed in.
    void consider(const std::vector<Copy>& order, TraysResult trays) {
        searches_ += trays.searches();
        ++packings_;
        std::vector<const std::vector<PlacedCopy>*> placed;
        for (const FilledTray& tray : trays.trays) {
            placed.push_back(&tray.placed);
        }
        const PackingScore score = score_packing(copies_, placed, measures_);
        if (packings_ > 1 && !(score < score_)) return;
        score_ = score;
        order_ = order;
        trays_ = std::move(trays);
    }

    FoundOrder found() && {
        FoundOrder found;
        std::set<Copy> placed;
        for (const FilledTray& tray : trays_.trays) {
            for (const PlacedCopy& copy : tray.placed) {
                found.copies.push_back(copy.copy);
                placed.insert(copy.copy);
            }
        }
        const std::vector<Copy> rest = without(order_, placed);
        found.copies.insert(found.copies.end(), rest.begin(), rest.end());
        if (!trays_.trays.empty()) trays_.trays.front().searches += searches_ - trays_.searches();
        found.trays = std::move(trays_);
        found.packings = packings_;
        return found;
    }

  private:
    const std::vector<Copy>& copies_;
    const PackingMeasures& measures_;
    std::vector<Copy> order_;
    TraysResult trays_;
    PackingScore score_;
    std::int64_t searches_ = 0;
    int packings_ = 0;
};

/// True where `failure` is a lack of memory, also to let a packing grow higher.
bool out_of_memory(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const ResourceError&) {
        return true;
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

/// Tells of all packings as of one.
class OrdersProgress {
  public:
    /// `work`: in packings, of all.
    OrdersProgress(int orders, int work, const TellProgress& tell) : orders_(orders), work_(work), tell_(tell) {}

    /// For a packing that is as much work as so many.
    TellProgress of(int work) const {
        return [this, work](Progress progress) {
            progress.work = (work_done_ + work * progress.work) / work_;
            progress.order = order_ + 1;
            progress.orders = orders_;
            tell_(progress);
        };
    }
    bool first() const { return order_ == 0; }
    void order_done(int work) {
        work_done_ += work;
        ++order_;
    }
    /// The last packing is that of an order that was packed in before.
    void last() {
        work_done_ = work_ - 1;
        order_ = orders_ - 1;
    }

  private:
    int orders_, work_;
    const TellProgress& tell_;
    int work_done_ = 0, order_ = 0;
};

}  // namespace

FoundOrder find_order(const std::vector<Copy>& copies, const OrderSearchOptions& search, const PackInOrder& pack,
                      const StopToken& stop) {
    Best best(copies, search.measures);
    const auto attempt = [&](const std::vector<Copy>& order, bool beam) {
        std::optional<TraysResult> trays = pack(order, beam);
        if (trays) best.consider(order, std::move(*trays));
    };
    attempt(copies, false);
    if (search.beam > 1 && !stop.stopped()) attempt(copies, true);
    RandomStream random(search.seed);
    for (int i = 1; i < search.restarts && !stop.stopped(); ++i) {
        attempt(perturbed(copies, search.ranks, random), false);
    }
    return std::move(best).found();
}

void pack_in_best_order(TraysPacker& packer, const BestOrderOptions& options, const TellProgress& tell,
                        TrayObserver* observer, PackedJob& packed) {
    const PackingJob& job = packer.job();
    if (job.keeps_all) packer.keep_shapes();
    FillOptions compared = on_grid(job.fill);
    // What can be reached is not looked at on the grid: that takes long. So all is packed once more in the end.
    const bool packs_anew = job.fill.interlock == Interlock::place || job.verified;
    if (job.fill.interlock == Interlock::place) compared.interlock = Interlock::off;
    // The second engine does not look at beams.
    const bool done_on_grid = !job.fill.refine && job.fill.interlock == Interlock::off && !job.verified;
    const StopToken placing = job.fill.enough.value_or(options.stop);
    const StopToken enough = done_on_grid ? placing : options.enough;
    compared.enough = enough;

    const OrderSearchOptions wanted{options.restarts, options.beam, options.seed, job.ranks, measures_of(job.parts)};
    const bool by_beam = wanted.beam > 1;
    const int beam_work = by_beam ? kBeamBranch * wanted.beam : 0;
    OrdersProgress progress(wanted.restarts + (by_beam ? 1 : 0), wanted.restarts + beam_work + (done_on_grid ? 0 : 1),
                            tell);
    const auto keep = [&](TraysResult trays, std::size_t told) {
        packed.trays = std::move(trays);
        if (observer) tell_of(packed.trays, static_cast<int>(told), *observer);
    };
    const bool avoids_links = compared.interlock == Interlock::post && compared.links == Links::avoid;
    const auto make_engine = [&] {
        std::unique_ptr<PlacementSearch> engine = options.make_engine(wanted.beam);
        return avoids_links ? make_unlinked_search(std::move(engine)) : std::move(engine);
    };
    const PackInOrder pack = [&](const std::vector<Copy>& copies, bool beam) -> std::optional<TraysResult> {
        FillOptions fill = compared;
        if (beam) {
            fill.beam = BeamOptions{wanted.beam, job.ranks, make_engine, wanted.measures};
        }
        const int work = beam ? beam_work : 1;
        TraysResult trays;
        try {
            packer.pack({copies, fill, enough, progress.of(work)}, trays);
        } catch (...) {
            if (progress.first()) keep(std::move(trays), 0);
            if (progress.first() || !out_of_memory(std::current_exception())) throw;
            trays = {};
        }
        progress.order_done(work);
        if (trays.trays.empty()) return std::nullopt;
        return trays;
    };
    FoundOrder found = find_order(job.copies, wanted, pack, enough);
    packed.orders = found.packings;
    const std::int64_t searches = found.trays.searches();
    if (done_on_grid || placing.stopped()) return keep(std::move(found.trays), 0);
    packed.copies = std::move(found.copies);
    TraysResult last;
    progress.last();
    try {
        if (packs_anew) {
            packer.pack({packed.copies, job.fill, options.stop, progress.of(1), observer}, last);
        } else {
            packer.with_filler({job.fill, options.stop, observer, true}, [&](TrayFiller& filler) {
                finish_trays(found.trays, packed.copies, job.limit, filler, last);
            });
        }
    } catch (...) {
        keep(std::move(found.trays), last.trays.size());
        throw;
    }
    // Cut short, it holds fewer copies than the one found, but these are known to come apart.
    const bool comes_apart = job.fill.interlock != Interlock::off && !options.stop.stopped() && last.placed() > 0;
    if (!last.trays.back().untried.empty() && !comes_apart) return keep(std::move(found.trays), last.trays.size());
    last.trays.front().searches += searches;
    packed.trays = std::move(last);
}

}  // namespace spectralpack
