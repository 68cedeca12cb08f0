#include "spectralpack/pack.hpp"

#include <memory>
#include <new>
#include <utility>

#include "api/check_options.hpp"
#include "api/check_together.hpp"
#include "api/engine_factory.hpp"
#include "api/fixed_copies.hpp"
#include "api/keep_outs.hpp"
#include "api/load.hpp"
#include "api/load_container.hpp"
#include "api/memory_plan.hpp"
#include "api/packing_job.hpp"
#include "api/plan.hpp"
#include "api/plan_packing.hpp"
#include "api/record.hpp"
#include "api/tray_events.hpp"
#include "core/remarks.hpp"
#include "core/stopwatch.hpp"
#include "packing/job/least_box.hpp"
#include "packing/job/order_search.hpp"
#include "search/verifying_search.hpp"

namespace spectralpack {
namespace {

/// One run of pack(): puts together what is loaded, planned, searched with, packed by a strategy and recorded.
class JobRun {
  public:
    JobRun(const Job& job, Listener& listener, const StopToken& stop)
        : job_(job), options_(job.options), listener_(listener), stop_(stop), workers_(job.options.threads) {}

    PackResult run() {
        const Stopwatch watch;
        load();
        plan_ = make_plan(loaded_, container_, options_, job_.own_printers, workers_);
        require_memory(plan_, loaded_, options_, workers_);
        Remarks too_large;
        for (std::size_t i = 0; i < loaded_.parts.size(); ++i) {
            if (plan_.too_large[i].empty()) continue;
            too_large.add(loaded_.parts[i].name,
                          {"is larger than the tray: " + plan_.too_large[i], "are larger than the tray"});
        }
        for (const std::string& text : too_large.texts()) {
            listener_.on_warning(text);
        }
        warn_of_orientations(plan_, options_, listener_);
        PackingJob packing = packing_job({loaded_, plan_, container_, options_}, listener_, workers_);
        PackResult result;
        seconds_.load = watch.seconds();

        PackedJob packed;
        try {
            search(packing, packed);
        } catch (const std::bad_alloc&) {
            result.failure = ResourceError("out of memory while placing; what was placed by then is kept");
        } catch (const Error& error) {
            result.failure = error;
        }
        TraysResult& trays = packed.trays;
        // Where nothing is placed at all, each copy says why.
        if (trays.stuck && trays.placed() > 0) result.failure = stuck_error(loaded_, trays);
        if (trays.trays.empty()) trays.trays.emplace_back();  // failed before the first; its packing has one, empty
        if (!packed.copies.empty()) plan_.items = std::move(packed.copies);
        result.stopped = stop_.reason();
        result.packing = packing_of({loaded_, container_, options_, plan_, job_.defaults, trays, packed.base, seconds_,
                                     verified_, packed.orders},
                                    workers_);
        const Stopwatch planning;
        try {
            plan_what_stood_before(result.packing, loaded_.meshes, options_.threads, {&listener_, stop_});
        } catch (const std::bad_alloc&) {
            result.failure = ResourceError("out of memory while planning how copies that stood there before come out");
        }
        result.packing.metrics.seconds.disassemble += planning.seconds();
        result.packing.metrics.seconds.total = watch.seconds();
        result.meshes = std::move(loaded_.meshes);
        result.unusable = std::move(loaded_.unusable);
        return result;
    }

  private:
    void load() {
        check_options(options_);
        check_together(job_);
        container_ = container_of(job_, listener_);
        warn_of_keep_outs(container_, listener_);
        options_.tray = container_.size;
        loaded_ = load_parts(job_, workers_, listener_);
        require_sound(loaded_, container_, options_, workers_, listener_, stop_);
    }

    void search(PackingJob& job, PackedJob& packed) {
        std::unique_ptr<PlacementSearch> engine = make_engine(plan_.engine, plan_.cache, workers_);
        const VerifyingSearch* verifying = nullptr;
        if (options_.verify_with) {
            auto both = std::make_unique<VerifyingSearch>(
                std::move(engine), make_engine(resolve_engine(options_.verify_with->engine), 0, workers_),
                VerifyingOptions{options_.verify_with->sample, static_cast<std::int64_t>(plan_.items.size()),
                                 options_.seed});
            verifying = both.get();
            engine = std::move(both);
        }
        const Stopwatch watch;
        if (verifying) job.verified = [verifying] { return verifying->verified(); };
        TraysPacker packer(job, *engine, workers_);
        const auto finish = [&] {
            seconds_.voxelize = packer.seconds().voxelize;
            seconds_.refine = packer.seconds().refine;
            seconds_.search = watch.seconds() - seconds_.voxelize - seconds_.refine - packer.seconds().untangle;
            if (verifying) verified_ = verifying->verified();
        };
        try {
            pack(packer, packed);
        } catch (...) {
            finish();
            throw;
        }
        finish();
    }

    void pack(TraysPacker& packer, PackedJob& packed) {
        const TellProgress tell = [&](const Progress& progress) { listener_.on_progress(progress); };
        TrayEvents events(packer.job().parts, listener_);
        if (options_.minimise == Minimise::box) {
            pack_in_least_box(packer, {plan_.grid.x, plan_.grid.y}, stop_, tell, &events, packed);
        } else if (options_.restarts > 1 || options_.beam > 1) {
            const BestOrderOptions orders{
                options_.restarts,
                options_.beam,
                options_.seed,
                stop_,
                job_.enough_orders.value_or(stop_),
                [&](int states) { return make_engine(plan_.engine, plan_.cache / states, workers_); }};
            pack_in_best_order(packer, orders, tell, &events, packed);
        } else {
            packer.pack({packer.job().copies, packer.job().fill, stop_, tell, &events}, packed.trays);
        }
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
    std::int64_t verified_ = 0;
};

}  // namespace

PackResult pack(const Job& job, const Control& control) {
    Listener quiet;
    return JobRun(job, control.listener ? *control.listener : quiet, control.stop).run();
}

}  // namespace spectralpack
