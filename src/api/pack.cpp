#include "spectralpack/pack.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "api/check_options.hpp"
#include "api/check_together.hpp"
#include "api/engine_factory.hpp"
#include "api/fill_setup.hpp"
#include "api/fixed_copies.hpp"
#include "api/load.hpp"
#include "api/load_container.hpp"
#include "api/memory_plan.hpp"
#include "api/order_measures.hpp"
#include "api/plan.hpp"
#include "api/record.hpp"
#include "core/stopwatch.hpp"
#include "packing/least_box.hpp"
#include "packing/many_trays.hpp"
#include "packing/order_search.hpp"
#include "search/verifying_search.hpp"

namespace spectralpack {
namespace {

/// Parts that are the same mesh at the same size with the same gap and orientations share an id, and so the engines'
/// caches.
std::vector<std::uint64_t> shape_ids(const LoadedJob& loaded, const Plan& plan) {
    std::map<std::tuple<const Mesh*, double, double, const void*>, std::uint64_t> ids;
    std::vector<std::uint64_t> by_part;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const auto key = std::tuple(loaded.meshes[i].get(), loaded.parts[i].to_mm(), loaded.parts[i].gap,
                                    static_cast<const void*>(plan.orientations[i].get()));
        by_part.push_back(ids.emplace(key, ids.size() + 1).first->second);
    }
    return by_part;
}

/// By part, how many of the items have its shape.
std::vector<int> copies_of_shapes(const std::vector<PackItem>& items, const std::vector<std::uint64_t>& shape_ids) {
    std::unordered_map<std::uint64_t, int> copies;
    for (const PackItem& item : items) {
        ++copies[shape_ids[static_cast<std::size_t>(item.part)]];
    }
    std::vector<int> by_part;
    for (const std::uint64_t id : shape_ids) {
        by_part.push_back(copies[id]);
    }
    return by_part;
}

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

/// One run of pack(): the loaded job, its plan, and the packing as it grows.
class PackRun {
  public:
    PackRun(const Job& job, Listener& listener, const StopToken& stop)
        : job_(job), options_(job.options), listener_(listener), stop_(stop), workers_(job.options.threads) {}

    PackResult run() {
        const Stopwatch watch;
        load();
        plan_ = make_plan(loaded_, container_, options_, workers_);
        kept_.resize(loaded_.parts.size());
        require_memory(plan_, loaded_, options_, workers_);
        for (std::size_t i = 0; i < loaded_.parts.size(); ++i) {
            if (!plan_.too_large[i].empty()) {
                listener_.on_warning(loaded_.parts[i].name + " " + plan_.too_large[i]);
            }
        }
        PackResult result;
        seconds_.load = watch.seconds();

        TraysResult trays;
        try {
            search(trays);
        } catch (const std::bad_alloc&) {
            result.failure = ResourceError("out of memory while searching; what was placed is kept");
        } catch (const Error& error) {
            result.failure = error;
        }
        if (trays.stuck) result.failure = stuck_error(loaded_, trays);
        if (trays.trays.empty()) trays.trays.emplace_back();  // failed before the first; its packing has one, empty
        result.stopped = stop_.reason();
        result.packing =
            packing_of({loaded_, container_, options_, plan_, trays, base_, seconds_, verified_, orders_}, workers_);
        result.packing.metrics.seconds.total = watch.seconds();
        result.meshes = std::move(loaded_.meshes);
        result.unusable = std::move(loaded_.unusable);
        return result;
    }

  private:
    void load() {
        check_options(options_);
        check_together(job_);
        container_ = container_of(job_);
        options_.tray = container_.size;
        loaded_ = load_parts(job_, workers_, listener_);
        require_sound(loaded_, container_, options_, workers_, listener_, stop_);
    }

    /// `base`: of the grid, in voxels.
    FillSetup setup_on(const BaseSize& base) const {
        return fill_setup({loaded_, plan_, container_, options_}, base, listener_, workers_);
    }

