#include "spectralpack/pack.hpp"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "api/check_options.hpp"
#include "api/check_together.hpp"
#include "api/engine_factory.hpp"
#include "api/file_stamps.hpp"
#include "api/fixed_copies.hpp"
#include "api/grid_choice.hpp"
#include "api/input_hash.hpp"
#include "api/journal/run_journal.hpp"
#include "api/keep_outs.hpp"
#include "api/load.hpp"
#include "api/load_container.hpp"
#include "api/memory_plan.hpp"
#include "api/packing_job.hpp"
#include "api/plan.hpp"
#include "api/plan_packing.hpp"
#include "api/record.hpp"
#include "api/tray_events.hpp"
#include "core/memory_reserve.hpp"
#include "core/remarks.hpp"
#include "core/stopped.hpp"
#include "core/stopwatch.hpp"
#include "packing/improve/improvement.hpp"
#include "packing/job/least_box.hpp"
#include "packing/job/order_search.hpp"
#include "search/verifying_search.hpp"
#include "verify/check.hpp"

namespace spectralpack {
namespace {

/// One run of pack(): puts together what is loaded, planned, searched with, packed by a strategy and recorded.
class JobRun {
  public:
    JobRun(const Job& job, const JournalOptions& journal, Listener& listener, const StopToken& stop)
        : job_(job),
          options_(job.options),
          journal_options_(journal),
          listener_(listener),
          stop_(stop),
          workers_(job.options.threads),
          preparing_(workers_.stopping_with(enough())) {}

    PackResult run() {
        const Stopwatch watch;
        try {
            return load_and_pack(watch);
        } catch (const Stopped&) {
        }
        PackResult nothing;  // stopped before the first copy
        nothing.stopped = enough().reason();
        nothing.packing.options = options_;
        nothing.packing.container = container_;
        nothing.packing.trays.emplace_back();
        nothing.packing.metrics.seconds.total = watch.seconds();
        return nothing;
    }

  private:
    const StopToken& enough() const { return job_.enough_placed ? *job_.enough_placed : stop_; }

    PackResult load_and_pack(const Stopwatch& watch) {
        if (workers_.missing() > 0) {
            listener_.on_warning("only " + std::to_string(workers_.threads()) + " of " +
                                 std::to_string(workers_.threads() + workers_.missing()) +
                                 " threads could be started; it goes on with these");
        }
        load();
        plan_ = choose_grid(loaded_, container_, job_.own_printers, preparing_, options_);
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
        PackingJob packing = packing_job({loaded_, plan_, container_, options_}, listener_, preparing_);
        packing.fill.enough = job_.enough_placed;
        if (!journal_options_.file.empty()) {
            journal_ =
                std::make_unique<RunJournal>(journal_options_, input_facts(loaded_, container_, options_), listener_);
        }
        PackResult result;
        seconds_.load = watch.seconds();

        PackedJob packed;
        bool cut_short = false;
        MemoryReserve reserve(record_memory(loaded_));
        try {
            search(packing, packed);
        } catch (const Stopped&) {  // before a tray was begun
            cut_short = true;
        } catch (const std::bad_alloc&) {
            result.failure = ResourceError("out of memory while placing; what was placed by then is kept");
        } catch (const Error& error) {
            result.failure = error;
        }
        reserve.release();
        TraysResult& trays = packed.trays;
        // Where nothing is placed at all, each copy says why.
        if (trays.stuck && trays.placed() > 0) listener_.on_warning(stuck_text(loaded_, trays));
        if (trays.trays.empty()) trays.trays.emplace_back();  // failed before the first; its packing has one, empty
        if (!packed.copies.empty()) plan_.items = std::move(packed.copies);
        cut_short = cut_short || std::ranges::any_of(trays.trays, &FilledTray::cut_short);
        result.stopped = cut_short && !stop_.stopped() ? enough().reason() : stop_.reason();
        result.packing = recorded(trays, packed);
        stamps_.warn_of_changes(listener_);
        const Stopwatch planning;
        try {
            plan_what_stood_before(result.packing, loaded_.meshes, options_.threads, {&listener_, stop_});
        } catch (const std::bad_alloc&) {
            result.failure = ResourceError("out of memory while planning how copies that stood there before come out");
        }
        result.packing.metrics.seconds.disassemble += planning.seconds();
        if (journal_) {
            result.journal = journal_->use();
            check_what_was_recalled(result);
        }
        result.packing.metrics.seconds.total = watch.seconds();
        result.meshes = std::move(loaded_.meshes);
        result.unusable = std::move(loaded_.unusable);
        return result;
    }

    void load() {
        check_options(options_);
        check_together(job_);
        stamps_ = FileStamps(job_, preparing_);
        container_ = container_of(job_, listener_, enough());
        warn_of_keep_outs(container_, listener_);
        options_.tray = container_.size;
        preparing_.check();
        loaded_ = load_parts(job_, preparing_, listener_);
        require_sound(loaded_, container_, options_, workers_, listener_, enough());
        preparing_.check();
    }

    Packing recorded(const TraysResult& trays, const PackedJob& packed) const {
        return packing_of({loaded_, container_, options_, plan_, job_.defaults, trays, packed.base, seconds_, verified_,
                           packed.orders, packed.improvement},
                          workers_);
    }

    /// A journal is believed as far as its checksums go, its packing only once it has been judged.
    void check_what_was_recalled(PackResult& result) {
        if (result.journal->recalled == 0 || result.failure) return;
        const CheckReport report = check_packing(result.packing, loaded_.meshes, workers_, listener_, {});
        if (report.ok()) return;
        result.failure =
            InternalError("the packing that goes on from " + result.journal->file.string() +
                          " is not sound: " + report.findings.front().message + "; --no-resume begins anew");
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
        TraysPacker packer(job, *engine, workers_, journal_.get());
        packer.tell_of_trays([&](const TraysResult& trays) {
            listener_.on_trays({recorded(trays, packed), loaded_.meshes});
        });
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
        TrayEvents events(packer.job().parts, loaded_, listener_);
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
        if (!improves(options_)) return;
        if (!plan_.keeps_all && packed.trays.trays.size() == 1) {
            listener_.on_warning(
                "--improve needs the voxels of all parts at once, for which there is too little memory; "
                "the first packing stays");
            return;
        }
        const ImprovementOptions improving{options_.goal, options_.improve_steps, options_.seed, stop_,
                                           job_.enough_improved.value_or(enough())};
        improve(packer, improving, tell, &events, packed);
    }

    const Job& job_;
    PackOptions options_;  // as used: with the size of a container mesh and the grid that was chosen
    const JournalOptions& journal_options_;
    std::unique_ptr<RunJournal> journal_;  // null: none is kept
    Container container_;
    Listener& listener_;
    StopToken stop_;
    Workers workers_, preparing_;
    FileStamps stamps_;
    LoadedJob loaded_;
    Plan plan_;
    PhaseSeconds seconds_;
    std::int64_t verified_ = 0;
};

}  // namespace

PackResult pack(const Job& job, const Control& control, const JournalOptions& journal) {
    Listener quiet;
    return JobRun(job, journal, control.listener ? *control.listener : quiet, control.stop).run();
}

}  // namespace spectralpack
