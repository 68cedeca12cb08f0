#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "commands.hpp"
#include "default_settings.hpp"
#include "exit_status.hpp"
#include "help_page.hpp"
#include "interrupts.hpp"
#include "pack_arguments.hpp"
#include "passed_over.hpp"
#include "paths.hpp"
#include "printer_list.hpp"
#include "progress_display.hpp"
#include "run_outputs.hpp"
#include "summary.hpp"
#include "tell.hpp"
#include "text.hpp"
#include "time_probe.hpp"
#include "time_shares.hpp"

namespace spectralpack::cli {
namespace {

using Clock = Interrupts::Clock;

std::vector<NamedOutput> outputs_of(const JobSettings& settings) {
    std::vector<NamedOutput> outputs;
    for (const std::string& output : settings.outputs) {
        outputs.push_back({"-o", output});
    }
    for (const std::string& report : settings.reports) {
        outputs.push_back({"--report", report});
    }
    return outputs;
}

void check_files(const JobSettings& settings) {
    for (const std::string& output : settings.outputs) {
        require_output(output);
    }
    for (const std::string& report : settings.reports) {
        if (!is_report_file(report)) {
            throw UsageError(fmt::format("--report {}: a report's name ends in .html or .csv", report));
        }
        require_writable(report, "--report");
    }
    require_apart(outputs_of(settings));
}

/// Trays that can come of it.
std::int64_t most_trays(const Job& job) {
    std::int64_t copies = 0, before = 0;
    for (const Part& part : job.parts) {
        copies += part.count;
    }
    for (const std::optional<Scene>* build : {&job.onto, &job.keep}) {
        if (*build) before = static_cast<std::int64_t>((*build)->packing.trays.size());
    }
    const std::int64_t trays = job.options.trays > 0 ? std::min<std::int64_t>(job.options.trays, copies) : copies;
    return std::max(trays, before);
}

/// Nothing that is read is written over: a part would be lost, or the last build, lying among the parts, packed as one.
void spare_inputs(const Job& job, const JobSettings& settings, const PackArguments& arguments) {
    std::set<std::string> files = mesh_files(job);                 // the build that is topped up may itself be replaced
    files.insert(arguments.parts.begin(), arguments.parts.end());  // set and job files among them
    for (const std::filesystem::path& file : settings_files(arguments)) {
        files.insert(file.string());
    }
    const std::vector<std::string> inputs(files.begin(), files.end());
    const std::vector<NamedOutput> outputs = outputs_of(settings);
    for (const NamedOutput& output : outputs) {
        require_no_input(output.path, output.option, inputs);
    }
    for (const std::string& output : settings.outputs) {
        require_tray_files({"-o", output}, most_trays(job), outputs, inputs);
    }
}

/// The outputs can hold what the parts are called.
void check_names(const Job& job, const JobSettings& settings) {
    for (const std::string& output : settings.outputs) {
        require_nameable(job, output);
    }
    if (settings.json.value_or(false)) require_nameable(job, std::filesystem::current_path() / "packing.json");
}

/// What the command line and the job file ask for, as far as it can be checked before any work: words, endings,
/// folders.
JobSettings settle(const PackArguments& arguments, const JobSettings& file) {
    JobSettings settings = override_settings(file, arguments);
    check_files(settings);
    return settings;
}

/// A dry run packs for this long to see how fast it goes.
constexpr double kProbeSeconds = 3;

int run_estimate(const Job& job, const JobSettings& settings, ProgressDisplay& display, Interrupts& interrupts,
                 bool& unusable) {
    const Clock::time_point start = Clock::now();
    const Estimate planned = estimate(job, {&display, interrupts.token()});
    const std::chrono::duration<double> loading = Clock::now() - start;
    display.finish();
    if (planned.stopped != StopReason::none) {
        tell("Stopped before anything was known.\n");
        return planned.stopped == StopReason::cancelled ? kInterrupted : kDone;
    }
    display.on_unusable(planned.unusable);
    display.end();
    unusable = unusable || !planned.unusable.empty();
    const std::optional<ProbedTime> time =
        probe_time(job, kProbeSeconds, interrupts.trial(kProbePatience * kProbeSeconds + 2 * loading.count()));
    if (settings.json.value_or(false)) {
        const bool known = time && time->packed > 0;
        fmt::print("{}\n", estimate_json(planned, known ? std::optional(time->seconds) : std::nullopt));
    } else {
        fmt::print("{}", estimate_text(planned, job.options, time));
    }
    return interrupts.token().reason() == StopReason::cancelled ? kInterrupted : kDone;
}

/// Where nothing is placed nothing is written, and that is no success.
int status_without_copies(const PackResult& result) {
    return result.stopped == StopReason::cancelled ? kInterrupted : kNothingPlaced;
}

/// From so many seconds on a run is worth a journal that nobody asked for.
constexpr double kWorthAJournal = 10;

JournalOptions journal_options(const PackArguments& arguments, const JobSettings& settings) {
    JournalOptions journal;
    if (arguments.has("resume")) {
        if (arguments.has("journal")) {
            throw UsageError("--resume FILE goes on in that file; --journal asks for another");
        }
        if (arguments.has("no-resume")) throw UsageError("--resume and --no-resume contradict each other");
        journal.file = arguments.text("resume");
        journal.resume = Resume::must;
    } else if (arguments.has("journal")) {
        journal.file = arguments.text("journal");
        require_writable(journal.file.string(), "--journal");
        std::vector<NamedOutput> files = outputs_of(settings);
        files.push_back({"--journal", journal.file.string()});
        require_apart(files);
    } else if (!settings.outputs.empty()) {
        journal.file = settings.outputs.front() + ".journal";
        journal.after = kWorthAJournal;
    }
    if (arguments.has("no-resume")) journal.resume = Resume::never;
    if (arguments.has("keep-journal") && !arguments.has("journal") && !arguments.has("resume")) {
        throw UsageError("--keep-journal keeps the file that --journal or --resume names");
    }
    return journal;
}

/// What is left of the journal once the run is over. One that a signal ended, or a lack of memory, may go on.
void settle_journal(const PackResult& result, bool written, bool keep, ProgressDisplay& display) {
    if (!result.journal || !result.journal->on_disk) return;
    if (result.stopped == StopReason::cancelled || result.failure || !written) {
        display.on_warning(
            fmt::format("the same command goes on from here: {} has what was decided", result.journal->file.string()));
        return;
    }
    if (keep) return;
    std::error_code ignored;
    std::filesystem::remove(result.journal->file, ignored);
}

/// Writes finished trays while others are packed.
class PackDisplay final : public ProgressDisplay {
  public:
    PackDisplay(const JobSettings& settings, Interrupts& interrupts)
        : ProgressDisplay(settings.progress.value_or(ProgressStyle::automatic)),
          improve_(settings.options.improve),
          interrupts_(interrupts),
          outputs_(settings, *this) {}