    void search(TraysResult& trays) {
        const PackOptions& options = options_;
        std::unique_ptr<PlacementSearch> engine = make_engine(plan_.engine, plan_.cache, workers_);
        if (options.verify_with) {
            auto both = std::make_unique<VerifyingSearch>(
                std::move(engine), make_engine(resolve_engine(options.verify_with->engine), 0, workers_),
                VerifyingOptions{options.verify_with->sample, static_cast<std::int64_t>(plan_.items.size()),
                                 options.seed});
            verifying_ = both.get();
            engine = std::move(both);
        }
        const Stopwatch watch;
        const auto finish = [&] {
            seconds_.search = watch.seconds() - seconds_.voxelize - seconds_.refine - untangling_;
            verified_ = verified_so_far();
            verifying_ = nullptr;
        };
        try {
            if (options.minimise == Minimise::box) {
                search_least_box(*engine, trays);
            } else if (options.restarts > 1 || options.beam > 1) {
                search_orders(*engine, trays);
            } else {
                search_on({plan_.grid.x, plan_.grid.y}, *engine, trays);
            }
        } catch (...) {
            finish();
            throw;
        }
        finish();
    }

    std::int64_t verified_so_far() const { return verifying_ ? verifying_->verified() : 0; }

    /// Packs into trays of one size.
    void search_on(const BaseSize& base, PlacementSearch& engine, TraysResult& trays) {
        pack_items(
            plan_.items, setup_on(base), engine, stop_,
            [&](const Progress& progress) { listener_.on_progress(progress); }, trays);
    }

    void pack_items(const std::vector<PackItem>& items, const FillSetup& setup, PlacementSearch& engine,
                    const StopToken& stop, const std::function<void(const Progress&)>& tell, TraysResult& trays) {
        const PackOptions& options = options_;
        TrayFiller filler(
            setup, engine,
            [&](int part) {
                const auto i = static_cast<std::size_t>(part);
                return ScaledPart{scaled_mesh(i), loaded_.parts[i].gap, plan_.orientations[i].get(),
                                  loaded_.parts[i].volume};
            },
            workers_);
        const std::vector<std::uint64_t> ids = shape_ids(loaded_, plan_);
        const std::vector<int> copies = copies_of_shapes(items, ids);
        ShapeStore shapes(
            [&](int part, const Workers& workers) {
                const auto i = static_cast<std::size_t>(part);
                std::shared_ptr<const Shape> shape = kept_[i];
                if (!shape) {
                    Shape made =
                        make_shape(ids[i], *scaled_mesh(i), *plan_.orientations[i], options.voxel, options.detail,
                                   loaded_.parts[i].gap, plan_.gap_classes, workers, plan_.room);
                    made.copies = options.fill ? 0 : copies[i];  // filling goes on as long as there is room
                    shape = std::make_shared<const Shape>(std::move(made));
                    if (keep_shapes_) kept_[i] = shape;
                }
                return shape;
            },
            workers_, plan_.keep, plan_.ahead);
        TraysLimit limit{options.trays, options.try_per_tray};
        if (limit.trays > 0) limit.trays = std::max(limit.trays, filler.trays_with_fixed());
        const double container = volume_of(container_);
        // As measured, a search takes about as long as the faces of the copy's box are large; one that is verified
        // takes as long as the transforms of the reference engine, which are of the tray's size whatever the copy's is.
        const auto effort = [&](const PackItem& item) {
            if (options.verify_with) return 1.0;
            return std::pow(loaded_.box_volume[static_cast<std::size_t>(item.part)], 2.0 / 3);
        };
        std::vector<double> efforts{0};  // of the first so many items
        for (const PackItem& item : items) {
            efforts.push_back(efforts.back() + effort(item));
        }
        double volume = 0, settled_effort = 0;
        std::size_t placed = 0;    // in the tray being filled
        std::int64_t settled = 0;  // in all trays
        std::size_t number = 0;    // of the tray being filled, from 1
        const TrayItemDone item_done = [&](const FilledTray& tray, std::size_t done) {
            if (std::exchange(number, trays.trays.size()) != trays.trays.size()) placed = 0;
            for (; placed < tray.placed.size(); ++placed, ++settled) {
                const PackItem& item = tray.placed[placed].item;
                volume += loaded_.parts[static_cast<std::size_t>(item.part)].volume;
                settled_effort += effort(item);
            }
            std::optional<double> density;
            if (!is_open(options)) density = volume / (container * static_cast<double>(trays.trays.size()));
            // What one tray leaves over the next one tries again.
            const std::int64_t sure = limit.trays == 1 ? static_cast<std::int64_t>(done) : settled;
            // How many copies will fill the tray is not known before.
            const std::int64_t total = options.fill ? sure : static_cast<std::int64_t>(items.size());
            const double work = options.fill ? density.value_or(0)
                                             : (limit.trays == 1 ? efforts[done] : settled_effort) / efforts.back();
            tell({Phase::search, sure, total, density, std::min(work, 1.0), verified_so_far()});
        };
        tell({Phase::search, 0, static_cast<std::int64_t>(items.size()), 0, 0});
        const auto note = [&] {
            seconds_.voxelize += shapes.seconds();
            seconds_.refine += filler.refine_seconds();
            untangling_ += filler.untangle_seconds();
            trays.least_gap = filler.least_gap();
        };
        try {
            if (options.fill) {
                FilledTray& tray = trays.trays.emplace_back();
                filler.fill_in_shares(
                    shares(), shapes, [&](std::size_t done) { item_done(tray, done); }, stop, tray);
            } else {
                fill_trays(items, limit, filler, shapes, item_done, stop, trays);
            }
        } catch (...) {
            note();
            throw;
        }
        note();
    }

