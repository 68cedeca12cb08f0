#include "api/check_together.hpp"

#include <string>

#include "api/check_options.hpp"
#include "api/short_number.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {

void check_together(const Job& job) {
    const PackOptions& options = job.options;
    for (const Part& part : job.parts) {
        if (!(part.scale >= kLeastScale && part.scale <= kMostScale)) {
            throw UsageError("the scale of a part must be from " + short_number(kLeastScale) + " to " +
                             short_number(kMostScale) + ", not " + short_number(part.scale));
        }
    }
    const auto refuse = [](const std::string& what, const std::string& with, const std::string& why) {
        throw UsageError(what + " does not go with " + with + ": " + why);
    };
    if (is_open(options)) {
        const bool box = options.minimise == Minimise::box;
        const std::string open = box ? "--minimise box" : "--open-height";
        if (job.container.mesh || !job.container.keep_out.empty()) {
            refuse(open, "container meshes and keep-outs", "they have a height of their own");
        }
        if (box && (job.onto || job.keep || !job.fixed.empty())) {
            refuse(open, "fixed copies, --onto and --keep", "they stand on a base that is given");
        }
        if (options.trays != 1) refuse(open, "several trays", "without a ceiling one holds all");
        if (job.onto && job.onto->packing.trays.size() > 1) {
            refuse(open, "--onto a build of several trays", "without a ceiling one holds all");
        }
        if (job.keep && job.keep->packing.trays.size() > 1) {
            refuse(open, "--keep of a build of several trays", "without a ceiling one holds all");
        }
        if (job.container.physical && options.interlock != Interlock::off) {
            refuse(open, "--physical",
                   "ways out lead over the top of walls, which have no height then (--interlock off "
                   "does not look for them)");
        }
    }
    if (job.keep && job.onto)
        refuse("--keep", "--onto", "copies of a build either count as asked for, or stand beside it");
    if (job.keep && options.fill) refuse("--keep", "--fill", "shares are counted from an empty tray");
    if (options.fill && options.trays != 1) {
        refuse("--fill", "several trays", "all would be alike; fill one and build it as often as needed");
    }
    if (options.restarts > 1 || options.beam > 1) {
        const std::string orders = options.restarts > 1 ? "--restarts" : "--beam";
        if (options.fill) refuse(orders, "--fill", "the parts' shares decide the order there");
        if (options.minimise == Minimise::box) refuse(orders, "--minimise box", "it tries bases instead");
    }
    if (improves(options)) {
        const std::string improve = options.improve ? "--improve" : "--improve-steps";
        if (options.fill) refuse(improve, "--fill", "what is placed there follows the parts' shares");
        if (options.interlock == Interlock::place) {
            refuse(improve, "--interlock place",
                   "copies are shifted afterwards; --interlock post sees that all come out");
        }
        if (options.improve == 0 && !options.time_limit) {
            throw UsageError(
                "--improve rest uses what --time-limit leaves, and there is none; say how long: --improve 60");
        }
        if (options.improve && options.improve_steps == 0 && !job.enough_improved) {
            throw UsageError("to improve for some time somebody has to hold the clock: Job::enough_improved");
        }
    }
    if (options.beam > 1 && (options.max_density || options.max_layer_fill)) {
        refuse("--beam", options.max_density ? "--max-density" : "--max-layer-fill",
               "it keeps no account of what is full; use --restarts");
    }
}

}  // namespace spectralpack