    /// The time to improve in counts from the first step on.
    void on_progress(const Progress& progress) override {
        if (progress.phase == Phase::improve && improve_ && progress.improved) {
            if (*improve_ > 0) {
                limit_improvement(*improve_ - progress.improved->seconds);
                interrupts_.improve_for(*improve_ - progress.improved->seconds);
            }
            improve_.reset();
        }
        ProgressDisplay::on_progress(progress);
    }

    void on_trays(const Scene& finished) override { outputs_.write_trays(finished); }
    RunOutputs& outputs() { return outputs_; }

  private:
    std::optional<int> improve_;  // seconds that are to be counted still
    Interrupts& interrupts_;
    RunOutputs outputs_;
};

int run_job(const Job& job, const JobSettings& settings, const JournalOptions& journal, RunFacts facts,
            PackDisplay& display, Interrupts& interrupts, Clock::time_point start, bool& unusable) {
    int status = kDone;
    const PackResult result = pack(job, {&display, interrupts.token()}, journal);
    display.on_unusable(result.unusable);
    unusable = unusable || !result.unusable.empty();
    if (result.failure) {
        display.on_error(result.failure->what());
        status = status_of(result.failure->kind());
    }
    const Scene scene{result.packing, result.meshes};
    const bool empty = newly_placed(result.packing) == 0;
    if (empty) {
        if (status == kDone) status = status_without_copies(result);
    } else {
        interrupts.begin_writing();
        if (!display.outputs().write(scene, interrupts.drawing(), facts)) status = kOutOfResources;
    }
    settle_journal(result, status != kOutOfResources, facts.keep_journal, display);
    display.end();
    if (settings.json.value_or(false)) {
        fmt::print("{}\n", packing_json(scene));
    } else {
        facts.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        fmt::print("{}", summary_text(result, facts));
    }
    if (status != kDone) return status;
    if (result.stopped == StopReason::cancelled) return kInterrupted;
    return settings.require_all.value_or(false) && !result.packing.unplaced.empty() ? kLeftOver : kDone;
}

/// Of what cannot be used, as far as it is known before meshes are read.
std::vector<InputError> problems_of(const std::vector<Part>& parts) {
    std::vector<InputError> problems;
    for (const Part& part : parts) {
        if (part.problem) problems.push_back(*part.problem);
    }
    return problems;
}

RunFacts facts_of(const Job& job, const JobSettings& settings, const PackArguments& arguments, const TakenOver& taken) {
    RunFacts facts;
    facts.files_named = !settings.outputs.empty() || !settings.reports.empty();
    facts.taken = taken;
    facts.own_printers = settings.own_printers;
    if (job.onto && job.onto->packing.trays.size() == 1) facts.onto_height = job.onto->packing.trays.front().height;
    facts.keep_journal = arguments.has("keep-journal");
    facts.details = settings.details.value_or(false);
    facts.require_all = settings.require_all.value_or(false);
    facts.skip_unusable = settings.skip_unusable.value_or(false);
    return facts;
}

int run_pack(const PackArguments& arguments) {
    const Clock::time_point start = Clock::now();
    if (arguments.text("printer") == "list") {
        print_printers(default_settings(arguments).own_printers, arguments.has("json"));
        return kDone;
    }
    if (arguments.parts.empty()) {
        tell("{}'spectralpack pack --help' shows the options.\n", pack_help_head());
        return kUsage;
    }
    const JobSettings defaults = default_settings(arguments);
    settle(arguments, defaults);  // so that wrong usage is told before files are looked at
    const ExpandedInputs inputs = expand_inputs(arguments.parts, arguments.text("mesh-dir"), defaults);
    const JobSettings settings = settle(arguments, inputs.job.value_or(defaults));
    const JournalOptions journal = journal_options(arguments, settings);
    Interrupts interrupts(settings.options.time_limit, time_shares(settings), start);
    PackDisplay display(settings, interrupts);
    report_passed_over(inputs, display);
    const std::vector<InputError> problems = problems_of(inputs.parts);
    if (problems.size() == inputs.parts.size()) {
        display.on_unusable(problems);
        tell("Nothing is left to pack.\n");
        if (problems.empty()) return kUsage;
        return settings.skip_unusable.value_or(false) ? kNothingPlaced : kUnusableInput;
    }
    Job job;
    job.parts = inputs.parts;
    job.unit = in_mm(settings.unit.value_or(LengthUnit::mm));
    job.options = settings.options;
    job.fixed = settings.fixed;
    job.own_printers = settings.own_printers;
    job.defaults = settings.defaults;
    job.enough_orders = interrupts.half_placed();
    job.enough_placed = interrupts.placed();
    job.enough_improved = interrupts.improved();
    const TakenOver taken = settle_container(arguments, settings, job);
    for (const std::string& remark : taken.remarks) {
        display.on_warning(remark);
    }
    if (!job.defaults.empty()) display.on_warning("settings: " + origin_text(job.defaults));
    spare_inputs(job, settings, arguments);
    check_names(job, settings);

    bool unusable = false;
    const int status = settings.dry_run.value_or(false)
                           ? run_estimate(job, settings, display, interrupts, unusable)
                           : run_job(job, settings, journal, facts_of(job, settings, arguments, taken), display,
                                     interrupts, start, unusable);
    const bool packed = status == kDone || status == kLeftOver || status == kNothingPlaced;
    if (packed && unusable && !settings.skip_unusable.value_or(false)) {
        return kUnusableInput;
    }
    return status;
}

}  // namespace

Command add_pack_command(CLI::App& app) {
    auto* sub = app.add_subcommand("pack", "Pack parts into trays");
    sub->footer(
        pack_help_head() +
        "A job file brings options of its own; those given on the command line override them.\n"
        "Exit status: 0 done, also with copies left over; 2 wrong usage; 3 a file cannot be used (the rest is\n"
        "packed and written); 4 no memory or disk; 5 copies left over with --require-all; 6 nothing placed, and\n"
        "nothing written; 130 interrupted, the best so far is written (a third signal within one second ends it\n"
        "at once).");
    sub->formatter(std::make_shared<PackHelp>());
    sub->set_help_all_flag("--help-all", "Print this help with all options");
    auto arguments = std::make_shared<PackArguments>();
    add_pack_options(*sub, *arguments);
    return {sub, [arguments] { return run_pack(*arguments); }};
}

}  // namespace spectralpack::cli