    /// Packs on one base after the other and keeps the packing whose own box is least. What a stop cuts short counts
    /// only where there is nothing else.
    void search_least_box(PlacementSearch& engine, TraysResult& best) {
        // One base after the other wants the same voxels; the memory plan has room for so many parts'.
        keep_shapes_ = static_cast<int>(loaded_.parts.size()) <= plan_.held();
        std::optional<BoxScore> least;
        std::int64_t searches = 0;
        const auto count = [&] { best.trays.front().searches = searches; };
        const PackOnBase pack_on = [&](const BaseSize& base) -> std::optional<BoxScore> {
            TraysResult trays;
            try {
                search_on(base, engine, trays);
            } catch (const ResourceError&) {
                if (!least) throw;
                return BoxScore{std::numeric_limits<std::int64_t>::max(), 0};  // too high a packing: not this base
            }
            searches += trays.searches();
            const auto missing = static_cast<std::int64_t>(plan_.items.size()) - trays.placed();
            const bool cut_short = missing > 0 && stop_.stopped();
            Box box;
            for (const PlacedItem& placed : trays.trays.front().placed) {
                const auto i = static_cast<std::size_t>(placed.item.part);
                box.add(bounding_box(transformed(*loaded_.meshes[i], transform_of(loaded_, plan_, placed))));
            }
            const BoxScore score{missing, box.volume()};
            if (!least || (!cut_short && score < *least)) {
                least = score;
                best = std::move(trays);
                base_ = base;
            }
            if (cut_short) return std::nullopt;
            return score;
        };
        double boxes = 0;
        for (const PackItem& item : plan_.items) {
            boxes += loaded_.box_volume[static_cast<std::size_t>(item.part)];
        }
        const int side = std::max(1, static_cast<int>(std::cbrt(boxes) / options_.voxel));
        try {
            search_bases(side, {1, 1}, {plan_.grid.x, plan_.grid.y}, pack_on);
        } catch (...) {
            if (least) count();
            throw;
        }
        count();
    }

    /// Looks for the order that packs best on the grid, then packs in it as asked for. Cut off before all copies were
    /// tried, that is the packing on the grid.
    void search_orders(PlacementSearch& engine, TraysResult& trays) {
        keep_shapes_ = plan_.keeps_all;
        const FillSetup as_asked = setup_on({plan_.grid.x, plan_.grid.y});
        FillSetup on_grid = as_asked;
        on_grid.refine = false;
        on_grid.interlock = Interlock::off;
        // The second engine does not look at beams.
        const bool done_on_grid = !as_asked.refine && as_asked.interlock == Interlock::off && !options_.verify_with;
        const StopToken enough = done_on_grid ? stop_ : job_.enough_orders.value_or(stop_);

        const OrderSearch wanted{options_.restarts, options_.beam, options_.seed, plan_.ranks,
                                 order_measures(loaded_, plan_)};
        const int beam_work = wanted.beam > 1 ? kBeamBranch * wanted.beam : 0;
        const int total_work = wanted.restarts + beam_work + (done_on_grid ? 0 : 1);  // in packings
        int work_done = 0;
        const int orders = wanted.restarts + (wanted.beam > 1 ? 1 : 0);
        int order = 0;  // those done
        const auto tell = [&](Progress progress, int work) {
            progress.work = (work_done + work * progress.work) / total_work;
            progress.order = order + 1;
            progress.orders = orders;
            listener_.on_progress(progress);
        };
        const PackInOrder pack = [&](const std::vector<PackItem>& items, bool beam) -> std::optional<TraysResult> {
            FillSetup setup = on_grid;
            if (beam) {
                setup.beam = BeamSetup{wanted.beam, plan_.ranks,
                                       [&] { return make_engine(plan_.engine, plan_.cache / wanted.beam, workers_); },
                                       wanted.measures};
            }
            const int work = beam ? beam_work : 1;
            TraysResult packed;
            try {
                pack_items(
                    items, setup, engine, enough, [&](const Progress& at) { tell(at, work); }, packed);
            } catch (...) {
                if (order == 0) trays = std::move(packed);
                if (order == 0 || !out_of_memory(std::current_exception())) throw;
                packed = {};
            }
            work_done += work;
            ++order;
            if (packed.trays.empty()) return std::nullopt;
            return packed;
        };
        FoundOrder found = find_order(plan_.items, wanted, pack, enough);
        orders_ = found.packings;
        const std::int64_t searches = found.trays.searches();
        trays = std::move(found.trays);
        if (done_on_grid || stop_.stopped()) return;
        plan_.items = std::move(found.items);
        TraysResult last;
        work_done = total_work - 1;
        order = orders - 1;
        pack_items(
            plan_.items, as_asked, engine, stop_, [&](const Progress& at) { tell(at, 1); }, last);
        last.trays.front().searches += searches;
        if (last.trays.back().untried.empty()) trays = std::move(last);
    }

    /// In the order in which the parts come first.
    std::vector<PartShare> shares() const {
        std::vector<PartShare> shares;
        std::set<int> seen;
        for (const PackItem& item : plan_.items) {
            if (!seen.insert(item.part).second) continue;
            shares.push_back({item.part, loaded_.parts[static_cast<std::size_t>(item.part)].count});
        }
        return shares;
    }

    /// A part's mesh in millimetres, not turned.
    std::shared_ptr<const Mesh> scaled_mesh(std::size_t part) const {
        const double mm = loaded_.parts[part].to_mm();
        if (mm == 1) return loaded_.meshes[part];
        return std::make_shared<const Mesh>(transformed(*loaded_.meshes[part], {mm * Mat3{}, {}}));
    }

    const Job& job_;
    PackOptions options_;  // as used: with the size of a container mesh
    Container container_;
    Listener& listener_;
    StopToken stop_;
    Workers workers_;
    LoadedJob loaded_;
    Plan plan_;
    PhaseSeconds seconds_;
    double untangling_ = 0;                       // seconds, also of trays that were given up
    const VerifyingSearch* verifying_ = nullptr;  // while the search lasts
    std::int64_t verified_ = 0;
    int orders_ = 1;                // packed in, the best being kept
    std::optional<BaseSize> base_;  // of the least box
    bool keep_shapes_ = false;
    std::vector<std::shared_ptr<const Shape>> kept_;  // by part
};

}  // namespace

PackResult pack(const Job& job, const Control& control) {
    Listener quiet;
    return PackRun(job, control.listener ? *control.listener : quiet, control.stop).run();
}

}  // namespace spectralpack
